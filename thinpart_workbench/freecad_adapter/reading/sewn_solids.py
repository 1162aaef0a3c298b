# SPDX-License-Identifier: LGPL-2.1-or-later
"""Get closed solids from loose faces."""

from .common_edges import has_free_edges, with_common_edges

SEWING_TOLERANCES = (1e-6, 1e-5, 1e-4)
"""Gaps between loose faces that sewing closes, as shares of the diagonal; tried from tight to loose."""

_ROUNDS = 3
"""How often neighbours are given the same edges: what two faces get may be what a third needs."""


def sewn_solids(shape):
    """Sew the loose faces of a shape together.

    Returns `solids` (list of Part.Shape, empty if no surface closes) and `left` (list of Part.Face that are part of none),
    those of the first attempt that leaves the fewest faces.

    Parameters
    ----------
    shape : Part.Shape
    """
    best, fewest = ([], shape.Faces), len(shape.Faces)
    for tolerance in SEWING_TOLERANCES:
        for sewn in _attempts(shape, tolerance * shape.BoundBox.DiagonalLength):
            solids, left = _closed_solids(sewn)
            if len(left) < fewest:
                best, fewest = (solids, left), len(left)
            if not left:
                return best
    return best


def _attempts(shape, gap):
    """A shape whose faces are sewn, then the same with edges that more faces have in common."""
    for _ in range(1 + _ROUNDS):
        sewn = shape.copy()
        sewn.sewShape(gap)
        yield sewn
        shape = with_common_edges(sewn, gap) if has_free_edges(sewn) else None
        if shape is None:
            return


def _closed_solids(shape):
    import Part

    closed = [shell for shell in shape.Shells if shell.isClosed()]
    used = {face.hashCode() for shell in closed for face in shell.Faces}
    return [Part.Solid(shell) for shell in closed], [face for face in shape.Faces if face.hashCode() not in used]
