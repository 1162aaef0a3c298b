"""Oriented bounding boxes: the minimum-volume box and the paper's principal box."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from .box_refinement import refined_axes
from .progress import tell
from .tolerances import TOLERANCES

SUPPORT_DIRECTIONS = 400
HULL_FACET_CANDIDATES = 48
EDGE_PRODUCT_CANDIDATES = 60
SMALL_HULL_FACETS = 60
REFINED_CANDIDATES = 4
POLISHING_ROUNDS = 6
POLISHING_TILTS = (0.005, 0.02, 0.06)
POLISHED = 3e-4
"""Share by which the box of all points may exceed that of the extreme ones it was found with."""
FLAT_SIDE_DEPTH = 1e-6
"""Points this share of the extent under the outermost one lie on its flat side."""
FLAT_SIDE_CORNERS = 64
_POINTS_AT_ONCE = 4096


@dataclass(frozen=True)
class OrientedBox:
    """A box around a part.

    Attributes
    ----------
    dimensions : ndarray of shape (3,), mm
        D1 >= D2 >= D3.
    axes : ndarray of shape (3, 3)
        Row k is the unit direction of dimension k.
    """

    dimensions: np.ndarray
    axes: np.ndarray

    @property
    def volume(self):
        """float, mm3."""
        return float(np.prod(self.dimensions))

    @property
    def diagonal(self):
        """float, mm."""
        return float(np.linalg.norm(self.dimensions))


def principal_box(points):
    """Box along the principal axes of the vertices, as the paper has it.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm

    Returns
    -------
    OrientedBox

    Notes
    -----
    Giannini, Petton, Pernot (TMCE 2012), 4.2, verbatim. It follows the density of the vertices and
    is not minimal: a square plate may get a box turned by 45 degrees. `minimal_box` is the default.
    """
    return _box_along(points, np.linalg.eigh(np.cov(points.T))[1].T)


def minimal_box(points, flat_directions=(), report=None):
    """Oriented bounding box of minimum volume.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    flat_directions : array_like of shape (k, 3), optional
        Unit normals of the large flat sides. Where a part has many points and round edges, they
        keep the box flush with those sides.
    report : callable, optional
        Called with the fraction done; may raise to stop.

    Returns
    -------
    OrientedBox
        Among boxes whose volumes agree to `Tolerances.box_tie`, the one with the shortest
        diagonal, so that the choice never flips between equals.

    Notes
    -----
    Directions of a box side are tried from the facets of the convex hull, the principal axes and,
    for small hulls, products of hull edges (a minimum box has two sides flush with hull edges,
    O'Rourke 1985, doi:10.1007/BF00991005); each is completed by the rectangle of least area. The
    best are refined by Nelder and Mead over rotations, in the spirit of Chang, Gorissen and Melchior
    (2011, doi:10.1145/2019627.2019641). A box that is flush with a facet is exact to rounding.
    """
    support = _support_points(points - points.mean(axis=0), flat_directions)
    try:
        hull = ConvexHull(support)
    except QhullError:
        return _flat_box(points)
    corners = support[hull.vertices]
    tell(report, 0.3)
    completed = (_complete_by_rectangle(corners, each) for each in _candidate_directions(support, hull))
    boxes = [_box_along(corners, axes) for axes in completed if axes is not None]
    boxes.sort(key=lambda box: box.volume)
    # Nelder and Mead gains on curved hulls only; candidates that lie far above the best never win.
    tell(report, 0.5)
    boxes += _refined(corners, boxes[:REFINED_CANDIDATES])
    boxes.sort(key=lambda box: box.volume)
    # On a round part the extreme points let a box through that all points would not.
    preferred = _preferred(boxes)
    chosen = [preferred] if preferred is boxes[0] else [boxes[0], preferred]
    return _preferred([_polished(points, corners, box, report) for box in chosen])


def _preferred(boxes):
    """The one with the shortest diagonal of the smallest boxes."""
    least = min(box.volume for box in boxes) * (1.0 + TOLERANCES.box_tie)
    return min((box for box in boxes if box.volume <= least), key=lambda box: box.diagonal)


def _polished(points, corners, box, report):
    """The box of all points, refined with those that stick out of it as more corners."""
    best = _box_along(points, box.axes)
    for _ in range(POLISHING_ROUNDS):
        if best.volume <= box.volume * (1.0 + POLISHED):
            break
        tell(report, 0.8)
        corners = np.concatenate([corners, points[_extreme(points, _around(box.axes))]])
        box, = _refined(corners, [_box_along(corners, best.axes)])
        best = min(best, _box_along(points, box.axes), key=lambda each: each.volume)
    return best


def _around(axes):
    """Directions near the axes, both ways, ndarray of shape (k, 3)."""
    cones = [
        np.cos(tilt) * axis + np.sin(tilt) * _in_plane(axis, 8)
        for axis in np.concatenate([axes, -axes]) for tilt in POLISHING_TILTS
    ]
    return np.concatenate([axes, -axes, *cones])


def _box_along(points, axes):
    along = points @ axes.T
    extents = along.max(axis=0) - along.min(axis=0)
    order = np.argsort(-extents, kind="stable")
    return OrientedBox(extents[order], axes[order])


def _support_points(points, flat_directions):
    """Points whose hull stands for that of all: extreme ones, and the corners of flat sides."""
    if len(points) <= 4 * SUPPORT_DIRECTIONS:
        return points
    chosen = [_extreme(points, _spread_directions(SUPPORT_DIRECTIONS))]
    reach = FLAT_SIDE_DEPTH * float(np.ptp(points, axis=0).max())
    for direction in np.reshape(flat_directions, (-1, 3)):
        height = points @ direction
        for side in (height >= height.max() - reach, height <= height.min() + reach):
            corners = np.flatnonzero(side)
            if len(corners) > FLAT_SIDE_CORNERS:
                around = _in_plane(direction, FLAT_SIDE_CORNERS)
                corners = corners[_extreme(points[corners], around)]
            chosen.append(corners)
    return points[np.unique(np.concatenate(chosen))]


def _extreme(points, directions):
    """Indices of the points farthest along each direction, each once."""
    # Float32 tells apart what matters here; the directions are rows, for the sake of argmax.
    coarse, rows = points.astype(np.float32), directions.astype(np.float32)
    winners = np.unique(np.concatenate([
        start + (rows @ coarse[start:start + _POINTS_AT_ONCE].T).argmax(axis=1)
        for start in range(0, len(points), _POINTS_AT_ONCE)
    ]))
    return winners[np.unique((directions @ points[winners].T).argmax(axis=1))]


def _in_plane(direction, count):
    across, along = _perpendicular(direction)
    turn = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    return np.cos(turn)[:, None] * across + np.sin(turn)[:, None] * along


def _perpendicular(direction):
    """Two unit vectors that complete a direction to a right-handed frame."""
    across = np.cross(direction, np.eye(3)[np.abs(direction).argmin()])
    across /= np.linalg.norm(across)
    return across, np.cross(direction, across)


def _spread_directions(count):
    """Fibonacci lattice on the sphere, ndarray of shape (count, 3)."""
    index = np.arange(count) + 0.5
    polar = np.arccos(1.0 - 2.0 * index / count)
    turn = np.pi * (1.0 + 5.0 ** 0.5) * index
    return np.stack(
        [np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)], axis=1
    )


def _candidate_directions(support, hull):
    normals = hull.equations[:, :3]
    triangles = support[hull.simplices]
    doubled = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    areas = np.linalg.norm(doubled, axis=1)
    side = np.where(normals @ [1.0, 1e-3, 1e-5] < 0.0, -1.0, 1.0)
    keys, first, which = np.unique(
        np.round(normals * side[:, None], 5), axis=0, return_index=True, return_inverse=True
    )
    largest = np.argsort(-np.bincount(which.ravel(), areas), kind="stable")
    directions = [normals[first[largest[:HULL_FACET_CANDIDATES]]]]
    directions.append(np.linalg.eigh(np.cov(support[hull.vertices].T))[1].T)
    if len(hull.simplices) <= SMALL_HULL_FACETS:
        directions.append(_edge_products(support, hull))
    return np.concatenate(directions)


def _edge_products(support, hull):
    simplices = hull.simplices
    edges = np.sort(
        np.concatenate([simplices[:, [0, 1]], simplices[:, [1, 2]], simplices[:, [2, 0]]]), axis=1
    )
    edges = np.unique(edges, axis=0)
    directions = support[edges[:, 1]] - support[edges[:, 0]]
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    first, second = np.triu_indices(len(directions), 1)
    products = np.cross(directions[first], directions[second])
    length = np.linalg.norm(products, axis=1)
    products = products[length > 1e-6] / length[length > 1e-6][:, None]
    products = np.unique(np.round(products, 6), axis=0)
    count = min(len(products), EDGE_PRODUCT_CANDIDATES)
    products = products[np.linspace(0, len(products) - 1, count).astype(int)]
    return products / np.linalg.norm(products, axis=1)[:, None]


def _complete_by_rectangle(points, direction):
    """The axes (rows) of the box with one side along `direction` whose base has least area."""
    across, along = _perpendicular(direction)
    flat = np.stack([points @ across, points @ along], axis=1)
    edge = _rectangle_direction(flat)
    if edge is None:
        return None
    first = edge[0] * across + edge[1] * along
    return np.stack([direction, first, np.cross(direction, first)])


def _rectangle_direction(flat):
    """Direction of one side of the rectangle of least area around points in the plane.

    One side lies on an edge of the convex polygon (Freeman and Shapira 1975,
    doi:10.1145/360881.360919).
    """
    try:
        polygon = flat[ConvexHull(flat).vertices]
    except QhullError:
        return None
    edges = np.roll(polygon, -1, axis=0) - polygon
    length = np.hypot(edges[:, 0], edges[:, 1])
    edges = edges[length > 1e-9 * length.max()] / length[length > 1e-9 * length.max()][:, None]
    width = polygon @ edges.T
    height = polygon @ np.stack([-edges[:, 1], edges[:, 0]])
    area = (width.max(axis=0) - width.min(axis=0)) * (height.max(axis=0) - height.min(axis=0))
    return edges[area.argmin()]


def _refined(points, boxes):
    """Boxes that are no larger, near these: list of OrientedBox."""
    axes = refined_axes(points, np.array([box.axes for box in boxes]))
    return [_box_along(points, each) for each in axes]


def _flat_box(points):
    """The box of points that all lie in one plane or on one line."""
    axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    completed = _complete_by_rectangle(points, axes[2])
    return _box_along(points, axes if completed is None else completed)
