# SPDX-License-Identifier: LGPL-2.1-or-later
"""A record holds all that a verdict needs, and nothing that a JSON file cannot."""

import json
from types import SimpleNamespace

import made_meshes
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.descriptor_table import QUANTITIES
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.record.part_record import descriptors_of, part_record
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.core.walls.face_thickness import face_thicknesses
from thinpart_workbench.core.walls.thinnest_place import WallErrors

PAPER = load_profile("paper")
PART = SimpleNamespace(name="Part", label="A part", instances=1, warnings=(), face_surfaces=None)
SHAPES = {
    "plate": made_meshes.box(100, 100, 2), "ribbed block": made_meshes.ribbed_block(),
    "wedge": made_meshes.wedge(), "shell": made_meshes.spherical_shell(steps=40),
    "cube": made_meshes.box(10, 10, 10),
    "open box": (made_meshes.box(10, 10, 10)[0], made_meshes.box(10, 10, 10)[1][2:]),
}


def record_of(shape, settings=AnalysisSettings()):
    mesh = surface_mesh(*shape)
    measurement = measure(mesh, settings)
    verdict = classify(measurement.descriptors, PAPER)
    faces = face_thicknesses(measurement.field, 5.0)
    return measurement, verdict, part_record(
        PART, mesh, measurement, verdict, verdict, faces, WallErrors(0.01, 0.01, 0.01), 0.0)


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("measure_by", ["rays", "pairs"])
def test_the_same_verdict_from_the_file_alone(name, measure_by):
    measurement, verdict, record = record_of(SHAPES[name], AnalysisSettings(measure=measure_by))
    stored = json.loads(json.dumps(record, allow_nan=False))
    again = classify(descriptors_of(stored), PAPER)
    assert (again.category, again.criteria) == (verdict.category, verdict.criteria)
    assert again.margin == pytest.approx(verdict.margin, rel=1e-6)
    for quantity in QUANTITIES:
        bounds = "[{:g};{:g}]".format(*quantity.bounds) if quantity.bounds else ""
        assert descriptors_of(stored).value(quantity.name + bounds) == pytest.approx(
            measurement.descriptors.value(quantity.name + bounds), rel=1e-6)


def test_any_later_threshold_is_evaluated_from_the_record():
    measurement, _, record = record_of(SHAPES["ribbed block"])
    stored = descriptors_of(record)
    for low in range(0, 1000, 37):
        for high in range(low + 1, 1001, 113):
            assert stored.distribution.share(low / 1000, high / 1000) == pytest.approx(
                measurement.descriptors.distribution.share(low / 1000, high / 1000), abs=1e-8)


def test_faces_say_where():
    _, _, record = record_of(SHAPES["ribbed block"])
    thin = [face for face in record["faces"] if face["thin_share"] > 0.5]
    assert not thin  # the limit given here was 5 mm
    rib = [face for face in record["faces"] if face["min"] == pytest.approx(6)]
    assert len(rib) == 2 and {rib[0]["face"], rib[1]["face"]} == {
        rib[0]["witness"]["opposite_face"], rib[1]["witness"]["opposite_face"]}
    for face in rib:
        (x, _, _), (other, _, _) = face["witness"]["points"]
        assert {round(x), round(other)} == {27, 33}


def test_evidence_has_a_row_per_criterion_and_condition():
    _, verdict, record = record_of(SHAPES["plate"])
    assert [row["criterion"] for row in record["evidence"]] == [1, 2, 3, 4, 5, 6, 7]
    assert [row["criterion"] for row in record["evidence"] if row["holds"]] == record["criteria"]
    first = record["evidence"][0]["conditions"][0]
    assert first == {"quantity": "V/VBB", "value": 1.0, "comparison": ">", "threshold": 0.5,
                     "holds": True, "margin": 1.0, "error": None}
