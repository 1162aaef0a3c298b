# SPDX-License-Identifier: LGPL-2.1-or-later
"""A soft light that makes colours darker, and changes nothing else about them."""

import re

import numpy as np
from pivy import coin

from ..scene.coin_nodes import add_children

DARKEST = 0.7
"""Brightness of surface that is seen from the side, away from the light."""

TOWARDS_LIGHT = (-0.35, 0.45, 0.82)
"""Direction of the light in the coordinates of the camera: from above left, so that the three sides of a box differ."""

CUBE_FROM = (4, 0, 7)
"""Version of Coin from which on normals address a cube map; with 4.0.3, all surface gets the same brightness."""

_SIZE = 64

# Which direction each side of a cube map shows at (s, t) from -1 to 1, as OpenGL defines it.
_SIDES = {
    "PosX": lambda s, t, one: (one, -t, -s), "NegX": lambda s, t, one: (-one, -t, s),
    "PosY": lambda s, t, one: (s, one, t), "NegY": lambda s, t, one: (s, -one, -t),
    "PosZ": lambda s, t, one: (s, -t, one), "NegZ": lambda s, t, one: (-s, -t, -one),
}


class SoftLight:
    """Multiplies the colours of what follows by a brightness that depends on the direction of the surface.

    Attributes
    ----------
    root : pivy.coin.SoSwitch
        What follows needs normals, and the light model ``BASE_COLOR``.

    Notes
    -----
    The brightness is a texture over all directions. Lights of Coin add up with FreeCAD's own, whatever those are set to, and
    the ambient part is grey instead of the colour of the surface: colours would not be those of the colour bar.
    """

    def __init__(self):
        self.root = coin.SoSwitch()
        # Nodes made in Python live as long as Python references them.
        self._nodes = _cube_nodes() if _coin_version() >= CUBE_FROM else _sphere_nodes()
        add_children(self.root, *self._nodes)
        self.switch(True)

    def switch(self, is_on):
        """Switch the light on or off; off, colours are flat."""
        self.root.whichChild = coin.SO_SWITCH_ALL if is_on else coin.SO_SWITCH_NONE


def _coin_version():
    return tuple(map(int, re.findall(r"\d+", str(coin.SoDB.getVersion()))[:3]))


def _cube_nodes():
    """The brightness of each direction: a flat face is evenly bright."""
    texture = coin.SoTextureCubeMap()
    for side, direction in _SIDES.items():
        _set_image(texture.getField(f"image{side}"), direction(*_square(), np.ones((_SIZE, _SIZE))))
    texture.model = coin.SoTextureCubeMap.MODULATE
    return texture, coin.SoTextureCoordinateNormalMap()


def _sphere_nodes():
    """The picture of a lit ball, its rim repeated beyond it. It is addressed by reflections, which differ a little across a
    flat face: by up to a tenth of the brightness at the edges of the view."""
    texture = coin.SoTexture2()
    right, up = _square()
    scale = np.maximum(np.hypot(right, up), 1.0)
    right, up = right / scale, up / scale
    _set_image(texture.image, (right, up, np.sqrt(np.maximum(1.0 - right ** 2 - up ** 2, 0.0))))
    texture.model = coin.SoTexture2.MODULATE
    texture.wrapS = texture.wrapT = coin.SoTexture2.CLAMP
    return texture, coin.SoTextureCoordinateEnvironment()


def _square():
    """Columns and rows of pixels, from -1 to 1: two ndarrays of shape (k, k)."""
    middles = (np.arange(_SIZE) + 0.5) / _SIZE * 2.0 - 1.0
    return np.meshgrid(middles, middles)


def _set_image(field, direction):
    """Fill an image with the brightness in each direction; the far side of a surface is lit like the near one."""
    normals = np.stack(direction, axis=-1)
    normals *= np.where(normals[..., 2:] < 0.0, -1.0, 1.0) / np.linalg.norm(normals, axis=-1, keepdims=True)
    towards = np.array(TOWARDS_LIGHT) / np.linalg.norm(TOWARDS_LIGHT)
    lit = DARKEST + (1.0 - DARKEST) * np.clip(normals @ towards, 0.0, 1.0)
    field.setValue(coin.SbVec2s(_SIZE, _SIZE), 1, np.round(255.0 * lit).astype(np.uint8).tobytes())
