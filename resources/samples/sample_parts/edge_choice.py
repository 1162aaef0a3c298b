# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a shape, chosen by where they lie: their numbering differs between versions of the kernel."""

import Part


def edges_where(shape, wanted):
    """1-based numbers of the edges that `wanted` accepts: at least one."""
    numbers = [i for i, edge in enumerate(shape.Edges, 1) if wanted(edge)]
    if not numbers:
        raise RuntimeError("no edge matches the selection")
    return numbers


def is_line(edge, direction):
    """Whether the edge is a straight line along +-direction."""
    if not isinstance(edge.Curve, (Part.Line, Part.LineSegment)):
        return False
    return abs(abs(edge.tangentAt(edge.FirstParameter).dot(direction)) - 1) < 1e-6


def is_circle(edge, diameter, height=None):
    """Whether the edge is a circle of this diameter about an axis along Z (at this z)."""
    circle = edge.Curve
    if not isinstance(circle, Part.Circle) or abs(circle.Radius - diameter / 2) > 1e-6:
        return False
    return height is None or abs(circle.Center.z - height) < 1e-6


def lies_at(edge, direction, position):
    """Whether the whole edge has the coordinate `position` along the unit vector `direction`."""
    points = [edge.valueAt(p) for p in (edge.FirstParameter, edge.LastParameter)]
    points.append(edge.CenterOfMass)
    return all(abs(point.dot(direction) - position) < 1e-6 for point in points)
