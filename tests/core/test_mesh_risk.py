# SPDX-License-Identifier: LGPL-2.1-or-later
"""The risk of the automatic mesh: how it is judged, said and found."""

import json
from dataclasses import replace

import made_library
import pytest
from made_descriptors import A_BLOCK, part

from thinpart_workbench.core.judging.conditions import search_conditions
from thinpart_workbench.core.record.part_record import descriptors_of
from thinpart_workbench.core.record.record_types import PART
from thinpart_workbench.core.risk.mesh_risk import SHIPPED, judged_risk, read_mesh_risk, shipped_mesh_risk
from thinpart_workbench.core.risk.risk_sentence import risk_sentence
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.index.part_query import PartQuery
from thinpart_workbench.storage.part_table import measured_row
from thinpart_workbench.workflow.library.find_parts import find_parts

EASY = part(box=(100.0, 80.0, 60.0), fill=0.8, walls=[(0.4, 0.9)])
EDGES = {**A_BLOCK, "faces": 60, "shortest_edge_mm": 0.05, "short_edges": 40,
         "narrowest_face_mm": 0.04, "narrow_faces": 12, "thin_x": 0.01}
HARD = replace(part(box=(100.0, 80.0, 60.0), fill=0.1, walls=[(0.01, 0.9)]), hazards=EDGES)


def record_of(descriptors):
    """A part record with some of the measurements, and the risk by them."""
    record = made_library.record_of("cube")
    record["descriptors"]["diagonal_mm"] = descriptors.box.diagonal
    record["descriptors"]["hazards"] = descriptors.hazards or dict.fromkeys(A_BLOCK)
    return {**record, "mesh_risk": judged_risk(descriptors)}


def test_a_thick_block_has_little_and_a_thin_part_with_small_edges_much():
    easy, hard = judged_risk(EASY), judged_risk(HARD)
    assert easy["risk"] < 0.3 < 0.8 < hard["risk"] <= 1.0
    assert easy["reasons"] == [] and len(hard["reasons"]) >= 2


@pytest.mark.parametrize("change", [
    lambda step: part(box=(100.0, 80.0, 60.0), fill=0.8, walls=[(0.01, 0.3 * step + 1e-9), (0.4, 0.9 - 0.3 * step)]),
    lambda step: replace(EASY, hazards={**A_BLOCK, "thin_x": 0.3 / 3 ** step}),
    lambda step: replace(EASY, hazards={**A_BLOCK, "short_edges": 10 * step}),
    lambda step: replace(EASY, hazards={**A_BLOCK, "flattened_share": 0.2 * step}),
])
def test_it_rises_with_each_hazard(change):
    risks = [judged_risk(change(step))["risk"] for step in range(4)]
    assert risks == sorted(risks) and risks[0] < risks[-1]


def test_reasons_come_with_the_strongest_first_and_with_figures():
    record = record_of(HARD)
    raises = [reason["raises"] for reason in record["mesh_risk"]["reasons"]]
    assert raises == sorted(raises, reverse=True)
    sentence = risk_sentence(record)
    assert sentence.startswith("Risk of the automatic mesh: ") and sentence.endswith(".")
    assert "walls thinner than 2.83 mm over 90\u00a0% of the surface" in sentence
    assert "40 edges shorter than 4.24 mm, the shortest 0.05 mm, 1/283 of an element" in sentence


def test_a_part_of_triangles_has_an_unknown_risk_and_it_is_said_why():
    record = record_of(replace(EASY, hazards=None))
    assert record["mesh_risk"] == {"risk": None, "reasons": []}
    assert risk_sentence(record) == "Risk of the automatic mesh: unknown, triangles have no edges and faces."


def test_a_record_of_before_is_read_and_its_risk_is_unknown():
    record = record_of(EASY)
    del record["mesh_risk"], record["descriptors"]["hazards"]
    assert PART.fault(record, "part") is None
    assert judged_risk(descriptors_of(record))["risk"] is None
    assert risk_sentence(record) == (
        "Risk of the automatic mesh: unknown, an earlier version measured the part. Measure it again (classify --force).")
    assert measured_row("a.step", record).risk is None


def test_records_with_a_risk_are_as_defined_and_others_refused():
    record = record_of(HARD)
    assert PART.fault(record, "part") is None
    record["mesh_risk"]["risk"] = 1.5
    assert PART.fault(record, "part").startswith("part.mesh_risk.risk is 1.5")


def test_parts_are_found_by_it(tmp_path):
    easy, hard = record_of(EASY), record_of(HARD)
    before = {key: value for key, value in easy.items() if key != "mesh_risk"}
    for name, record in (("easy.step", easy), ("hard.step", hard), ("before.step", before)):
        made_library.store(tmp_path / "library", name, [record])
    with LibraryIndex(tmp_path / "library", tmp_path / "cache") as index:
        index.refresh()
        found, = find_parts(index, PartQuery(conditions=search_conditions("risk > 0.5")))
        other, = find_parts(index, PartQuery(conditions=search_conditions("risk <= 0.5 and D1 > 0")))
    assert found.file.endswith("hard.step") and other.file.endswith("easy.step")
    assert found.risk == hard["mesh_risk"]["risk"] == measured_row("hard.step", hard).risk


def test_the_shipped_model_says_what_it_was_learned_from():
    content = json.loads(SHIPPED.read_text(encoding="utf-8"))
    assert 0 < content["trouble"] < content["parts"] and content["repositories"] > 20
    assert 0.5 < content["left_out"]["auc"] <= 1.0
    assert len(shipped_mesh_risk().terms) == len(content["terms"]) <= 6


@pytest.mark.parametrize("change, problem", [
    ({"terms": []}, "mesh_risk.terms"),
    ({"terms": [{"quantity": "Q", "weight": 1.0, "usual": 0.0}]}, "terms[0] names 'Q', which is no quantity"),
    ({"intercept": "none"}, "mesh_risk.intercept is"),
])
def test_a_model_that_cannot_be_used_is_refused(tmp_path, change, problem):
    path = tmp_path / "risk.json"
    path.write_text(json.dumps({**json.loads(SHIPPED.read_text(encoding="utf-8")), **change}), encoding="utf-8")
    with pytest.raises(ValueError) as caught:
        read_mesh_risk(path)
    assert problem in str(caught.value)
