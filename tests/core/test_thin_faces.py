# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which faces are shown as thin under another limit than the verdict's."""

import made_meshes
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.record.thin_faces import limit_in_millimetres, shown_limit_mm, thin_face_colours, with_limit
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.core.walls.face_thickness import face_thicknesses, thin_shares


def test_shares_are_those_of_the_faces_in_their_order():
    field = measure(surface_mesh(*made_meshes.ribbed_block()), AnalysisSettings(minimum_samples=2000)).field
    for limit in (1.0, 6.5, 50.0, 1000.0):
        plain = [_plain_share(field, face, limit) for face in sorted(set(field.face.tolist()))]
        assert thin_shares(field, limit) == pytest.approx(plain, abs=1e-12)
        assert [face.thin_share for face in face_thicknesses(field, limit)] == pytest.approx(plain, abs=1e-12)
    assert not thin_shares(field, 5.9).any()
    sides = [face for face in face_thicknesses(field, 6.5) if face.thin_share > 0.5]
    assert [face.minimum for face in sides] == pytest.approx([6.0, 6.0])


def _plain_share(field, face, limit):
    total = thin = 0.0
    for sample in range(len(field.distance)):
        if field.face[sample] == face:
            total += field.area[sample]
            measured = field.parallel[sample] or field.nonparallel[sample]
            thin += field.area[sample] if measured and field.distance[sample] < limit else 0.0
    return thin / total


def test_another_limit_changes_what_is_shown_and_nothing_else():
    face = {"area_mm2": 10.0, "min": 3.0}
    record = {"category": "thin", "thin_limit_mm": 5.0, "descriptors": {"area_mm2": 20.0}, "faces": [
        {"face": "Face1", "thin_share": 1.0, **face}, {"face": "Face2", "thin_share": 0.2, **face}]}
    shown = with_limit(record, 2.0, [0.0, 0.7])
    assert thin_face_colours(record, "red", "orange") == {0: "red", 1: "orange"}
    assert thin_face_colours(shown, "red", "orange") == {1: "red"}
    assert shown["thin_limit_mm"] == 2.0 and shown["category"] == "thin"
    assert record["thin_limit_mm"] == 5.0 and record["faces"][0]["thin_share"] == 1.0


@pytest.mark.parametrize("limit, expected", [
    ({"millimetres": 2.0}, 2.0), ({"share": 0.05}, 5.0), ({"millimetres": 5000.0}, 100.0)])
def test_a_limit_in_mm_or_as_a_share(limit, expected):
    assert limit_in_millimetres(limit, 100.0) == expected


@pytest.mark.parametrize("limit, median, shown", [
    (22.8, 1.4, 1.8),  # a sheet: that its walls are thinner than a tenth of its width says nothing of them
    (22.8, 20.0, 22.8), (5.0, 2.0, 5.0), (5.0, None, 5.0), (None, 2.0, None)])
def test_walls_of_a_sheet_are_shown_under_a_limit_that_is_about_them(limit, median, shown):
    assert shown_limit_mm({"thin_limit_mm": limit, "descriptors": {"thickness_mm": {"median": median}}}) == shown
