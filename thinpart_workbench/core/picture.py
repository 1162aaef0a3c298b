"""Pictures of a part: shaded, with its edges, in colours of their own for each triangle."""

import numpy as np

from .camera import ISOMETRIC, framing
from .rasterizer import nearest_triangles

WIDTH, HEIGHT = 160, 120
"""Pixels of a small picture."""

SAMPLES = 2
"""Each pixel is the mean of this many by as many samples."""

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
    """Draw a small picture of a surface as it is seen when its document is opened: isometric, z upwards.

    Parameters
    ----------
    mesh : SurfaceMesh
        Of an open surface the inside is drawn as well.
    face_colours : dict, optional
        Red, green and blue from 0 to 1, by the number of the B-Rep face, from 0; others are `PLAIN`.

    Returns
    -------
    ndarray of shape (HEIGHT, WIDTH, 4), uint8
        See `draw`.
    """
    colours = _colours(mesh, face_colours or {})[mesh.face_of_triangle]
    camera = framing(mesh.vertices, ISOMETRIC, WIDTH, HEIGHT)
    return draw(mesh.vertices[mesh.triangles], mesh.normals, colours, camera, not mesh.watertight)


def draw(corners, normals, colours, camera, both_sides=False, darkest=DARKEST):
    """Draw triangles.

    Parameters
    ----------
    corners : ndarray of shape (m, 3, 3), mm
    normals : ndarray of shape (m, 3)
        Unit outward normals.
    colours : ndarray of shape (m, 3)
        Red, green and blue from 0 to 1.
    camera : Camera
    both_sides : bool
        Whether triangles are seen from behind as well.
    darkest : float
        Brightness of what is turned away from the light.

    Returns
    -------
    ndarray of shape (height, width, 4), uint8
        Red, green, blue and alpha. What the part does not cover is transparent.

    Notes
    -----
    Brightness goes with the cosine to the light over all of its range, from `darkest` for what is turned
    away to 1 for what faces it, so that no side is uniformly dark. Edges are drawn where the surface
    bends or ends, not where two faces merge smoothly.
    """
    normals = normals @ camera.axes.T
    if both_sides:
        normals[normals[:, 2] < 0.0] *= -1.0
    facing = np.flatnonzero(normals[:, 2] > _GRAZING)
    width, height = camera.width * SAMPLES, camera.height * SAMPLES
    triangle, depth = nearest_triangles(camera.project(corners[facing]) * SAMPLES, width, height)
    covered = triangle >= 0
    depth[~covered] = 0.0
    # The last row, which -1 stands for, is that of no triangle.
    triangle = np.append(facing, len(normals))[triangle]
    brightness = darkest + (1.0 - darkest) * 0.5 * (1.0 + normals @ LIGHT)
    shine = np.ones(covered.shape, dtype=np.float32)
    shine[_edges(_samples(normals, triangle), depth.astype(np.float32), covered)] = EDGE_BRIGHTNESS
    return _pixels([each * shine for each in _samples(colours * brightness[:, None], triangle)], covered)


def _samples(values, triangle):
    """Three values of each triangle where it is seen, a list of three ndarrays of float32; else 0."""
    return [np.append(column, 0.0).astype(np.float32)[triangle] for column in values.T]


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
        along = sum(each[here] * each[there] for each in normal)
        edge[here] |= both & (along < CREASE)
        # Down is against the second axis of the camera.
        aside = normal[0] if axis == 1 else -normal[1]
        back = depth[there] - depth[here]
        off_here = aside[here] + normal[2][here] * back
        off_there = aside[there] + normal[2][there] * back
        apart = both & (np.minimum(np.abs(off_here), np.abs(off_there)) > STEP)
        edge[here] |= apart & (back < 0.0)
        edge[there] |= apart & (back > 0.0)
    return edge


def _pixels(colour, covered):
    """Means of the samples of each pixel."""
    share = _sums(covered.astype(np.float32))
    mean = np.stack([_sums(each) for each in colour], axis=-1) / np.maximum(share, 1.0)[..., None]
    share = share / SAMPLES ** 2
    return np.round(255.0 * np.dstack([np.clip(mean, 0.0, 1.0), share])).astype(np.uint8)


def _sums(samples):
    """Sums over the samples of each pixel."""
    return sum(samples[down::SAMPLES, right::SAMPLES] for down in range(SAMPLES) for right in range(SAMPLES))
