"""The lines of a thickness map that let people recognize the part."""

import numpy as np

from .facet_refinement import side_keys

CREASE = np.radians(30.0)
"""Neighbours of one face that meet at a larger angle have a line between them, as in a mesh without faces."""


def outline(shown):
    """Sides of facets where two B-Rep faces meet, where the surface has a crease, or where it ends.

    Parameters
    ----------
    shown : ThicknessMap

    Returns
    -------
    ndarray of shape (k, 2), int32
        Rows of `shown.points`.
    """
    facets = shown.facets.astype(np.int64)
    key = side_keys(facets, len(shown.points)).ravel()
    order = np.argsort(key, kind="stable")
    sorted_keys = key[order]
    first = np.flatnonzero(np.r_[True, sorted_keys[1:] != sorted_keys[:-1]])
    count = np.diff(np.r_[first, len(key)])
    pairs = first[count == 2]
    one, other = order[pairs] // 3, order[pairs + 1] // 3
    normal = np.cross(shown.corners[:, 1] - shown.corners[:, 0], shown.corners[:, 2] - shown.corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1), np.finfo(float).tiny)[:, None]
    bent = np.einsum("ij,ij->i", normal[one], normal[other]) < np.cos(CREASE)
    drawn = np.r_[pairs[(shown.face[one] != shown.face[other]) | bent], first[count != 2]]
    facet, corner = order[drawn] // 3, order[drawn] % 3
    return np.column_stack([shown.facets[facet, corner], shown.facets[facet, (corner + 1) % 3]])
