"""The colour bar in one 3D view, also in pictures that are saved of it."""

from pivy import coin

from .colour_bar import bar_image
from .free_area import free_area
from .qt import QtCore, upside_down


class ColourBarNode:
    """A colour bar that lies over a scene, at its left edge, and is no part of what is fitted or picked.

    Parameters
    ----------
    view : View3DInventorPy

    Notes
    -----
    A camera of its own would be simpler, but Coin would then pick along that one's line of sight in all that
    follows in the scene.
    """

    def __init__(self, view):
        self._root = root = view.getSceneGraph()
        self._widget = view.graphicsView().viewport()
        self._content = self._size = None
        # FreeCAD's own kind of group: what is in it is not what 'fit all' fits.
        self.node = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
        self.node.set("mode EXCLUDE_BBOX")
        over, unpicked = coin.SoAnnotation(), coin.SoPickStyle()
        unpicked.style = coin.SoPickStyle.UNPICKABLE
        fit = coin.SoCallback()
        self._fit = self._fit_to_view  # pivy does not keep it alive
        fit.setCallback(self._fit)
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        self._place, self._image = coin.SoTranslation(), coin.SoImage()
        self._place.enableNotify(False)  # it is set while being drawn, which is no reason to draw again
        self._image.vertAlignment = coin.SoImage.HALF
        self._image.horAlignment = coin.SoImage.LEFT
        # All within the annotation: what follows the bar in the scene must not get any of it.
        for node in (unpicked, fit, light, self._place, self._image):
            over.addChild(node)
        self.node.addChild(over)
        root.addChild(self.node)

    def is_in(self, root):
        """Whether this is the bar of a view with that scene graph."""
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
        """Draw one to one at the size of what is rendered: that of a saved picture is not the window's."""
        if self._content is None or not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            return
        state = action.getState()
        # By index: what getValue() returns is a bare pointer in newer versions of pivy.
        size = coin.SoViewportRegionElement.get(state).getViewportSizePixels()
        width, height = size[0], size[1]
        if not width or not height:
            return
        free = self._free_area(width, height)
        if (free.width(), free.height()) != self._size:
            self._size = free.width(), free.height()
            # No larger than a narrow picture allows.
            image = bar_image(self._content, min(free.height(), round(1.2 * free.width())))
            size = coin.SbVec2s(image.width(), image.height())
            self._image.image.setValue(size, 4, bytes(upside_down(image).constBits()))
        seen = coin.SoViewVolumeElement.get(state)
        left = free.left() + max(4, round(0.012 * height)) + 0.5
        middle = 1.0 - (free.top() + 0.5 * free.height()) / height
        depth = seen.getNearDist() + 0.5 * seen.getDepth()
        self._place.translation = seen.getPlanePoint(depth, coin.SbVec2f(left / width, middle))

    def _free_area(self, width, height):
        """QRect of the pixels over which no dock of FreeCAD's lies; all of a picture that is saved."""
        whole = QtCore.QRect(0, 0, width, height)
        try:
            ratio = self._widget.devicePixelRatioF()
            if (round(self._widget.width() * ratio), round(self._widget.height() * ratio)) != (width, height):
                return whole
            free = free_area(self._widget)
        except RuntimeError:
            return whole  # the view is being closed
        return QtCore.QRect(*(round(ratio * each) for each in (
            free.left(), free.top(), free.width(), free.height())))
