# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangulated solids with known measures, made with numpy alone.

Each function gives points of shape (v, 3) in mm and triangles of shape (n, 3), outward.
"""

import numpy as np


def box(a, b, c, cells=1):
    """A box with one corner at zero; `cells` squares of two triangles along each side."""
    points, triangles = [], []
    size = np.array([a, b, c], dtype=float)
    grid = np.linspace(0.0, 1.0, cells + 1)
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (0.0, 1.0):
            start = sum(map(len, points))
            first, second = np.meshgrid(grid, grid, indexing="ij")
            face = np.zeros((first.size, 3))
            face[:, u], face[:, v], face[:, axis] = first.ravel(), second.ravel(), end
            points.append(face * size)
            quads = _grid_triangles(cells, cells)
            triangles.append(start + (quads if end else quads[:, ::-1]))
    return np.concatenate(points), np.concatenate(triangles)


def _grid_triangles(rows, columns, stride=None):
    stride = columns + 1 if stride is None else stride
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    a = (i * stride + j).ravel()
    b, c, d = a + stride, a + stride + 1, a + 1
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def prism(polygon, height):
    """A simple polygon (counter-clockwise, need not be convex) extruded along z."""
    polygon = np.asarray(polygon, dtype=float)
    count = len(polygon)
    low = np.column_stack([polygon, np.zeros(count)])
    high = np.column_stack([polygon, np.full(count, float(height))])
    caps = np.array(_ears(polygon))
    sides = []
    for i in range(count):
        j = (i + 1) % count
        sides += [(i, j, j + count), (i, j + count, i + count)]
    return np.concatenate([low, high]), np.concatenate([caps[:, ::-1], caps + count, sides])


def _ears(polygon):
    """Triangles of a simple polygon by cutting ears."""
    left, triangles = list(range(len(polygon))), []

    def cross(o, a, b):
        return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])

    while len(left) > 3:
        for k, middle in enumerate(left):
            before, after = left[k - 1], left[(k + 1) % len(left)]
            p, q, r = polygon[before], polygon[middle], polygon[after]
            if cross(p, q, r) <= 0:
                continue
            others = [polygon[m] for m in left if m not in (before, middle, after)]
            if any(cross(p, q, x) >= 0 and cross(q, r, x) >= 0 and cross(r, p, x) >= 0
                   for x in others):
                continue
            triangles.append((before, middle, after))
            left.pop(k)
            break
        else:
            raise ValueError("not a simple counter-clockwise polygon")
    return triangles + [tuple(left)]


def ribbed_block(width=60.0, height=40.0, rib=6.0, rib_height=20.0, length=100.0):
    """A block with a rib over its whole length on top."""
    low, high = (width - rib) / 2, (width + rib) / 2
    return prism([(0, 0), (width, 0), (width, height), (high, height), (high, height + rib_height),
                  (low, height + rib_height), (low, height), (0, height)], length)


def wedge(angle=30.0, side=100.0, length=60.0):
    """A prism over an isosceles triangle with the given angle, degrees, at its tip."""
    half = np.radians(angle / 2)
    return prism([(0, 0), (side * np.cos(half), -side * np.sin(half)),
                  (side * np.cos(half), side * np.sin(half))], length)


def revolved(profile, steps=90):
    """A closed profile of (radius, z), turned about z; radii of 0 give triangles of no area, which are dropped.

    The profile runs so that the material is on its left.
    """
    profile = np.asarray(profile, dtype=float)
    turn = np.linspace(0.0, 2.0 * np.pi, steps, endpoint=False)
    points = np.stack([
        profile[:, 0] * np.cos(turn)[:, None], profile[:, 0] * np.sin(turn)[:, None],
        np.broadcast_to(profile[:, 1], (steps, len(profile))),
    ], axis=2)
    count = len(profile)
    triangles = []
    for i in range(steps):
        j = (i + 1) % steps
        for k in range(count):
            m = (k + 1) % count
            a, b, c, d = i * count + k, j * count + k, j * count + m, i * count + m
            triangles += [(a, b, c), (a, c, d)]
    return points.reshape(-1, 3), np.array(triangles)


def tube(outer=20.0, inner=18.0, length=60.0, steps=90):
    """A straight tube along z."""
    return revolved([(inner, 0), (outer, 0), (outer, length), (inner, length)], steps)


def sphere(radius=20.0, steps=90):
    """A sphere; near its poles the facets are slender."""
    polar = np.linspace(-np.pi / 2, np.pi / 2, steps // 2 + 1)[1:-1]
    rings = np.column_stack([radius * np.cos(polar), radius * np.sin(polar)])
    turn = np.linspace(0.0, 2.0 * np.pi, steps, endpoint=False)
    points = np.stack([
        rings[:, 0, None] * np.cos(turn), rings[:, 0, None] * np.sin(turn),
        np.broadcast_to(rings[:, 1, None], (len(rings), steps)),
    ], axis=2).reshape(-1, 3)
    south, north = len(points), len(points) + 1
    points = np.concatenate([points, [[0, 0, -radius], [0, 0, radius]]])
    triangles = []
    for i in range(steps):
        j = (i + 1) % steps
        triangles.append((south, j, i))
        last = (len(rings) - 1) * steps
        triangles.append((north, last + i, last + j))
        for k in range(len(rings) - 1):
            a, b, c, d = k * steps + i, k * steps + j, (k + 1) * steps + j, (k + 1) * steps + i
            triangles += [(a, b, c), (a, c, d)]
    return points, np.array(triangles)


def joined(*meshes):
    """Several meshes as one soup."""
    points, triangles, start = [], [], 0
    for some_points, some_triangles in meshes:
        points.append(some_points)
        triangles.append(some_triangles + start)
        start += len(some_points)
    return np.concatenate(points), np.concatenate(triangles)


def inverted(mesh):
    """The same triangles, inside-out."""
    return mesh[0], mesh[1][:, ::-1]


def spherical_shell(radius=20.0, wall=1.0, steps=90):
    """A hollow sphere."""
    return joined(sphere(radius, steps), inverted(sphere(radius - wall, steps)))


def moved(mesh, rotation=None, shift=(0.0, 0.0, 0.0), scale=1.0):
    """The mesh turned by a 3 x 3 matrix, scaled and shifted."""
    points = mesh[0] * scale
    if rotation is not None:
        points = points @ rotation.T
    return points + np.asarray(shift, dtype=float), mesh[1]


def wire(path, radius, closed=False, steps=24):
    """A round wire along points of shape (k, 3); nowhere may it run along z."""
    count = len(path)
    along = np.roll(path, -1, axis=0) - np.roll(path, 1, axis=0) if closed else np.gradient(path, axis=0)
    along = along / np.linalg.norm(along, axis=1)[:, None]
    first = np.cross(along, [0.0, 0.0, 1.0])
    first /= np.linalg.norm(first, axis=1)[:, None]
    second = np.cross(along, first)
    turn = np.linspace(0.0, 2.0 * np.pi, steps, endpoint=False)[None, :, None]
    points = path[:, None] + radius * (np.cos(turn) * first[:, None] + np.sin(turn) * second[:, None])
    sides = _round_sides(count if closed else count - 1, count, steps)
    if closed:
        return points.reshape(-1, 3), sides
    return _capped(points, sides)


def screw(diameter=10.0, pitch=1.5, turns=20, depth=0.92, steps=60, per_turn=12):
    """A thread, helical and without a head, around z; its crest and its root are an eighth of the pitch wide."""
    height, turn = np.linspace(0, turns * pitch, turns * per_turn + 1), np.linspace(0.0, 2.0 * np.pi, steps, endpoint=False)
    phase = (height[:, None] / pitch - turn / (2.0 * np.pi)) % 1.0
    radius = diameter / 2 - depth * np.clip((2.0 * np.abs(phase - 0.5) - 0.125) / 0.625, 0.0, 1.0)
    points = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.broadcast_to(height[:, None], radius.shape)], axis=2)
    return _capped(points, _round_sides(len(height) - 1, len(height), steps))


def _round_sides(gaps, count, steps):
    """Triangles between rings of points, each with the next."""
    i, k = np.meshgrid(np.arange(gaps), np.arange(steps), indexing="ij")
    here, there, ahead = i * steps, (i + 1) % count * steps, (k + 1) % steps
    a, b, c, d = ((start + place).ravel() for start, place in ((here, k), (here, ahead), (there, ahead), (there, k)))
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def _capped(rings, sides):
    """Points of rings, of shape (k, steps, 3), and of the middles of both ends; the triangles with those of the ends."""
    count, steps, _ = rings.shape
    here = np.arange(steps)
    ahead, last = (here + 1) % steps, (count - 1) * steps
    low, high = np.full(steps, count * steps), np.full(steps, count * steps + 1)
    points = np.concatenate([rings.reshape(-1, 3), rings[0].mean(axis=0)[None], rings[-1].mean(axis=0)[None]])
    return points, np.concatenate([sides, np.stack([low, ahead, here], 1), np.stack([high, last + here, last + ahead], 1)])
