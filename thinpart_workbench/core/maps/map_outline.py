# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges that are drawn over a thickness map, so that people recognize the part."""

import numpy as np

from ..columns import dot
from .facet_refinement import side_keys

CREASE = np.radians(30.0)
"""Neighbouring facets of one face that meet at a larger angle have a line between them; meshes without faces need it."""


def outline(thickness_map):
    """Find the sides of facets where two B-Rep faces meet, where the surface has a crease, or where it ends.

    Returns an ndarray of shape (k, 2), int32: rows of `thickness_map.points`.
    """
    facets = thickness_map.facets.astype(np.int64)
    key = side_keys(facets, len(thickness_map.points)).ravel()
    # Each key is packed with its index into one integer, which sorts three times as fast as argsort.
    bits = int(max(len(key) - 1, 1)).bit_length()
    packed = np.sort(key << bits | np.arange(len(key)))
    key, order = packed >> bits, packed & ((1 << bits) - 1)
    new = np.flatnonzero(np.concatenate([[True], key[1:] != key[:-1]]))
    count = np.diff(np.append(new, len(key)))
    pairs = new[count == 2]
    one, other = order[pairs] // 3, order[pairs + 1] // 3
    normals = thickness_map.normals.T
    bent = dot(normals[:, one], normals[:, other]) < np.cos(CREASE)
    drawn = np.concatenate([pairs[(thickness_map.face[one] != thickness_map.face[other]) | bent], new[count != 2]])
    facet, corner = order[drawn] // 3, order[drawn] % 3
    return np.column_stack([thickness_map.facets[facet, corner], thickness_map.facets[facet, (corner + 1) % 3]])
