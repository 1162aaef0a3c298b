# SPDX-License-Identifier: LGPL-2.1-or-later
"""Order of points along a Hilbert curve, in which neighbours are close in space."""

from functools import lru_cache

import numpy as np

BITS = 10
"""Bits per axis: 1024 cells along the longest side."""


def hilbert_order(points):
    """ndarray of shape (n,), int64: indices that sort points, ndarray of shape (3, n), along a Hilbert curve."""
    return np.argsort(hilbert_index(points), kind="stable")


def hilbert_index(points, bounds=None):
    """Compute the position of each point along a Hilbert curve: ndarray of shape (n,), uint64, below 2 ** 30.

    A Morton code is turned into a Hilbert index by a state table, two levels at a time (after
    Hamilton 2006, "Compact Hilbert Indices", Dalhousie CS-2006-07). The boxes of eight
    neighbours are a quarter smaller than in Morton order.

    Parameters
    ----------
    points : ndarray of shape (3, n)
    bounds : pair of ndarray of shape (3,), optional
        Lower and upper corner of the cells; by default those of the points.
    """
    low, high = (points.min(axis=1), points.max(axis=1)) if bounds is None else bounds
    side = max(float((high - low).max()), 1e-30)
    cells = np.maximum((points - low[:, None]) * ((2 ** BITS - 0.001) / side), 0.0).astype(np.uint32)
    np.minimum(cells, np.uint32(2 ** BITS - 1), out=cells)
    morton = sum(_spread_bits(cells[axis]) << np.uint32(axis) for axis in range(3))
    index_table, state_table = _two_level_tables()
    count = points.shape[1]
    state, index = np.zeros(count, dtype=np.uint32), np.zeros(count, dtype=np.uint32)
    for level in range(BITS // 2):
        shift = np.uint32(3 * BITS - 6 - 6 * level)
        entry = (state << np.uint32(6)) | ((morton >> shift) & np.uint32(63))
        index = (index << np.uint32(6)) | index_table[entry]
        state = state_table[entry]
    return index.astype(np.uint64)


def _spread_bits(cell):
    """Put two zero bits between the bits of a 10-bit number."""
    cell = (cell | (cell << np.uint32(16))) & np.uint32(0x030000FF)
    cell = (cell | (cell << np.uint32(8))) & np.uint32(0x0300F00F)
    cell = (cell | (cell << np.uint32(4))) & np.uint32(0x030C30C3)
    return (cell | (cell << np.uint32(2))) & np.uint32(0x09249249)


@lru_cache(maxsize=1)
def _two_level_tables():
    """Hilbert index and next state for each of 24 states and 64 pairs of octants, as flat arrays."""
    index_one = np.zeros((24, 8), dtype=np.uint32)
    state_one = np.zeros((24, 8), dtype=np.uint32)
    for entry in range(8):
        for direction in range(3):
            for octant in range(8):
                rank = _gray_rank(_rotate(octant ^ entry, -(direction + 1)))
                turned = entry ^ _rotate(_entry_corner(rank), direction + 1)
                axis = (direction + _exit_axis(rank) + 1) % 3
                index_one[entry * 3 + direction, octant] = rank
                state_one[entry * 3 + direction, octant] = turned * 3 + axis
    octants = np.arange(64)
    middle = state_one[:, octants >> 3]
    index_two = index_one[:, octants >> 3] * 8 + index_one[middle, octants & 7]
    return index_two.ravel().astype(np.uint32), state_one[middle, octants & 7].ravel()


def _rotate(octant, steps):
    steps %= 3
    return ((octant << steps) | (octant >> (3 - steps))) & 7


def _gray_rank(code):
    return (code ^ (code >> 1) ^ (code >> 2)) & 7


def _entry_corner(rank):
    if rank == 0:
        return 0
    even = 2 * ((rank - 1) // 2)
    return even ^ (even >> 1)


def _exit_axis(rank):
    """Axis along which the curve leaves: the number of trailing one bits of the (odd) rank, modulo 3."""
    if rank == 0:
        return 0
    odd = rank - 1 if rank % 2 == 0 else rank
    return ((odd ^ (odd + 1)).bit_length() - 1) % 3
