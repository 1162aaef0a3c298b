# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness maps in documents, without a window."""

import os
import subprocess
import sys
from pathlib import Path

import made_maps
import numpy as np
import pytest

from thinpart_workbench.api.document_maps import parts_of, set_parts
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.freecad_adapter.objects.thickness_object import (
    SHARE,
    is_thickness,
    motion,
    scale_of,
    thickness_objects,
)
from thinpart_workbench.freecad_adapter.objects.thickness_probes import Probe, probes_of, set_probes
from thinpart_workbench.freecad_adapter.occurrences.occurrences import sources_of
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.freecad_adapter.reading.document_parts import document_parts
from thinpart_workbench.freecad_adapter.shapes.placements import global_placement
from thinpart_workbench.freecad_adapter.shapes.source_signature import same_signature, signature

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def plate(document):
    """A plate, 2 mm thick."""
    box = document.addObject("Part::Box", "Plate")
    box.Length, box.Width, box.Height = 20, 30, 2
    document.recompute()
    return box


@pytest.fixture
def thickness(document, plate):
    return made_maps.add_map(document, plate)


def test_its_scale_is_that_of_the_walls(thickness):
    assert (scale_of(thickness).low, scale_of(thickness).high) == pytest.approx((2.0, 30.0), abs=1e-3)
    thickness.AutomaticRange = True
    assert (scale_of(thickness).low, scale_of(thickness).high) == pytest.approx((2.0, 30.0), abs=1e-3)
    assert thickness.Diagonal == pytest.approx(np.sqrt(400 + 900 + 4), rel=1e-4)
    assert thickness.Threshold == pytest.approx(7.0) and not thickness.Stale
    thickness.RangeUnit = SHARE
    assert thickness.Low == pytest.approx(2.0 / thickness.Diagonal)
    assert scale_of(thickness).high == pytest.approx(30.0, abs=1e-3)
    thickness.AutomaticRange = False
    thickness.High = 0.5
    assert scale_of(thickness).high == pytest.approx(0.5 * thickness.Diagonal)
    thickness.RangeUnit = "mm"
    assert thickness.High == pytest.approx(0.5 * thickness.Diagonal)
    thickness.AutomaticRange = True
    assert thickness.High == pytest.approx(30.0, abs=1e-3)


WANTED = {"HeatMapColours": "magma", "HeatMapReversed": True, "HeatMapBands": 5, "UnmeasuredColour": (1.0, 0.0, 0.0),
          "ThinLimit": "millimetres", "ThinLimitMillimetres": 2.5}


@pytest.fixture
def preferences(freecad):
    """Preferences other than the defaults, taken back afterwards."""
    for name, value in WANTED.items():
        set_preference(name, value)
    yield
    for name in WANTED:
        set_preference(name, None)


def test_a_new_one_begins_with_what_the_user_prefers(preferences, document, plate):
    thickness = made_maps.add_map(document, plate)
    scale = scale_of(thickness)
    assert (scale.colour_map, scale.reversed, scale.bands) == ("magma", True, 5)
    assert scale.unmeasured == pytest.approx((1.0, 0.0, 0.0)) and thickness.Threshold == 2.5


def test_it_is_stale_once_the_source_is_another_one_and_not_before(document, plate, thickness):
    plate.touch()
    document.recompute()
    assert not thickness.Stale
    plate.Height = 2.001
    document.recompute()
    assert thickness.Stale
    document.recompute()
    plate.Height = 2
    document.recompute()
    assert not thickness.Stale


def test_it_moves_with_its_source(freecad, document, plate, thickness):
    place = freecad.Placement(freecad.Vector(500, -7, 3), freecad.Rotation(freecad.Vector(1, 2, 3), 50))
    plate.Placement = place
    document.recompute()
    assert not thickness.Stale and motion(thickness).Base.isEqual(place.Base, 1e-9)
    container = document.addObject("App::Part", "Container")
    container.addObject(plate)
    container.Placement.Base = freecad.Vector(0, 0, 1000)
    document.recompute()
    thickness.Proxy.check(thickness)
    assert not thickness.Stale and motion(thickness).Base.z == pytest.approx(1003.0)


