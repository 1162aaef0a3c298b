# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the faces of a solid lie beside each other, whatever their sizes: what the parts of a family have in common."""

import hashlib

import numpy as np

from ..columns import dot

ROUNDS = 4
"""Steps over which faces know their neighbours."""

_SMOOTH = np.radians(12.0)
"""Facets of two faces that go over into each other smoothly are turned by less."""


def topology(mesh, kinds):
    """A text that is the same for parts whose faces are of the same kinds and lie beside each other in the same way.

    By the colours of Weisfeiler and Lehman (1968) on the graph of faces: the colour of a face follows from its kind, and
    from the colours of its neighbours, each with whether they meet convexly, smoothly or not. A part and its mirror image
    have one; parts that differ may have one too, seldom.

    Parameters
    ----------
    mesh : SurfaceMesh
    kinds : list of str
        By face, on which kind of surface it lies.

    Returns
    -------
    str
        Sixteen hexadecimal digits.
    """
    first, second, way = neighbouring_faces(mesh)
    colours = [_digest(kind) for kind in kinds]
    for _ in range(ROUNDS):
        around: list = [[] for _ in kinds]
        for one, other, how in zip(first, second, way):
            around[one].append(f"{how}{colours[other]}")
            around[other].append(f"{how}{colours[one]}")
        colours = [_digest(colour + ",".join(sorted(near))) for colour, near in zip(colours, around)]
    return _digest(",".join(sorted(colours)))


def neighbouring_faces(mesh):
    """Pairs of faces that share edges, and how they meet in most of them: -1 hollow, 0 smoothly, 1 convex; each once."""
    one, other = (side // 3 for side in mesh.shared_sides)
    faces = mesh.face_of_triangle[one], mesh.face_of_triangle[other]
    between = np.flatnonzero(faces[0] != faces[1])
    if not len(between):
        return (), (), ()
    one, other = one[between], other[between]
    normals = mesh.normals
    towards = mesh.corners[other].mean(axis=1) - mesh.corners[one].mean(axis=1)
    rise = dot(towards.T, normals[one].T) / np.maximum(np.linalg.norm(towards, axis=1), np.finfo(float).tiny)
    turned = np.arccos(np.clip(dot(normals[one].T, normals[other].T), -1.0, 1.0))
    way = np.where(turned < _SMOOTH, 0, np.where(rise < 0.0, 1, -1))
    low, high = np.minimum(faces[0][between], faces[1][between]), np.maximum(faces[0][between], faces[1][between])
    pairs, which = np.unique(np.column_stack([low, high]), axis=0, return_inverse=True)
    sides = mesh.shared_sides[0][between]
    start, end = mesh.corners[sides // 3, sides % 3], mesh.corners[sides // 3, (sides + 1) % 3]
    length = np.linalg.norm(end - start, axis=1)
    votes = np.bincount(which.ravel(), length * way, minlength=len(pairs)) / np.bincount(which.ravel(), length)
    return pairs[:, 0].tolist(), pairs[:, 1].tolist(), np.rint(votes).astype(int).tolist()


def _digest(text):
    return hashlib.blake2b(text.encode(), digest_size=8).hexdigest()
