# SPDX-License-Identifier: LGPL-2.1-or-later
"""Oriented bounding boxes: the minimum-volume box and the paper's principal box."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from ..progress import report_progress
from ..tolerances import TOLERANCES
from .box_refinement import distinct, refined_axes, spread_directions

SUPPORT_DIRECTIONS = 400
HULL_FACET_CANDIDATES = 48
EDGE_PRODUCT_CANDIDATES = 60
SMALL_HULL_FACETS = 60
REFINED_CANDIDATES = 4
HOPELESS = 1.02
"""Boxes that are larger than the smallest one by this ratio are not completed: refining them gains less."""

POLISHING_ROUNDS = 6
POLISHING_TILTS = (0.005, 0.02, 0.06)
POLISHED = 3e-4
"""Share by which the box of all points may exceed the box of the extreme points."""
SAME_DIAGONAL = 1e-5
"""Diagonals that differ by no more than this share are equal."""
FLAT_SIDE_DEPTH = 1e-6
"""Points within this share of the extent below the outermost one belong to the same flat side."""
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
    """Compute the box along the principal axes of vertices, ndarray of shape (v, 3), mm, as in the paper: OrientedBox.

    Exactly as in Giannini, Petton, Pernot (TMCE 2012), 4.2. It depends on the density of the vertices and is not
    minimal: a square plate may get a box rotated by 45 degrees. `minimal_box` is the default.
    """
    return _box_along(points, np.linalg.eigh(np.cov(points.T))[1].T)


def minimal_box(points, flat_directions=(), report=None):
    """Compute the oriented bounding box of minimum volume.

    Returns an OrientedBox: among boxes whose volumes agree to `Tolerances.box_tie`, the one with the shortest diagonal, so
    that the choice between equals is stable.

    Candidate directions of a box side are the normals of the convex hull, the principal axes and, for small hulls,
    products of hull edges (a minimum box has two sides flush with hull edges, O'Rourke 1985,
    doi:10.1007/BF00991005). Each is completed by the rectangle of least area. The best boxes are refined by the
    method of Nelder and Mead over rotations, following Chang, Gorissen and Melchior (2011,
    doi:10.1145/2019627.2019641). A box that is flush with a facet is exact to rounding.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    flat_directions : array_like of shape (k, 3), optional
        Unit normals of the large flat sides. They keep the box of a part with many points and round edges flush
        with those sides.
    report : callable, optional
        Called with the fraction done; may raise to stop.
    """
    support = _support_points(points - points.mean(axis=0), flat_directions)
    try:
        hull = ConvexHull(support)
    except QhullError:
        return _flat_box(points)
    corners = support[hull.vertices]
    report_progress(report, 0.3)
    boxes = _completed_boxes(corners, _candidate_directions(support, hull), support[hull.simplices])
    boxes.sort(key=lambda box: box.volume)
    # The refinement improves boxes of curved hulls only; candidates much larger than the best never win.
    report_progress(report, 0.5)
    best = boxes[:REFINED_CANDIDATES]
    boxes += _refined(corners, [best[k] for k in distinct(np.array([box.axes for box in best]))])
    boxes.sort(key=lambda box: box.volume)
    # On a round part, a box of the extreme points may be smaller than the box of all points.
    preferred = _preferred(boxes)
    chosen = [preferred] if preferred is boxes[0] else [boxes[0], preferred]
    return _preferred([_polished(points, corners, box, report) for box in chosen])


def _completed_boxes(corners, directions, facets):
    """List of OrientedBox with one side along each direction, without those certainly far larger than the smallest.

    The facets are those of the convex hull, shape (f, 3, 3), mm.

    A box is as large at least as its height times the area of the hull's shadow (Cauchy 1832), which takes no rectangle.
    """
    doubled = np.cross(facets[:, 1] - facets[:, 0], facets[:, 2] - facets[:, 0])
    shadow = 0.25 * np.abs(directions @ doubled.T).sum(axis=1)
    least = np.ptp(corners @ directions.T, axis=0) * shadow
    boxes: list[OrientedBox] = []
    smallest = np.inf
    order = np.argsort(least, kind="stable")
    for volume, frame in zip(least[order], _frames(directions[order])):
        if volume > HOPELESS * smallest and len(boxes) >= REFINED_CANDIDATES:
            break
        axes = _complete_by_rectangle(corners, frame)
        if axes is not None:
            boxes.append(_box_along(corners, axes))
            smallest = min(smallest, boxes[-1].volume)
    return boxes


def _preferred(boxes):
    """Choose the box with the shortest diagonal among the smallest ones. Among diagonals that differ by rounding only,
    choose the smallest box: a box flush with the end of a long bar may be askew to its sides."""
    least = min(box.volume for box in boxes) * (1.0 + TOLERANCES.box_tie)
    tied = [box for box in boxes if box.volume <= least]
    shortest = min(box.diagonal for box in tied) * (1.0 + SAME_DIAGONAL)
    return min((box for box in tied if box.diagonal <= shortest), key=lambda box: box.volume)


def _polished(points, corners, box, report):
    """The box of all points, refined with the points outside of the given box as additional corners."""
    best = _box_along(points, box.axes)
    for _ in range(POLISHING_ROUNDS):
        if best.volume <= box.volume * (1.0 + POLISHED):
            break
        report_progress(report, 0.8)
        corners = np.concatenate([corners, points[_extreme(points, _around(box.axes))]])
        box, = _refined(corners, [_box_along(corners, best.axes)])
        best = min(best, _box_along(points, box.axes), key=lambda candidate: candidate.volume)
    return best


def _around(axes):
    """ndarray of shape (k, 3): directions near the axes and their opposites."""
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
    """Choose points whose hull approximates that of all points: extreme ones, and the corners of flat sides."""
    if len(points) <= 4 * SUPPORT_DIRECTIONS:
        return points
    chosen = [_extreme(points, spread_directions(SUPPORT_DIRECTIONS))]
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
    """Indices, without duplicates, of the points farthest along each direction."""
    # Float32 is precise enough for this first pass. The directions are rows because that makes argmax fast.
    coarse, rows = points.astype(np.float32), directions.astype(np.float32)
    winners = np.unique(np.concatenate([
        start + (rows @ coarse[start:start + _POINTS_AT_ONCE].T).argmax(axis=1)
        for start in range(0, len(points), _POINTS_AT_ONCE)
    ]))
    return winners[np.unique((directions @ points[winners].T).argmax(axis=1))]


def _in_plane(direction, count):
    _, across, along = _frames(direction[None])[0]
    turn = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    return np.cos(turn)[:, None] * across + np.sin(turn)[:, None] * along


def _frames(directions):
    """Right-handed frames of unit vectors, ndarray of shape (k, 3, 3), of which the first rows are given ones."""
    across = np.cross(directions, np.eye(3)[np.abs(directions).argmin(axis=1)])
    across /= np.linalg.norm(across, axis=1)[:, None]
    return np.stack([directions, across, np.cross(directions, across)], axis=1)


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


def _complete_by_rectangle(points, frame):
    """Axes, as rows, of the box with one side along the first row of a frame and the base of least area."""
    edge = _rectangle_direction(points @ frame[1:].T)
    if edge is None:
        return None
    turn = np.array([[1.0, 0.0, 0.0], [0.0, edge[0], edge[1]], [0.0, -edge[1], edge[0]]])
    return turn @ frame


def _rectangle_direction(flat):
    """Direction of one side of the rectangle of least area around points in the plane.

    One side lies on an edge of the convex polygon (Freeman and Shapira 1975,
    doi:10.1145/360881.360919).
    """
    try:
        polygon = flat[ConvexHull(flat).vertices]
    except QhullError:
        return None
    edges = polygon[np.arange(1, len(polygon) + 1) % len(polygon)] - polygon
    length = np.hypot(edges[:, 0], edges[:, 1])
    edges = edges[length > 1e-9 * length.max()]
    edges /= np.hypot(edges[:, 0], edges[:, 1])[:, None]
    # Rows, because numpy finds extremes of contiguous ones faster.
    along = np.concatenate([edges, np.stack([-edges[:, 1], edges[:, 0]], axis=1)]) @ polygon.T
    width, height = (along.max(axis=1) - along.min(axis=1)).reshape(2, -1)
    return edges[(width * height).argmin()]


def _refined(points, boxes):
    """list of OrientedBox: boxes near the given ones that are no larger."""
    axes = refined_axes(points, np.array([box.axes for box in boxes]))
    return [_box_along(points, box_axes) for box_axes in axes]


def _flat_box(points):
    """The box of points that lie in one plane or on one line."""
    axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    completed = _complete_by_rectangle(points, _frames(axes[2:])[0])
    return _box_along(points, axes if completed is None else completed)