def test_sources_that_part_from_each_other_leave_it_stale(freecad, document, plate):
    other = document.addObject("Part::Box", "Other")
    other.Placement.Base.x = 100
    document.recompute()
    thickness = made_maps.add_map(document, plate, other)
    for each in (plate, other):
        each.Placement.move(freecad.Vector(1, 2, 3))
    document.recompute()
    assert not thickness.Stale
    other.Placement.Base.y += 0.01
    document.recompute()
    assert thickness.Stale and motion(thickness) is None


def test_a_link_to_a_container_that_moves_leaves_it_stale(freecad, document, plate):
    """The plate itself stays where it is, and FreeCAD knows two ways that lead to it."""
    container = document.addObject("App::Part", "Container")
    container.addObject(plate)
    link = document.addObject("App::Link", "Copy")
    link.LinkedObject = container
    link.Placement.Base.x = 100
    document.recompute()
    sources = sources_of(document, document_parts(document))
    assert {each.Name for each in sources} == {"Plate", "Copy"}
    assert global_placement(plate).Base.x == 0
    thickness = made_maps.add_map(document, *sources)
    link.Placement.Base.x = 130
    document.recompute()
    assert global_placement(plate).Base.x == 0 and thickness.Stale
    link.Placement.Base.x = 100
    document.recompute()
    assert not thickness.Stale


def test_one_of_many_holes_makes_another_shape(freecad, document):
    import Part

    def sieve(radius):
        holes = [Part.makeCircle(1 if (x, y) != (17, 21) else radius, freecad.Vector(3 * x + 2, 3 * y + 2))
                 for x in range(30) for y in range(40)]
        plate = Part.Face([Part.makePolygon([freecad.Vector(*each) for each in (
            (0, 0), (100, 0), (100, 130), (0, 130), (0, 0))]), *map(Part.Wire, holes)])
        return plate.extrude(freecad.Vector(0, 0, 2))

    feature = document.addObject("Part::Feature", "Sieve")
    feature.Shape = sieve(1)
    before = signature([feature])
    feature.Shape = sieve(1)
    assert same_signature(before, signature([feature]))
    feature.Shape = sieve(1.05)
    assert len(feature.Shape.Vertexes) > 2400 and not same_signature(before, signature([feature]))


def test_a_source_that_is_removed_leaves_it_stale(document, plate, thickness):
    document.removeObject(plate.Name)
    document.recompute()
    assert thickness.Stale and parts_of(thickness)


def test_signatures_tell_shapes_apart(freecad, document):
    import Part

    def of(shape):
        feature = document.addObject("Part::Feature", "F")
        feature.Shape = shape
        return signature([feature])

    v = freecad.Vector
    block = Part.makeBox(10, 10, 10)
    hole, moved = (block.cut(Part.makeCylinder(1, 10, v(x, 5, 0))) for x in (4, 6))
    seen = [of(each) for each in (
        block, hole, moved, Part.makeBox(10, 10, 10.000001), Part.makeTorus(10, 2), Part.makeTorus(11, 1),
        Part.makeSphere(5), block.mirror(v(5, 5, 5), v(1, 0, 0)).fuse(Part.makeBox(1, 1, 1, v(10, 0, 0))))]
    for number, one in enumerate(seen):
        assert [same_signature(one, other) for other in seen] == [
            number == other for other in range(len(seen))]
    assert max(map(len, seen)) < 200
    assert same_signature(of(block.cut(Part.makeCylinder(1, 10, v(4, 5, 0)))), seen[1])


def test_a_mesh_is_a_source(freecad, document):
    import Mesh

    feature = document.addObject("Mesh::Feature", "Scan")
    feature.Mesh = Mesh.createBox(10, 20, 3)
    thickness = made_maps.add_map(document, feature)
    feature.Placement = freecad.Placement(freecad.Vector(5, 6, 7), freecad.Rotation(10, 20, 30))
    document.recompute()
    assert not thickness.Stale
    feature.Mesh = Mesh.createBox(10, 20, 4)
    document.recompute()
    assert thickness.Stale


