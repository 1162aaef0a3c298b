# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays that are put into fields of Coin."""

import numpy as np
import pytest
from pivy import coin

from thinpart_workbench.gui.scene.coin_arrays import fill_numbers, fill_points


class _ListsOnly:
    """A field of a pivy that does not tell where its memory is."""

    def __init__(self, field):
        self._field = field

    def __getattr__(self, name):
        return getattr(self._field, name)

    def __getitem__(self, row):
        return self._field[row]

    def startEditing(self):
        self._field.startEditing()
        return object()


@pytest.mark.parametrize("wrap", [lambda field: field, _ListsOnly], ids=["memory", "lists"])
@pytest.mark.parametrize("count", [0, 1, 50_001])
def test_what_goes_in_is_there(wrap, count, rng):
    points, numbers, packed = coin.SoMFVec3f(), coin.SoMFInt32(), coin.SoMFUInt32()
    wanted = rng.normal(size=(count, 3)).astype(np.float32)
    fill_points(wrap(points), wanted)
    fill_numbers(wrap(numbers), np.arange(count) - 7)
    fill_numbers(wrap(packed), np.arange(count) + 0xFFFF0000, np.uint32)
    assert [each.getNum() for each in (points, numbers, packed)] == [count] * 3
    for row in {0, count // 2, count - 1} if count else ():
        assert tuple(points[row].getValue()) == pytest.approx(tuple(wanted[row]))
        assert numbers[row] == row - 7 and packed[row] == row + 0xFFFF0000
