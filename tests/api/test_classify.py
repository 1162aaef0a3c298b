# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files, what FreeCAD holds and triangles, classified by a program."""

import json
import os
import shutil

import made_meshes
import pytest
from program import SAMPLES, records
from program import thinpart as command

import thinpart_workbench as thinpart
from thinpart_workbench.core.record.record_types import PART


def without_seconds(record):
    return {key: value for key, value in record.items() if key not in ("seconds", "file", "confinement")}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("parts")
    for name in ("ribbed_block.step", "assembly_of_three.FCStd"):
        shutil.copy(SAMPLES / name, folder)
    (folder / "damaged.step").write_bytes(b"ISO-10303-21;" + b"\0" * 1000)
    (folder / "nothing.link.step").symlink_to(folder / "gone.step")
    return folder


@pytest.fixture(scope="module")
def commanded(folder):
    """What the command line says about the folder: its JSON lines."""
    return records(command("classify", folder, "--json", "--no-info"))


def test_a_file_is_what_the_command_line_makes_of_it(folder, commanded):
    before = sorted(os.listdir(folder))
    parts = thinpart.classify(folder / "assembly_of_three.FCStd")
    assert sorted(os.listdir(folder)) == before, "nothing is written unless asked"
    assert len(parts) == 3 and parts.failures == () and not parts.reused and parts.seconds > 0
    told = [line for line in commanded if line["file"] == parts.file]
    assert [without_seconds(part.record) for part in parts] == [without_seconds(line) for line in told]
    assert PART.fault(parts[0].record, "part") is None and parts[0].measurement is None
    assert repr(parts[0]) == f"<ClassifiedPart {parts[0].label!r}: {parts[0].category}>"


def test_a_part_has_what_its_record_has(folder):
    part, = thinpart.classify(str(folder / "ribbed_block.step"))
    record, measured = part.record, part.record["descriptors"]
    assert (part.name, part.label, part.instances) == ("Solid1", "ribbed_block", 1)
    assert (part.category, list(part.criteria), part.margin) == (
        record["category"], record["criteria"], record["margin"])
    assert part.thinnest_mm == measured["thickness_mm"]["min"] and part.volume_mm3 == measured["volume_mm3"]
    assert part.error_mm == measured["thickness_mm"]["error_bound"] and part.area_mm2 == measured["area_mm2"]
    assert part.box_mm == tuple(measured["box_mm"]) and part.value("V/VBB") == pytest.approx(measured["volume_ratio"])
    assert part.evidence is record["evidence"] and part.borderline is record["borderline"]
    assert part.warnings == record["warnings"] and part.reason == ""
    walls = [face["min"] for face in part.faces if face["min"] is not None]
    assert len(part.faces_thinner_than(max(walls))) == sum(wall < max(walls) for wall in walls) > 0
    assert part.faces_thinner_than(min(walls)) == []
    with pytest.raises(thinpart.ThinPartError, match="There is no quantity 'V/'"):
        part.value("V/")


def test_an_info_file_is_written_and_taken_when_asked(folder, tmp_path):
    part = folder / "ribbed_block.step"
    first = thinpart.classify(part, write_info=tmp_path)
    assert os.listdir(tmp_path) == ["ribbed_block.step.thinpart.json"] and not first.reused
    again = thinpart.classify(part, write_info=tmp_path)
    assert again.reused and [each.record for each in again] == [each.record for each in first]
    assert not thinpart.classify(part, "paper", thinpart.AnalysisSettings(box="principal"), write_info=tmp_path).reused


@pytest.mark.parametrize("name, kind", [("damaged.step", "unreadable"), ("gone.step", "missing"),
                                        ("nothing.link.step", "missing")])
def test_a_file_that_cannot_be_read_is_one_error(folder, name, kind):
    with pytest.raises(thinpart.ThinPartError) as refused:
        thinpart.classify(folder / name)
    assert refused.value.kind == kind and name.partition(".")[0] in str(refused.value)


def test_many_files_come_as_they_end_with_what_failed(folder, commanded):
    told = []
    files = list(thinpart.classify_files([folder], jobs=2, report=lambda run: told.append((run.done, run.total))))
    assert told == [(0, 3), (1, 3), (2, 3), (3, 3)]
    assert sorted(map(os.path.basename, (file.file for file in files))) == [
        "assembly_of_three.FCStd", "damaged.step", "nothing.link.step", "ribbed_block.step"]
    failed = {os.path.basename(file.file): file.failures[0].kind for file in files if file.failures}
    assert failed == {os.path.basename(line["file"]): line["error"]["kind"] for line in commanded if "error" in line}
    assert failed == {"damaged.step": "unreadable", "nothing.link.step": "missing"}
    assert sum(map(len, files)) == len([line for line in commanded if "error" not in line]) == 4


def test_globs_choose_among_the_files_of_a_folder(folder):
    files = list(thinpart.classify_files(folder, include="r*"))
    assert [os.path.basename(file.file) for file in files] == ["ribbed_block.step"]
    with pytest.raises(thinpart.ThinPartError, match="There are no parts in") as refused:
        thinpart.classify_files(folder, exclude=["*"])
    assert refused.value.kind == "empty"


def test_a_run_stops_when_its_control_says_so(folder):
    control = thinpart.RunControl()
    files = thinpart.classify_files(folder, jobs=1, control=control)
    next(files)
    control.stop()
    with pytest.raises(thinpart.Cancelled):
        list(files)


