"""What an object's shape was when it was measured, in a line of text, and where it stood."""

import numpy as np

from .bootstrap import load_freecad

_DIGITS = 9
_EQUAL = 1e-8
"""Difference of two measures, in units of the part, below which they are the same: digits and rounding."""

_MOST_CORNERS, _MOST_FACES = 20_000, 100
"""So many are looked at, spread over all: what changes a part moves a corner, be it that of one hole's seam.
Areas and volumes would cost half a second per 1000 faces."""

_MOST_KNOWN = 500

_known = {}  # document, object, number of the piece -> (shape, its measures)


def signature(sources):
    """Measures of the shapes of objects, in their own coordinates: moving a part does not change them.

    Parameters
    ----------
    sources : list of FreeCAD.DocumentObject

    Returns
    -------
    str
        One group of numbers per source, to be compared by `same_signature`.
    """
    return ";".join(" ".join(f"{value:.{_DIGITS}g}" for value in _measures_of(each)) for each in sources)


def same_signature(one, other):
    """Whether two signatures are of the same shapes.

    A recompute that changed nothing makes a new shape that differs by rounding.
    """
    groups, others = one.split(";"), other.split(";")
    return len(groups) == len(others) and all(map(_same, groups, others))


def _same(one, other):
    one, other = (np.array(each.split(), dtype=float) for each in (one, other))
    return len(one) == len(other) and bool(
        np.allclose(one, other, rtol=_EQUAL, atol=_EQUAL, equal_nan=True))


def global_placement(source):
    """Where an object stands in its document, containers included: FreeCAD.Placement."""
    ways = [(root, path) for root, path in getattr(source, "Parents", ()) if root.Document == source.Document]
    if not ways:
        return source.getSubObject("", retType=3)
    # FreeCAD gives them in any order. Where the object itself stands does not depend on links to its container.
    root, path = min(ways, key=lambda way: (len(links_in(way[0].getSubObjectList(way[1]))), way[0].Name, way[1]))
    return root.getSubObject(path, retType=3)


def links_in(chain):
    """Those of some objects that are links: list of FreeCAD.DocumentObject."""
    return [each for each in chain if each is not None
            and (each.isDerivedFrom("App::Link") or each.isDerivedFrom("App::LinkElement"))]


def same_place(one, other):
    """Whether two placements put a part at the same place, rounding aside."""
    apart = one.inverse() * other
    reach = max(1.0, one.Base.Length, other.Base.Length)
    return apart.Base.Length < 1e-7 * reach and abs(apart.Rotation.Angle) < 1e-7


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
        place = np.array((own * piece.Placement).toMatrix().A).reshape(4, 4)
        counts, middle, spread = _piece_measures((source.Document.Name, source.Name, number), piece)
        middle = place[:3, :3] @ middle + place[:3, 3]
        direction = place[:3, :3] @ spread
        size += np.abs(spread).sum()
        total += [*counts, *(number * middle), *(number * direction)]
    size = size or 1.0
    return [len(pieces), *total[:2], size, *(total[2:] / size)]


def _piece_measures(key, piece):
    """Counts of faces and corners, and two sums over points of a shape, in its own coordinates."""
    known = _known.get(key)
    if known is not None and known[0].isPartner(piece):
        return known[1]  # it was moved, or something else was changed
    piece.Placement = load_freecad().Placement()
    faces, corners = piece.Faces, piece.Vertexes
    points = [corner.Point for corner in corners[::-(-len(corners) // _MOST_CORNERS) or 1]]
    for face in faces[::-(-len(faces) // _MOST_FACES) or 1]:
        first_u, last_u, first_v, last_v = face.ParameterRange
        points.append(face.valueAt(0.4 * first_u + 0.6 * last_u, 0.3 * first_v + 0.7 * last_v))
    points = np.array(points).reshape(-1, 3)
    middle = points.mean(axis=0)
    # Unlike weights tell two points apart that change places.
    order = np.sin(np.arange(1.0, len(points) + 1.0))
    measures = ((len(faces), len(corners)), middle, order @ (points - middle))
    if len(_known) > _MOST_KNOWN:
        _known.clear()
    _known[key] = piece, measures
    return measures


def _mesh_measures(source):
    """The points of a mesh include its placement; that of the object takes it out again."""
    points = np.array([(p.x, p.y, p.z) for p in source.Mesh.Topology[0]])
    matrix = np.array(source.Placement.inverse().toMatrix().A).reshape(4, 4)
    points = points @ matrix[:3, :3].T + matrix[:3, 3]
    size = float(np.ptp(points, axis=0).sum()) or 1.0
    order = np.sin(np.arange(1.0, len(points) + 1.0)) / len(points)
    # A mesh is kept in single precision: moving it and back changes its points.
    return np.round([source.Mesh.CountFacets, len(points), *(points.mean(axis=0) / size),
                     *(order @ points / size)], 5).tolist()
