# SPDX-License-Identifier: LGPL-2.1-or-later
"""IGES files, which hold loose faces, are read as the solids that they were written from."""

import pytest
from program import records, thinpart

from thinpart_workbench.freecad_adapter.reading.shape_parts import solids_of


def plate_with_a_hole():
    import FreeCAD
    import Part

    return Part.makeBox(30, 20, 3).cut(Part.makeCylinder(4, 3, FreeCAD.Vector(15, 10, 0)))


def stepped_shaft():
    import Part

    return Part.makeCylinder(4, 10).fuse(Part.makeCylinder(8, 5))


def hole_that_opens_into_a_slot():
    """Beside faces of the slot, the border of the hole is two arcs, elsewhere one circle."""
    import FreeCAD
    import Part

    slot = Part.makeBox(8, 20, 5, FreeCAD.Vector(15, 0, 5))
    return Part.makeBox(30, 20, 10).cut(Part.makeCylinder(4, 10, FreeCAD.Vector(15, 10, 0)).fuse(slot))


def crossing_pipes():
    """Two round surfaces meet along a curve that no plane has."""
    import FreeCAD
    import Part

    return Part.makeCylinder(8, 40).fuse(Part.makeCylinder(5, 30, FreeCAD.Vector(0, 0, 20), FreeCAD.Vector(1, 0.2, 0)))


SHAPES = [plate_with_a_hole, stepped_shaft, hole_that_opens_into_a_slot, crossing_pipes]


def from_iges(shape, path):
    import Part

    shape.exportIges(str(path))
    return Part.read(str(path))


@pytest.mark.parametrize("is_turned", [False, True], ids=["straight", "turned"])
@pytest.mark.parametrize("make", SHAPES, ids=lambda make: make.__name__)
def test_a_solid_comes_back_from_iges(make, is_turned, tmp_path):
    import FreeCAD

    shape = make()
    if is_turned:
        shape.Placement = FreeCAD.Placement(FreeCAD.Vector(11, -7, 3), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 47))
    loose = from_iges(shape, tmp_path / "part.iges")
    (solid,), (warning,) = solids_of(loose)
    assert solid.isValid() and abs(solid.Volume) == pytest.approx(shape.Volume, rel=1e-6)
    assert solid.Area == pytest.approx(shape.Area, rel=1e-6)
    assert warning == f"It came as {len(loose.Faces)} loose faces, which were sewn together."


def test_what_does_not_close_is_no_solid_and_is_told_beside_one_that_does(tmp_path):
    import FreeCAD
    import Part

    cylinder = Part.makeCylinder(4, 10, FreeCAD.Vector(50, 0, 0))
    open_cylinder = Part.Compound(cylinder.Faces[:2])
    assert solids_of(from_iges(open_cylinder, tmp_path / "open.iges")) == ([], ())
    both = Part.Compound([*plate_with_a_hole().Faces, *open_cylinder.Faces])
    (solid,), warnings = solids_of(from_iges(both, tmp_path / "both.iges"))
    assert abs(solid.Volume) == pytest.approx(plate_with_a_hole().Volume, rel=1e-6)
    assert warnings == ("It came as 9 loose faces, which were sewn together.",
                        "The file holds 2 faces beside its solids, which were left out: close or thicken them if they "
                        "are a part.")


def test_faces_that_only_touch_stay_apart(tmp_path):
    import FreeCAD
    import Part

    # A cap with a border as long as the other's, beside it.
    apart = Part.Compound([*Part.makeCylinder(4, 10).Faces[:2],
                           Part.makeCylinder(4, 10, FreeCAD.Vector(0, 0, -10.5)).Faces[1]])
    assert solids_of(from_iges(apart, tmp_path / "apart.iges")) == ([], ())


def test_the_thinnest_wall_of_an_iges_file(tmp_path):
    plate_with_a_hole().exportIges(str(tmp_path / "plate.igs"))
    record, = records(thinpart("classify", tmp_path / "plate.igs", "--json"))
    assert record["thinnest"]["parallel_mm"] == pytest.approx(3.0, rel=1e-6)
