# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths of the edges of a solid, and of what borders its faces, as the geometry has them."""

import math

import numpy as np

from ...core.sizing.mesh_hazards import EdgeLengths


def edge_lengths(shape):
    """The `EdgeLengths` of a solid, a Part.Shape.

    Edges that are drawn together to a point, such as the tip of a cone, are none: no mesh has elements on them.
    """
    edges = np.array(list(map(_length, shape.Edges)))
    borders = np.array([sum(map(_length, face.Edges)) for face in shape.Faces])
    return EdgeLengths(edges[edges > 0.0], borders)


def _length(edge):
    """Length of an edge, mm; 0 for one without a curve, or whose curve has no length that OCC can state."""
    if edge.Degenerated:
        return 0.0
    length = edge.Length
    return length if math.isfinite(length) else 0.0
