# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangles that a 3D view draws, of all objects that are shown."""

import numpy as np
from pivy import coin

from .coin_arrays import numbers_of, points_of


def drawn_triangles(root):
    """Collect the triangles of a scene graph below a node.

    Returns
    -------
    ndarray of shape (n, 3, 3), mm
        Triangle, corner, coordinate, in the coordinates of the document.

    Notes
    -----
    Hidden objects and the sources of a visible map are switched off, so they are not drawn. Links and instances share
    their nodes, each under its own transform.
    """
    found, current, cache = [], [None], {}  # the last of `current` are the points of the innermost separator

    def on_points(_data, _action, node):
        current[-1] = node
        return coin.SoCallbackAction.CONTINUE

    def on_begin(_data, _action, _node):
        current.append(current[-1])
        return coin.SoCallbackAction.CONTINUE

    def on_end(_data, _action, _node):
        current.pop()
        return coin.SoCallbackAction.CONTINUE

    def on_facets(_data, action, node):
        if current[-1] is not None:
            found.append((current[-1], node, np.array(action.getModelMatrix().getValue(), dtype=float)))
        return coin.SoCallbackAction.PRUNE  # or Coin would make every triangle one by one

    action = coin.SoCallbackAction()
    action.addPreCallback(coin.SoSeparator.getClassTypeId(), on_begin, None)
    action.addPostCallback(coin.SoSeparator.getClassTypeId(), on_end, None)
    action.addPreCallback(coin.SoCoordinate3.getClassTypeId(), on_points, None)
    action.addPreCallback(coin.SoIndexedFaceSet.getClassTypeId(), on_facets, None)
    action.apply(root)
    triangles = []
    for points, facets, matrix in found:
        key = int(points.this), int(facets.this)
        if key not in cache:
            # The facets of a map are many nodes that share one set of points.
            if key[0] not in cache:
                cache[key[0]] = points_of(points.getField("point"))
            rows = _triangles(numbers_of(facets.getField("coordIndex")))
            known = cache[key[0]]
            cache[key] = known[rows[(rows < len(known)).all(axis=1)]]
        # Coin's matrices are for row vectors.
        triangles.append(cache[key] @ matrix[:3, :3] + matrix[3, :3])
    return np.concatenate(triangles) if triangles else np.empty((0, 3, 3))


def _triangles(indices):
    """Split polygons, whose ends are marked by -1, into fans of triangles: ndarray of shape (n, 3)."""
    if len(indices) % 4 == 0 and (indices[3::4] < 0).all() and (indices.reshape(-1, 4)[:, :3] >= 0).all():
        return indices.reshape(-1, 4)[:, :3]
    if len(indices) and indices[-1] >= 0:
        indices = np.append(indices, -1)
    ends = np.flatnonzero(indices < 0)
    first = np.concatenate([[0], ends[:-1] + 1])[:len(ends)]
    row = np.arange(len(indices))
    polygon = np.searchsorted(ends, row)
    is_third = (row >= first[np.minimum(polygon, len(ends) - 1)] + 2) & (indices >= 0) if len(ends) else row < 0
    third = row[is_third]
    return np.column_stack([indices[first[polygon[third]]], indices[third - 1], indices[third]]).astype(np.int64)
