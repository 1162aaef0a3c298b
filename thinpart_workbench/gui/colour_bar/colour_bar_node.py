"""The colour bar of one 3D view; saved images show it too."""

from pivy import coin

from ..application.qt import QtCore, flipped_vertically
from ..document.free_area import free_area
from .colour_bar import bar_image


class ColourBarNode:
    """A colour bar at the left edge of a view, drawn over the scene; "fit all" and picking ignore it.

    Parameters
    ----------
    view : View3DInventorPy

    Notes
    -----
    A separate camera would be simpler, but Coin would then pick along its line of sight in every node that
    follows in the scene.
    """

    def __init__(self, view):
        self._root = root = view.getSceneGraph()
        self._widget = view.graphicsView().viewport()
        self._content = self._size = None
        # A group class of FreeCAD: 'fit all' ignores its children.
        self.node = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
        self.node.set("mode EXCLUDE_BBOX")
        annotation, unpicked = coin.SoAnnotation(), coin.SoPickStyle()
        unpicked.style = coin.SoPickStyle.UNPICKABLE
        fit = coin.SoCallback()
        self._fit = self._fit_to_view  # pivy does not hold a reference to it
        fit.setCallback(self._fit)
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        self._translation, self._image = coin.SoTranslation(), coin.SoImage()
        self._translation.enableNotify(False)  # set during rendering, which must not trigger another rendering
        self._image.vertAlignment = coin.SoImage.HALF
        self._image.horAlignment = coin.SoImage.LEFT
        # All inside the annotation, so that none of it affects the nodes after the bar.
        for node in (unpicked, fit, light, self._translation, self._image):
            annotation.addChild(node)
        self.node.addChild(annotation)
        root.insertChild(self.node, 0)  # before FreeCAD's clipping plane, which cuts all that follows

    def is_in(self, root):
        """Whether the bar belongs to the view with this scene graph."""
        return root.findChild(self.node) >= 0

    def show(self, content):
        """Show a BarContent."""
        if content != self._content:
            self._content, self._size = content, None
            self.node.touch()

    def remove(self):
        """Take the bar out of the view."""
        self._root.removeChild(self.node)

    def _fit_to_view(self, _data, action):
        """Draw at the resolution being rendered: a saved image has another size than the window."""
        if self._content is None or not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            return
        state = action.getState()
        # By index: getValue() returns a bare pointer in newer versions of pivy.
        size = coin.SoViewportRegionElement.get(state).getViewportSizePixels()
        width, height = size[0], size[1]
        if not width or not height:
            return
        free = self._free_area(width, height)
        if (free.width(), free.height()) != self._size:
            self._size = free.width(), free.height()
            # A narrow image limits the size of the bar.
            image = bar_image(self._content, min(free.height(), round(1.2 * free.width())))
            size = coin.SbVec2s(image.width(), image.height())
            self._image.image.setValue(size, 4, bytes(flipped_vertically(image).constBits()))
        volume = coin.SoViewVolumeElement.get(state)
        left = free.left() + max(4, round(0.012 * height)) + 0.5
        middle = 1.0 - (free.top() + 0.5 * free.height()) / height
        depth = volume.getNearDist() + 0.5 * volume.getDepth()
        self._translation.translation = volume.getPlanePoint(depth, coin.SbVec2f(left / width, middle))

    def _free_area(self, width, height):
        """QRect of the pixels that no dock covers; all pixels when an image is saved."""
        full = QtCore.QRect(0, 0, width, height)
        try:
            ratio = self._widget.devicePixelRatioF()
            if (round(self._widget.width() * ratio), round(self._widget.height() * ratio)) != (width, height):
                return full
            free = free_area(self._widget)
        except RuntimeError:
            return full  # the view is being closed
        return QtCore.QRect(*(round(ratio * length) for length in (
            free.left(), free.top(), free.width(), free.height())))