def test_undo_and_redo(document, plate):
    document.UndoMode = 1
    document.openTransaction("Show thickness")
    made_maps.add_map(document, plate)
    document.commitTransaction()
    document.undo()
    assert thickness_objects(document) == []
    document.redo()
    thickness, = thickness_objects(document)
    assert parts_of(thickness)[0].map.count and thickness.Sources == [plate]
    before = thickness.Thickest
    document.openTransaction("Measure again")
    plate.Length = 50
    document.recompute()
    set_parts(thickness, thickness.Sources, made_maps.mapped_parts(document))
    document.commitTransaction()
    assert not thickness.Stale and thickness.Thickest == pytest.approx(50.0, abs=1e-3)
    document.undo()
    document.recompute()
    assert thickness.Thickest == before and parts_of(thickness)[0].map.thickness[
        parts_of(thickness)[0].map.measured].max() == pytest.approx(30.0, abs=1e-3)
    assert not thickness.Stale
    document.redo()
    assert np.nanmax(parts_of(thickness)[0].map.thickness) == pytest.approx(50.0, abs=1e-3)


def test_measured_again_it_keeps_probes_that_still_lie_on_the_part(document, plate, thickness):
    set_probes(thickness, [Probe((5, 5, 0), (5, 5, 2), 2.0), Probe((5, 5, 2), (5, 5, 0), 2.0)])
    thickness.ColourMap, thickness.Threshold = "magma", 3.0
    plate.Height = 4
    document.recompute()
    assert set_parts(thickness, thickness.Sources, made_maps.mapped_parts(document)) == 1
    probe, = probes_of(thickness)
    assert probe.value == pytest.approx(4.0, abs=1e-4)
    assert probe.opposite == pytest.approx((5, 5, 4), abs=1e-4)
    assert (thickness.ColourMap, thickness.Threshold, thickness.Stale) == ("magma", 3.0, False)


def test_copied_with_its_map(freecad, document, thickness):
    other = freecad.newDocument("Other")
    try:
        copy = other.copyObject(thickness, True)
        assert is_thickness(copy) and copy.Map != thickness.Map
        assert np.array_equal(parts_of(copy)[0].map.points, parts_of(thickness)[0].map.points)
        assert not copy.Stale
    finally:
        freecad.closeDocument(other.Name)


def test_a_map_that_was_damaged_is_told_and_goes(document, thickness):
    os.chmod(thickness.Map, 0o600)
    Path(thickness.Map).write_bytes(b"PK no map")
    with pytest.raises(ThinPartError, match="cannot be read: measure the part again"):
        parts_of(thickness)
    document.recompute()
    document.removeObject(thickness.Name)
    assert thickness_objects(document) == []


_REOPEN = """
import sys
sys.path.insert(0, {root!r})
from thinpart_workbench.freecad_adapter.bootstrap import load_freecad
App = load_freecad()
if not {there}:
    sys.path.remove({root!r})
    for name in [name for name in sys.modules if name.startswith("thinpart_workbench")]:
        del sys.modules[name]
document = App.openDocument({file!r})
thickness = document.getObject("Thickness")
print("CAME", len(document.Objects), thickness.Stale, thickness.ProbeValues, thickness.ColourMap)
if {there}:
    from thinpart_workbench.api.document_maps import parts_of
    document.Plate.Height = 3
    document.recompute()
    print("THEN", thickness.Stale, parts_of(thickness)[0].map.count)
    document.saveAs({file!r} + ".again.FCStd")
"""


@pytest.mark.parametrize("there", [True, False], ids=["with ThinPart", "without ThinPart"])
def test_opened_by_another_process(document, thickness, tmp_path, there):
    set_probes(thickness, [Probe((5, 5, 0), (5, 5, 2), 2.0)])
    thickness.ColourMap = "magma"
    file = str(tmp_path / "part.FCStd")
    document.saveAs(file)
    done = subprocess.run(
        [sys.executable, "-c", _REOPEN.format(root=str(ROOT), file=file, there=there)],
        capture_output=True, encoding="utf-8", cwd=tmp_path)
    assert "CAME 2 False [2.0] magma" in done.stdout, done.stdout + done.stderr
    if there:
        assert f"THEN True {parts_of(thickness)[0].map.count}" in done.stdout, done.stdout + done.stderr
