# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of many faces or edges are one and the same."""


def same_shapes(shapes):
    """Number of each shape, list of int: those that are one and the same have one, by first appearance from 0."""
    known, numbers, count = {}, [], 0
    for shape in shapes:
        alike = known.setdefault(shape.hashCode(), [])
        number = next((number for other, number in alike if other.isSame(shape)), None)
        if number is None:
            number, count = count, count + 1
            alike.append((shape, number))
        numbers.append(number)
    return numbers
