# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles measured by a program that has no FreeCAD."""

import subprocess
import sys

import made_meshes
import numpy as np
import pytest
from program import ROOT, environment

import thinpart_workbench as thinpart

PLATE = made_meshes.box(100, 80, 2)

WITHOUT_FREECAD = """
import sys


class Refused:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("FreeCAD", "FreeCADGui", "Part", "Mesh", "MeshPart"):
            raise ImportError(name)


sys.meta_path.insert(0, Refused())
import made_meshes
import thinpart_workbench as thinpart

plate = made_meshes.box(100, 80, 2)
print(thinpart.measure(*plate).thinnest_mm, thinpart.classify(plate)[0].category)
"""


def test_a_plate_has_its_measures():
    plate = thinpart.measure(*PLATE)
    assert plate.thinnest_mm == pytest.approx(2.0) and plate.box_mm == pytest.approx((100.0, 80.0, 2.0))
    assert plate.volume_mm3 == pytest.approx(16000.0) and plate.area_mm2 == pytest.approx(2 * (8000 + 360))
    assert plate.value("D2/D3") == pytest.approx(40.0) and plate.value("F[0;0.05]") == pytest.approx(8000 / 8360, abs=0.005)
    assert plate.is_watertight and plate.warnings == ()
    assert "thinnest_mm=2.0" in repr(plate) and len(repr(plate)) < 200


def test_a_part_is_checked_for_a_process():
    plate = thinpart.classify(PLATE)[0]
    assert plate.check("FDM").holds is True and plate.check("sand_casting").holds is False
    for name in ("wood", ""):
        with pytest.raises(thinpart.ThinPartError, match="sheet_metal"):
            plate.check(name)


def test_lists_will_do_for_arrays():
    points, triangles = (each.tolist() for each in PLATE)
    assert thinpart.measure(points, triangles).thinnest_mm == pytest.approx(2.0)


def test_an_open_surface_has_no_volume_and_says_so():
    measured = thinpart.measure(PLATE[0], PLATE[1][2:])
    assert measured.volume_mm3 is None and not measured.is_watertight and "open" in measured.warnings[0]


def test_faces_are_those_that_are_given():
    points, triangles = PLATE
    mine = 5 - np.arange(len(triangles)) // 2
    plate = thinpart.measure(points, triangles, face_of_triangle=mine)
    assert [each.face for each in plate.faces()] == list(range(6))
    thin = plate.faces(thinner_than=2.5)
    assert [each.area for each in thin] == pytest.approx([8000, 8000])
    assert {each.witness.opposite_face for each in thin} == {each.face for each in thin}
    across = {each.face for each in thin}
    corners = points[triangles[np.isin(mine, list(across))]]
    assert (np.ptp(corners[..., 2], axis=1) == 0).all(), "the two faces of 100 x 80 lie across z"
    assert [each.thin_share for each in thin] == [1.0, 1.0] and plate.faces(thinner_than=2.0) == []


def test_settings_and_progress():
    told = []
    rough = thinpart.measure(*PLATE, thinpart.AnalysisSettings(minimum_samples=500), report=told.append)
    assert len(rough.field.distance) < len(thinpart.measure(*PLATE).field.distance)
    assert told == sorted(told) and (told[0], told[-1]) == (0.0, 1.0)
    with pytest.raises(thinpart.ThinPartError, match="There is no measure 'guess'"):
        thinpart.AnalysisSettings(measure="guess")


@pytest.mark.parametrize("points, triangles, faces, kind, words", [
    (PLATE[0].ravel(), PLATE[1], None, "usage", "vertices must be an array of numbers of shape (n, 3)"),
    (PLATE[0][:, :2], PLATE[1], None, "usage", "has the shape (24, 2)"),
    ([[0, 0, 0], [1, 2]], PLATE[1], None, "usage", "vertices must be"),
    ([["a", "b", "c"]], PLATE[1], None, "usage", "vertices must be"),
    (None, PLATE[1], None, "usage", "vertices must be"),
    (PLATE[0], PLATE[1].astype(float), None, "usage", "triangles must be an array of whole numbers of shape (n, 3)"),
    (PLATE[0], PLATE[1][:, [0, 1, 2, 2]], None, "usage", "has the shape (12, 4)"),
    (PLATE[0], PLATE[1], [0, 1], "usage", "face_of_triangle must be an array of whole numbers of shape (12,)"),
    (PLATE[0], PLATE[1], -np.ones(12, int), "usage", "negative"),
    (PLATE[0], PLATE[1] + 20, None, "unreadable", "points that are not there"),
    (PLATE[0], -PLATE[1] - 1, None, "unreadable", "points that are not there"),
    (PLATE[0], [], None, "empty", "no triangles"),
    ([], PLATE[1], None, "unreadable", "points that are not there"),
    (PLATE[0] * np.nan, PLATE[1], None, "not_finite", "not finite"),
    (PLATE[0] * 0.0, PLATE[1], None, "zero_volume", "points coincide"),
])
def test_what_is_no_surface_is_one_sentence(points, triangles, faces, kind, words):
    with pytest.raises(thinpart.ThinPartError) as refused:
        thinpart.measure(points, triangles, face_of_triangle=faces)
    assert refused.value.kind == kind and words in str(refused.value)
    assert str(refused.value).endswith(".") and "\n" not in str(refused.value)


def test_a_quantity_that_does_not_exist_is_one_sentence():
    with pytest.raises(thinpart.ThinPartError, match="There is no quantity 'V/VB': there are V, A, D1") as refused:
        thinpart.measure(*PLATE).value("V/VB")
    assert refused.value.kind == "usage"


def test_freecad_is_not_needed():
    path = environment()["PYTHONPATH"] + f":{ROOT / 'tests'}"
    ran = subprocess.run([sys.executable, "-c", WITHOUT_FREECAD], env={**environment(), "PYTHONPATH": path},
                         capture_output=True, encoding="utf-8")
    assert ran.stdout == "2.0 thin\n", ran.stderr
