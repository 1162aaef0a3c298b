"""The colour bar in one 3D view, also in pictures that are saved of it."""

from pivy import coin

from .colour_bar import bar_image


class ColourBarNode:
    """A colour bar that lies over a scene, at its left edge, and is no part of what is fitted or picked.

    Parameters
    ----------
    root : pivy.coin.SoGroup
        Scene graph of the view.
    """

    def __init__(self, root):
        self._root = root
        self._content = self._height = None
        # FreeCAD's own kind of group: what is in it is not what 'fit all' fits.
        self.node = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
        self.node.set("mode EXCLUDE_BBOX")
        unpicked = coin.SoPickStyle()
        unpicked.style = coin.SoPickStyle.UNPICKABLE
        over = coin.SoAnnotation()
        resize, self._camera = coin.SoCallback(), coin.SoOrthographicCamera()
        self._fit = self._fit_to_view  # pivy does not keep it alive
        resize.setCallback(self._fit)
        self._camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        self._camera.nearDistance, self._camera.farDistance = 0.5, 2.0
        self._camera.position = (0.0, 0.0, 1.0)
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        self._place, self._image = coin.SoTranslation(), coin.SoImage()
        self._image.vertAlignment = coin.SoImage.HALF
        self._image.horAlignment = coin.SoImage.LEFT
        for node in (resize, self._camera, light, self._place, self._image):
            over.addChild(node)
        for node in (unpicked, over):
            self.node.addChild(node)
        root.addChild(self.node)

    def is_in(self, root):
        """Whether this is the bar of a view with that scene graph."""
        return root.findChild(self.node) >= 0

    def show(self, content):
        """Show a BarContent."""
        if content != self._content:
            self._content, self._height = content, None
            self.node.touch()

    def remove(self):
        """Take the bar out of the view."""
        self._root.removeChild(self.node)

    def _fit_to_view(self, _data, action):
        """Draw one to one at the size of what is rendered: that of a saved picture is not the window's."""
        if self._content is None or not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            return
        width, height = coin.SoViewportRegionElement.get(action.getState()).getViewportSizePixels().getValue()
        if (width, height) == self._height or not width or not height:
            return
        self._height = width, height
        self._camera.height = float(height)
        self._camera.aspectRatio = width / height
        # No larger than a narrow picture allows, and on whole pixels.
        image = bar_image(self._content, min(height, round(1.2 * width)))
        margin = max(4, round(0.012 * height))
        self._place.translation = (margin - width / 2.0, (height % 2) / 2.0, 0.0)
        flipped = image.mirrored()
        self._image.image.setValue(coin.SbVec2s(image.width(), image.height()), 4, bytes(flipped.constBits()))
