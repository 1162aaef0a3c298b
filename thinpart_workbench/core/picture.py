"""A small picture of a part, as it is seen when its document is opened: isometric, z upwards."""

import numpy as np

from .rasterizer import nearest_triangles

WIDTH, HEIGHT = 160, 120
"""Pixels of a picture."""

SAMPLES = 2
"""Each pixel is the mean of this many by as many samples."""

MARGIN = 0.03
"""Share of the picture's height that stays free on each side."""

CAMERA = np.array([[1.0, 1.0, 0.0], [-1.0, 1.0, 2.0], [1.0, -1.0, 1.0]])
CAMERA /= np.linalg.norm(CAMERA, axis=1)[:, None]
"""Rows are the directions to the right, upwards and towards the viewer: FreeCAD's isometric view."""

LIGHT = np.array([-0.45, 0.65, 0.75])
LIGHT /= np.linalg.norm(LIGHT)
"""Direction to the light, in the camera's axes: from the upper left, before the part."""

PLAIN = (0.74, 0.77, 0.81)
"""Colour of faces that have no other: red, green and blue from 0 to 1."""

DARKEST = 0.3
"""Brightness of a surface that is turned away from the light."""

EDGE_BRIGHTNESS = 0.2
"""That of an edge, as a share of its surface's."""

CREASE = np.cos(np.radians(20.0))
"""Cosine of the angle between neighbouring samples from which there is an edge between them."""

STEP = 2.5
"""Samples by which one of them must lie behind the plane of the other for the same."""

_GRAZING = 1e-3


def picture(mesh, face_colours=None):
    """Draw a surface.

    Parameters
    ----------
    mesh : SurfaceMesh
        Of an open surface the inside is drawn as well.
    face_colours : dict, optional
        Red, green and blue from 0 to 1, by the number of the B-Rep face, from 0; others are `PLAIN`.

    Returns
    -------
    ndarray of shape (HEIGHT, WIDTH, 4), uint8
        Red, green, blue and alpha. What the part does not cover is transparent.

    Notes
    -----
    Brightness goes with the cosine to the light over all of its range, from `DARKEST` for what is turned
    away to 1 for what faces it, so that no side is uniformly dark. Edges are drawn where the surface
    bends or ends, not where two faces merge smoothly.
    """
    normals = mesh.normals @ CAMERA.T
    if not mesh.watertight:
        normals[normals[:, 2] < 0.0] *= -1.0
    facing = np.flatnonzero(normals[:, 2] > _GRAZING)
    triangle, depth = nearest_triangles(_placed(mesh, facing), WIDTH * SAMPLES, HEIGHT * SAMPLES)
    covered = triangle >= 0
    depth[~covered] = 0.0
    triangle = facing[triangle[covered]]

    normal = np.zeros(covered.shape + (3,))
    normal[covered] = normals[triangle]
    brightness = DARKEST + (1.0 - DARKEST) * 0.5 * (1.0 + normal[covered] @ LIGHT)
    brightness[_edges(normal, depth, covered)[covered]] *= EDGE_BRIGHTNESS
    colour = np.zeros(covered.shape + (3,))
    colour[covered] = _colours(mesh, face_colours or {})[mesh.face_of_triangle[triangle]]
    colour[covered] *= brightness[:, None]
    return _pixels(colour, covered)


def _placed(mesh, triangles):
    """Corners of some triangles as `nearest_triangles` wants them, the part in the middle."""
    seen = mesh.vertices @ CAMERA.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    size = np.array([WIDTH, HEIGHT]) * SAMPLES
    free = size - 2.0 * MARGIN * HEIGHT * SAMPLES
    scale = (free / np.maximum(high - low, 1e-9 * mesh.extent)[:2]).min()
    seen -= 0.5 * (low + high)
    seen *= np.array([scale, -scale, scale])
    seen[:, :2] += 0.5 * size
    return seen[mesh.triangles[triangles]]


def _colours(mesh, face_colours):
    colours = np.tile(PLAIN, (int(mesh.face_of_triangle.max()) + 1, 1))
    for face, colour in face_colours.items():
        if face < len(colours):
            colours[face] = colour
    return colours


def _edges(normal, depth, covered):
    """Samples on an edge, ndarray of bool: the outline too, and of two surfaces the one in front."""
    edge = np.zeros(covered.shape, dtype=bool)
    for axis in (0, 1):
        here, there = [slice(None)] * 2, [slice(None)] * 2
        here[axis], there[axis] = slice(None, -1), slice(1, None)
        here, there = tuple(here), tuple(there)
        both = covered[here] & covered[there]
        edge[here] |= covered[here] & ~covered[there]
        edge[there] |= covered[there] & ~covered[here]
        bent = both & (np.einsum("ijk,ijk->ij", normal[here], normal[there]) < CREASE)
        edge[here] |= bent
        # Down is against the second axis of the camera.
        aside = normal[..., 0] if axis == 1 else -normal[..., 1]
        back = depth[there] - depth[here]
        off_here = aside[here] + normal[..., 2][here] * back
        off_there = aside[there] + normal[..., 2][there] * back
        apart = both & (np.minimum(np.abs(off_here), np.abs(off_there)) > STEP)
        edge[here] |= apart & (back < 0.0)
        edge[there] |= apart & (back > 0.0)
    return edge


def _pixels(colour, covered):
    """Means of the samples of each pixel."""
    shape = (HEIGHT, SAMPLES, WIDTH, SAMPLES)
    share = covered.reshape(shape).mean(axis=(1, 3))
    mean = colour.reshape(shape + (3,)).mean(axis=(1, 3)) / np.maximum(share, 1e-9)[..., None]
    return np.round(255.0 * np.dstack([np.clip(mean, 0.0, 1.0), share])).astype(np.uint8)
