# SPDX-License-Identifier: LGPL-2.1-or-later
"""Equal solids are one part, wherever they stand; mirror images and near likes are not."""

from functools import cached_property

import pytest

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad
from thinpart_workbench.freecad_adapter.reading.part_files import read_parts
from thinpart_workbench.freecad_adapter.shapes.equal_solids import equal_part
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
from thinpart_workbench.freecad_adapter.shapes.solid_measures import SolidMeasures

load_freecad()

import Part  # noqa: E402 - is found once FreeCAD is loaded
from FreeCAD import Placement, Rotation, Vector  # noqa: E402


def hand():
    """A solid that differs from its mirror image."""
    block = Part.makeBox(40, 25, 10).cut(Part.makeCylinder(3, 30, Vector(8, 7, -5)))
    block = block.fuse(Part.makeBox(5, 8, 12, Vector(30, 15, 10)))
    return block.makeFillet(1.5, [block.Edges[0]])


def turned(shape, x=100.0, angle=37.0):
    copy = shape.copy(True)
    copy.Placement = Placement(Vector(x, 3 * x, -x), Rotation(Vector(1, 2, 3), angle))
    return copy


def parts_of(tmp_path, *solids, ending=".step"):
    file = tmp_path / f"assembly{ending}"
    Part.makeCompound(list(solids)).exportStep(str(file))
    return [(part.name, part.instances) for part in read_parts(file).parts]


@pytest.mark.parametrize("make", [
    hand, lambda: Part.makeBox(3, 4, 5), lambda: Part.makeSphere(7), lambda: Part.makeTorus(20, 4),
    lambda: Part.makeCylinder(4, 9), lambda: Part.makeSphere(9).cut(Part.makeSphere(8)),
])
def test_copies_that_share_nothing_are_one_part(tmp_path, make):
    solids = [turned(make(), x, 20.0 + x) for x in (0.0, 100.0, 1000.0)]
    assert parts_of(tmp_path, *solids) == [("Solid1", 3)]


def test_a_mirror_image_is_another_part(tmp_path):
    mirrored = hand().mirror(Vector(0, 0, 0), Vector(1, 0, 0))
    assert parts_of(tmp_path, hand(), mirrored, turned(hand())) == [("Solid1", 2), ("Solid2", 1)]


def test_what_is_only_nearly_equal_is_another_part(tmp_path):
    plate = Part.makeBox(100, 60, 2)
    others = [Part.makeBox(100, 60, 2.001), Part.makeBox(60, 100.0002, 2)]
    # Equal volumes and areas, the hole elsewhere.
    drilled = [plate.cut(Part.makeCylinder(4, 10, Vector(x, 20, -5))) for x in (20, 35)]
    assert parts_of(tmp_path, plate, *others, *drilled) == [(f"Solid{n}", 1) for n in range(1, 6)]


def test_each_solid_is_measured_once_however_many_it_is_compared_with(monkeypatch):
    measured = []

    class Counting(SolidMeasures):
        @cached_property
        def volume(self):
            measured.append(self)
            return super().volume

    monkeypatch.setattr("thinpart_workbench.freecad_adapter.shapes.part.SolidMeasures", Counting)
    monkeypatch.setattr("thinpart_workbench.freecad_adapter.shapes.equal_solids.SolidMeasures", Counting)
    parts = []
    for number in range(20):
        solid = Part.makeBox(10 + number, 5, 3)
        assert equal_part(parts, solid) is None
        parts.append(SolidPart(f"Box{number}", "", shape=solid))
    assert equal_part(parts, turned(Part.makeBox(29, 5, 3))) is parts[19]
    assert len(measured) <= 2 * 21