@pytest.mark.parametrize("given, words", [
    ({"jobs": 0}, "0 jobs"), ({"jobs": True}, "True jobs"), ({"seconds": 0}, "0 seconds"),
    ({"seconds": float("nan")}, "nan seconds"), ({"megabytes": 10}, "10 MB"), ({"profile": "none"}, "There is no profile"),
    ({"profile": {"format": "thinpart-profile", "version": 1}}, "name is missing"),
    ({"cluster": "nowhere"}, "not the address"),
])
def test_what_cannot_be_meant_is_refused_before_anything_is_read(folder, given, words):
    with pytest.raises(thinpart.ThinPartError, match=words) as refused:
        thinpart.classify_files(folder, **given)
    assert refused.value.kind in ("usage", "profile")


def test_a_shape_is_measured_as_it_is_held(freecad):
    import Part

    lid = Part.makeBox(100, 80, 2)
    part, = thinpart.classify(lid)
    assert (part.category, part.instances, part.file) == ("thin", 1, None)
    assert part.thinnest_mm == pytest.approx(2.0) and PART.fault(part.record, "part") is None
    assert part.measurement.thinnest_mm == pytest.approx(2.0)
    assert {f"Face{each.face + 1}" for each in part.measurement.faces(thinner_than=3)} == {
        face["face"] for face in part.faces_thinner_than(3)} == {"Face5", "Face6"}


def test_equal_solids_of_a_shape_are_one_part(freecad):
    import Part

    lid, ball = Part.makeBox(100, 80, 2), Part.makeSphere(10, freecad.Vector(0, 0, 80))
    parts = thinpart.classify(Part.makeCompound([lid, lid.translated(freecad.Vector(0, 0, 40)), ball]))
    assert [(part.label, part.category, part.instances) for part in parts] == [
        ("shape (1)", "thin", 2), ("shape (2)", "normal", 1)]


def test_objects_and_documents_are_measured_as_they_are_open(freecad, document):
    group = document.addObject("App::Part", "Housing")
    lid = document.addObject("Part::Box", "Lid")
    lid.Length, lid.Width, lid.Height = 100, 80, 2
    block = document.addObject("Part::Box", "Block")
    group.addObject(lid)
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sheet = document.addObject("Part::Feature", "Sheet")
    document.recompute()
    sheet.Shape = block.Shape.Faces[0]
    for source, found in ((lid, ["Lid"]), (group, ["Lid"]), (block, ["Block"]), (document, ["Lid", "Block"])):
        parts = thinpart.classify(source)
        assert [part.label for part in parts] == found
        assert [failure.kind for failure in parts.failures] == (["no_solid"] if source is document else [])
    assert thinpart.classify(document)[0].category == "thin"
    failure, = thinpart.classify(document).failures
    assert (failure.part, failure.label) == ("Sheet", "Sheet") and "bound no solid" in failure.message
    for source in (sketch, sheet):
        with pytest.raises(thinpart.ThinPartError) as refused:
            thinpart.classify(source)
        assert refused.value.kind == "no_solid"


def test_meshes_of_freecad_and_of_a_document(freecad, document):
    import Mesh

    points, triangles = made_meshes.box(100, 80, 2)
    mesh = Mesh.Mesh([[tuple(corner) for corner in points[triangle]] for triangle in triangles])
    held = document.addObject("Mesh::Feature", "Scan")
    held.Mesh = mesh
    for source, label in ((mesh, "mesh"), (held, "Scan"), ((points, triangles), "mesh")):
        part, = thinpart.classify(source)
        assert (part.label, part.category) == (label, "thin") and part.thinnest_mm == pytest.approx(2.0, rel=1e-5)


def test_a_profile_may_be_given_in_any_way(tmp_path):
    content = {"format": "thinpart-profile", "version": 1, "name": "house", "categories": [
        {"name": "flat", "criteria": [{"id": "F1", "conditions": [
            {"quantity": "D2/D3", "comparison": ">", "value": 30}]}]}]}
    (tmp_path / "house.json").write_text(json.dumps(content))
    plate = made_meshes.box(100, 80, 2)
    for profile in (content, tmp_path / "house.json", str(tmp_path / "house.json")):
        assert thinpart.classify(plate, profile)[0].category == "flat"
    assert thinpart.classify(made_meshes.box(10, 10, 10), content)[0].category == "normal"


def test_whoever_reports_may_stop():
    told = []

    def report(fraction):
        told.append(fraction)
        if fraction > 0.1:
            raise thinpart.Cancelled

    with pytest.raises(thinpart.Cancelled):
        thinpart.classify(made_meshes.box(100, 80, 2), report=report)
    assert told == sorted(told) and told[-2] <= 0.1 < told[-1]


@pytest.mark.parametrize("source, options, kind, words", [
    (3, {}, "usage", "int is nothing that can be classified"),
    (None, {}, "usage", "NoneType is nothing"),
    (("a.step", "b.step"), {}, "usage", "classify_files"),
    ([[0.0, 1.0, 2.0]], {}, "usage", "vertices and triangles"),
    (os.path.dirname(__file__), {}, "usage", "is a folder: name a file in it"),
    (made_meshes.box(1, 1, 1), {"write_info": True}, "usage", "Only a file can have an info file"),
    (made_meshes.box(1, 1, 1), {"profile": "none"}, "profile", "There is no profile"),
    ((made_meshes.box(1, 1, 1)[0], []), {}, "empty", "no triangles"),
])
def test_what_cannot_be_classified_is_one_sentence(source, options, kind, words):
    with pytest.raises(thinpart.ThinPartError) as refused:
        thinpart.classify(source, **options)
    assert refused.value.kind == kind and words in str(refused.value)


def test_an_empty_shape_or_mesh_is_one_sentence(freecad):
    import Mesh
    import Part

    for source, kind in ((Part.Shape(), "empty"), (Mesh.Mesh(), "empty"), (Part.makePlane(10, 10), "no_solid")):
        with pytest.raises(thinpart.ThinPartError) as refused:
            thinpart.classify(source)
        assert refused.value.kind == kind
