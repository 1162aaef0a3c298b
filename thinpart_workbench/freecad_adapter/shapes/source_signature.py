# SPDX-License-Identifier: LGPL-2.1-or-later
"""A text signature of an object's shape, saved with a measurement to detect later changes."""

import numpy as np

from ...core.rigid_transform import transform_directions, transform_points
from ..bootstrap import load_freecad
from ..mesh_arrays import mesh_arrays
from .placements import placement_matrix
from .tolerances import SHAPE_TOLERANCES

_DIGITS = 9
"""See `ShapeTolerances.written`."""

_MOST_CORNERS, _MOST_FACES = 20_000, 100
"""Most corners and faces that enter the signature, spread over all of them. Any change of a part moves some corner, if
only that of one hole's seam. Areas and volumes would take half a second per 1000 faces."""

_MOST_CACHED = 500

_cache = {}  # document, object, number of the piece -> (shape, its measures)


def signature(sources):
    """Measures of the shapes of DocumentObjects in their own coordinates, so that moving a part does not change them: str.

    One group of numbers per source; compare them with `same_signature`.
    """
    return ";".join(" ".join(f"{value:.{_DIGITS}g}" for value in _measures_of(source)) for source in sources)


def same_signature(one, other):
    """Whether two signatures describe the same shapes.

    Rounding is allowed for: a recompute that changed nothing makes a new shape that differs by it.
    """
    groups, others = one.split(";"), other.split(";")
    return len(groups) == len(others) and all(map(_same, groups, others))


def _same(one, other):
    one, other = (np.array(text.split(), dtype=float) for text in (one, other))
    return len(one) == len(other) and bool(
        np.allclose(one, other, rtol=SHAPE_TOLERANCES.written, atol=SHAPE_TOLERANCES.written, equal_nan=True))


def _measures_of(source):
    load_freecad()
    linked = source.getLinkedObject(True) or source
    if linked.isDerivedFrom("Mesh::Feature"):
        return _mesh_measures(linked)
    import Part

    shape = Part.getShape(source)
    if shape.isNull():
        return []
    own = source.getSubObject("", retType=3).inverse()
    pieces = shape.Solids or [shape]
    size = 0.0
    total = np.zeros(8)
    for number, piece in enumerate(pieces, start=1):
        matrix = placement_matrix(own * piece.Placement)
        counts, middle, spread = _piece_measures((source.Document.Name, source.Name, number), piece)
        middle, direction = transform_points(matrix, middle), transform_directions(matrix, spread)
        size += np.abs(spread).sum()
        total += [*counts, *(number * middle), *(number * direction)]
    size = size or 1.0
    return [len(pieces), *total[:2], size, *(total[2:] / size)]


def _piece_measures(key, piece):
    """Counts of faces and corners, and two sums over points of a shape, in its own coordinates."""
    cached = _cache.get(key)
    if cached is not None and cached[0].isPartner(piece):
        return cached[1]  # only its placement or another shape has changed
    piece.Placement = load_freecad().Placement()
    faces, corners = piece.Faces, piece.Vertexes
    points = [corner.Point for corner in corners[::-(-len(corners) // _MOST_CORNERS) or 1]]
    for face in faces[::-(-len(faces) // _MOST_FACES) or 1]:
        first_u, last_u, first_v, last_v = face.ParameterRange
        points.append(face.valueAt(0.4 * first_u + 0.6 * last_u, 0.3 * first_v + 0.7 * last_v))
    points = np.array(points).reshape(-1, 3)
    middle = points.mean(axis=0)
    # With different weights, swapping two points changes the sum.
    order = np.sin(np.arange(1.0, len(points) + 1.0))
    measures = ((len(faces), len(corners)), middle, order @ (points - middle))
    if len(_cache) > _MOST_CACHED:
        _cache.clear()
    _cache[key] = piece, measures
    return measures


def _mesh_measures(source):
    """Measures of a mesh. Its points include the object's placement, which is removed first."""
    points = transform_points(placement_matrix(source.Placement.inverse()), mesh_arrays(source.Mesh)[0])
    size = float(np.ptp(points, axis=0).sum()) or 1.0
    order = np.sin(np.arange(1.0, len(points) + 1.0)) / len(points)
    # A mesh is stored in single precision, so moving it back and forth changes its points.
    return np.round([source.Mesh.CountFacets, len(points), *(points.mean(axis=0) / size),
                     *(order @ points / size)], 5).tolist()
