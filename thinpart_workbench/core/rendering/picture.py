# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a part: shaded, with edges, and a colour for each triangle."""

import numpy as np

from .camera import ISOMETRIC, framing
from .picture_size import HEIGHT, WIDTH
from .rasterizer import nearest_triangles

SAMPLES = 2
"""Each pixel is the mean of SAMPLES x SAMPLES samples."""

LIGHT = np.array([-0.45, 0.65, 0.75])
LIGHT /= np.linalg.norm(LIGHT)
"""Direction to the light, in the axes of the camera: upper left, in front of the part."""

PLAIN = (0.74, 0.77, 0.81)
"""Default colour of faces: red, green and blue from 0 to 1."""

DARKEST = 0.3
"""Brightness of a surface that faces away from the light."""

EDGE_BRIGHTNESS = 0.2
"""Brightness of an edge, as a share of that of its surface."""

CREASE = np.cos(np.radians(20.0))
"""An edge lies between neighbouring samples whose normals have a cosine below this."""

STEP = 2.5
"""Distance, in samples, of each of two neighbours from the plane of the other above which an edge lies between them."""

_GRAZING = 1e-3


def picture(mesh, face_colours=None):
    """Draw a small picture of a surface in the view of a newly opened document: isometric, z upwards.

    Returns an ndarray of shape (HEIGHT, WIDTH, 4), uint8: see `draw`.

    Parameters
    ----------
    mesh : SurfaceMesh
        The inside of an open surface is drawn as well.
    face_colours : dict, optional
        Red, green and blue from 0 to 1 by number of the B-Rep face, from 0; other faces are `PLAIN`.
    """
    colours = _colours(mesh, face_colours or {})[mesh.face_of_triangle]
    camera = framing(mesh.vertices, ISOMETRIC, WIDTH, HEIGHT)
    return draw(mesh.vertices[mesh.triangles], mesh.normals, colours, camera, not mesh.watertight)


def draw(corners, normals, colours, camera, both_sides=False, darkest=DARKEST):
    """Draw triangles: ndarray of shape (height, width, 4), uint8.

    Red, green, blue and alpha. What the part does not cover is transparent.

    Brightness is linear in the cosine to the light over its full range, from `darkest` for surface that faces
    away to 1 for surface that faces the light, so that no side is uniformly dark. Edges are drawn where the
    surface bends or ends, not where two faces merge smoothly.

    Parameters
    ----------
    corners : ndarray of shape (m, 3, 3), mm
    normals : ndarray of shape (m, 3)
        Unit outward normals.
    colours : ndarray of shape (m, 3), or (m, 3, 3)
        Red, green and blue from 0 to 1, of triangles or of their corners.
    camera : Camera
    both_sides : bool
        Whether triangles are visible from behind as well.
    darkest : float
        Brightness of surface that faces away from the light.
    """
    normals = normals @ camera.axes.T
    if both_sides:
        normals[normals[:, 2] < 0.0] *= -1.0
    facing = np.flatnonzero(normals[:, 2] > _GRAZING)
    width, height = camera.width * SAMPLES, camera.height * SAMPLES
    projected = camera.project(corners[facing]) * SAMPLES
    triangle, depth = nearest_triangles(projected, width, height)
    if colours.ndim == 3:
        smooth, colours = _between_corners(projected, colours[facing], triangle), np.ones((len(normals), 3))
    else:
        smooth = [1.0] * 3
    covered = triangle >= 0
    depth[~covered] = 0.0
    # Index -1, no triangle, refers to the extra last row.
    triangle = np.append(facing, len(normals))[triangle]
    brightness = darkest + (1.0 - darkest) * 0.5 * (1.0 + normals @ LIGHT)
    shine = np.ones(covered.shape, dtype=np.float32)
    shine[_edges(_samples(normals, triangle), depth.astype(np.float32), covered)] = EDGE_BRIGHTNESS
    return _pixels([channel * shine * change for channel, change in zip(
        _samples(colours * brightness[:, None], triangle), smooth)], covered)


def _between_corners(projected, colours, triangle):
    """Colours at samples, linear between the corners of their triangle: list of three ndarrays of float32."""
    shown, (row, column) = [np.zeros(triangle.shape, dtype=np.float32) for _ in range(3)], np.nonzero(triangle >= 0)
    own = triangle[row, column]
    corner = projected[own][:, :, :2]
    place = np.column_stack([column, row]) + 0.5 - corner[:, 0]
    (ax, ay), (bx, by) = (corner[:, 1] - corner[:, 0]).T, (corner[:, 2] - corner[:, 0]).T
    across = ax * by - ay * bx
    across = np.where(np.abs(across) > 0.0, across, 1.0)
    second = np.clip((place[:, 0] * by - place[:, 1] * bx) / across, 0.0, 1.0)
    third = np.clip((ax * place[:, 1] - ay * place[:, 0]) / across, 0.0, 1.0 - second)
    weights = np.column_stack([1.0 - second - third, second, third])
    for channel in range(3):
        shown[channel][row, column] = np.einsum("ij,ij->i", weights, colours[own, :, channel])
    return shown


def _samples(values, triangle):
    """Values of the triangle at each sample, 0 where there is none: list of three ndarrays of float32."""
    return [np.append(column, 0.0).astype(np.float32)[triangle] for column in values.T]


def _colours(mesh, face_colours):
    colours = np.tile(PLAIN, (int(mesh.face_of_triangle.max()) + 1, 1))
    for face, colour in face_colours.items():
        if face < len(colours):
            colours[face] = colour
    return colours


def _edges(normal, depth, covered):
    """ndarray of bool: samples on an edge, including the outline. Between two surfaces, the one in front has the edge."""
    edge = np.zeros(covered.shape, dtype=bool)
    for axis in (0, 1):
        first, second = [slice(None)] * 2, [slice(None)] * 2
        first[axis], second[axis] = slice(None, -1), slice(1, None)
        here, there = tuple(first), tuple(second)
        both = covered[here] & covered[there]
        edge[here] |= covered[here] & ~covered[there]
        edge[there] |= covered[there] & ~covered[here]
        along = sum(component[here] * component[there] for component in normal)
        edge[here] |= both & (along < CREASE)
        # Down is opposite to the second axis of the camera.
        aside = normal[0] if axis == 1 else -normal[1]
        back = depth[there] - depth[here]
        off_here = aside[here] + normal[2][here] * back
        off_there = aside[there] + normal[2][there] * back
        apart = both & (np.minimum(np.abs(off_here), np.abs(off_there)) > STEP)
        edge[here] |= apart & (back < 0.0)
        edge[there] |= apart & (back > 0.0)
    return edge


def _pixels(colour, covered):
    """Mean of the samples of each pixel."""
    share = _sums(covered.astype(np.float32))
    mean = np.stack([_sums(channel) for channel in colour], axis=-1) / np.maximum(share, 1.0)[..., None]
    share = share / SAMPLES ** 2
    return np.round(255.0 * np.dstack([np.clip(mean, 0.0, 1.0), share])).astype(np.uint8)


def _sums(samples):
    """Sum over the samples of each pixel."""
    return sum(samples[down::SAMPLES, right::SAMPLES] for down in range(SAMPLES) for right in range(SAMPLES))
