# SPDX-License-Identifier: LGPL-2.1-or-later
"""What should be a part and is none is told, and a shape that is older than its document too."""

import csv
import json

import jsonschema
import pytest
from program import SCHEMA, records, thinpart

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.reading.document_parts import document_content
from thinpart_workbench.workflow.analysis.analyse_part import analyse_part


def box(document, name, size=10):
    made = document.addObject("Part::Box", name)
    made.Length = made.Width = made.Height = size
    return made


def found(document):
    """Labels of the parts, and kinds of what is broken by label."""
    document.recompute()
    content = document_content(document)
    return ({part.label for part in content.parts},
            {broken.label: broken.kind for broken in content.broken})


def open_shell(size=10):
    import Part

    return Part.makeShell(Part.makeBox(size, size, size).Faces[:5])


def broken_body(document, name="Empty body"):
    body = document.addObject("PartDesign::Body", "Body")
    body.Label = name
    sketch = body.newObject("Sketcher::SketchObject", "Sketch")
    body.newObject("PartDesign::Pad", "Pad").Profile = sketch
    return body


def test_broken_parts_beside_a_good_one(document):
    import Part

    box(document, "Good", 20)
    document.addObject("Part::Feature", "Null")
    document.addObject("Part::Feature", "Shell").Shape = open_shell()
    document.addObject("Part::Feature", "Sheet").Shape = Part.makePlane(5, 5)
    document.addObject("Part::Feature", "Closed").Shape = Part.makeBox(3, 3, 3).Shells[0]
    document.addObject("Part::Feature", "Hollow").Shape = Part.Compound([])
    loose = document.addObject("Part::Feature", "Loose")
    loose.Shape = Part.Compound([face.copy() for face in Part.makeBox(4, 4, 4).Faces[:3]])
    broken_body(document)
    document.addObject("Mesh::Feature", "Scan")
    parts, broken = found(document)
    assert parts == {"Good"}
    assert broken == {**dict.fromkeys(
        ("Null", "Shell", "Sheet", "Closed", "Hollow", "Loose", "Empty body"), "no_solid"),
        "Scan": "empty"}


def test_broken_parts_in_containers_and_under_links_are_told_once(document):
    import Part

    box(document, "Good", 20)
    container = document.addObject("App::Part", "Unit")
    shell = document.addObject("Part::Feature", "Shell")
    shell.Shape = open_shell()
    container.addObject(shell)
    second = document.addObject("App::Link", "Second")
    second.LinkedObject = container
    hidden = document.addObject("Part::Feature", "Source")
    hidden.Shape = Part.makePlane(5, 5)
    hidden.Visibility = False
    array = document.addObject("App::Link", "Array")
    array.LinkedObject, array.ElementCount = hidden, 3
    assert found(document)[0] == {"Good"}
    assert sorted(found(document)[1].values()) == ["no_solid", "no_solid"]


def test_what_parts_are_made_with_is_silent(document, freecad):
    import Draft
    import Part

    good = box(document, "Good", 20)
    document.recompute()
    plane = document.addObject("Part::Feature", "Edge")
    plane.Shape = Part.makeBox(1, 1, 1).Edges[0]
    document.addObject("Part::Feature", "Wire").Shape = Part.makeBox(1, 1, 1).Wires[0]
    document.addObject("Part::Feature", "Point").Shape = Part.Vertex(1, 2, 3)
    for kind in ("Part::Plane", "Part::Circle", "Part::Line", "Part::Vertex", "Part::Helix",
                 "Sketcher::SketchObject", "PartDesign::Plane", "App::Part", "App::LinkGroup",
                 "App::Link", "App::DocumentObjectGroup", "App::FeaturePython",
                 "App::Annotation", "Spreadsheet::Sheet"):
        document.addObject(kind, "Silent")
    Draft.make_rectangle(10, 5, face=True)
    Draft.make_wire([freecad.Vector(0, 0, 0), freecad.Vector(9, 0, 0), freecad.Vector(0, 9, 0)],
                    closed=True, face=True)
    skeleton = document.addObject("PartDesign::Body", "Skeleton")
    skeleton.newObject("Sketcher::SketchObject", "Master")
    skeleton.newObject("PartDesign::Line", "Axis")
    binder = skeleton.newObject("PartDesign::SubShapeBinder", "Binder")
    binder.Support = [(good, ("Face1",))]
    assert found(document) == ({"Good"}, {})


def test_buildings_that_never_have_a_shape_are_silent(document):
    import Arch

    box(document, "Good", 20)
    Arch.makeAxis(3, 100)
    Arch.makeSectionPlane([])
    Arch.makeSite([])
    document.recompute()
    assert found(document) == ({"Good"}, {})


def test_what_a_boolean_uses_up_and_what_is_hidden_is_silent(document):
    import FreeCAD
    import Part

    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = box(document, "Base", 20), box(document, "Tool", 5)
    face = document.addObject("Part::Feature", "Profile")
    face.Shape = Part.makePlane(50, 50)
    block = document.addObject("Part::Extrusion", "Block")
    block.Base, block.DirMode, block.Dir = face, "Custom", FreeCAD.Vector(0, 0, 9)
    block.LengthFwd, block.Solid = 9, True
    leftover = document.addObject("Part::Feature", "Old")
    leftover.Shape, leftover.Visibility = open_shell(), False
    assert found(document) == ({"Cut", "Block"}, {})


def test_a_boolean_without_result_is_told_and_not_what_it_used_up(document):
    common = document.addObject("Part::Common", "Overlap")
    common.Base, common.Tool = box(document, "One"), box(document, "Two")
    common.Tool.Placement.Base.x = 100
    box(document, "Good", 20)
    assert found(document) == ({"Good"}, {"Overlap": "no_solid"})


def test_a_body_that_is_an_open_shell(document):
    import Part

    box(document, "Good", 20)
    surface = document.addObject("Part::Feature", "Surface")
    surface.Shape = Part.makeShell(Part.makeBox(9, 9, 9).Faces[:4])
    body = document.addObject("PartDesign::Body", "Body")
    body.BaseFeature = surface
    parts, broken = found(document)
    if not body.Shape.Solids:
        assert parts == {"Good"} and "Body" in broken
        return
    # FreeCAD 1.0 makes a solid of an open shell: it is measured, and not taken for a good one.
    assert parts == {"Good", "Body"}
    part = next(part for part in document_content(document).parts if part.name == "Body")
    _, record = analyse_part(part, AnalysisSettings(), load_profile("paper"))
    assert record["category"] == "unknown" and not record["descriptors"]["watertight"]


def test_only_what_is_hidden_is_left_and_broken(document):
    leftover = document.addObject("Part::Feature", "Old")
    leftover.Shape, leftover.Visibility = open_shell(), False
    assert found(document) == (set(), {"Old": "no_solid"})


def test_failures_of_a_document_are_told_everywhere_and_again(tmp_path, document):
    box(document, "Good", 20)
    shell = document.addObject("Part::Feature", "Shell")
    shell.Shape, shell.Label = open_shell(), "Left cover"
    broken_body(document)
    document.recompute()
    file = tmp_path / "made.FCStd"
    document.saveAs(str(file))
    info = tmp_path / "made.FCStd.thinpart.json"
    written = None
    for _ in range(2):  # measured, then taken from the info file
        run = thinpart("classify", file, "--json")
        good, body, cover = _by_label(run)
        assert run.returncode == 1 and good["category"] == "normal"
        assert body["file"] == cover["file"] == str(file)
        assert cover["error"]["kind"] == body["error"]["kind"] == "no_solid"
        assert "'Left cover'" in cover["error"]["message"] and "'Left cover'" in run.stderr
        assert "'Empty body'" in body["error"]["message"]
        content = json.loads(info.read_text(encoding="utf-8"))
        jsonschema.validate(content, SCHEMA)
        assert {each["label"] for each in content["failures"]} == {"Left cover", "Empty body"}
        assert written in (None, info.stat().st_mtime_ns)
        written = info.stat().st_mtime_ns
    table = tmp_path / "table.csv"
    run = thinpart("classify", file, "--csv", table)
    assert run.returncode == 1 and "failed: no_solid" in run.stdout and "Left cover" in run.stdout
    with open(table, newline="", encoding="utf-8") as lines:
        rows = {row["label"]: row["error_kind"] for row in csv.DictReader(lines)}
    assert rows == {"Good": "", "Left cover": "no_solid", "Empty body": "no_solid"}


def _by_label(run):
    lines = {line["label"]: line for line in records(run)}
    assert lines.keys() == {"Good", "Empty body", "Left cover"}
    return lines["Good"], lines["Empty body"], lines["Left cover"]


def test_a_document_of_broken_parts_only_names_them_all(tmp_path, document):
    for label in ("Left", "Right"):
        document.addObject("Part::Feature", "Shell").Label = label
    file = tmp_path / "made.FCStd"
    document.saveAs(str(file))
    run = thinpart("classify", file, "--json")
    assert run.returncode == 1 and [line["label"] for line in records(run)] == ["Left", "Right"]
    assert all(line["error"]["kind"] == "no_solid" for line in records(run))
    assert not list(tmp_path.glob("*.json"))
    assert thinpart("classify", file).stdout.count("failed: no_solid") == 2


# -- shapes that are older than their document


def stale_fillet(document):
    fillet = document.addObject("Part::Fillet", "Fillet")
    fillet.Base = box(document, "Base")
    document.recompute()
    fillet.Edges = [(1, 1.0, 1.0)]
    document.recompute()
    fillet.Edges = [(1, 30.0, 30.0)]
    return fillet


def stale_cut(document):
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = box(document, "Base"), box(document, "Tool", 5)
    document.recompute()
    document.removeObject("Tool")
    return cut


def stale_body(document):
    body = document.addObject("PartDesign::Body", "Body")
    block = body.newObject("PartDesign::AdditiveBox", "Block")
    document.recompute()
    fillet = body.newObject("PartDesign::Fillet", "Round")
    fillet.Base, fillet.Radius = (block, ["Edge1"]), 1
    document.recompute()
    fillet.Radius = 500
    return body


def stale_copy(document):
    source = box(document, "Base")
    copy = document.addObject("Part::Mirroring", "Copy")
    copy.Source = document.addObject("Part::Fillet", "Fillet")
    copy.Source.Base, copy.Source.Edges = source, [(1, 1.0, 1.0)]
    copy.Source.Visibility = False
    document.recompute()
    copy.Source.Edges = [(1, 30.0, 30.0)]
    return copy


@pytest.mark.parametrize("made", [stale_fillet, stale_cut, stale_body, stale_copy])
def test_a_shape_whose_last_recompute_failed_is_warned_of(tmp_path, document, made):
    made(document)
    document.recompute()
    file = tmp_path / "stale.FCStd"
    document.saveAs(str(file))
    record, = records(thinpart("classify", file, "--json", "--no-info"))
    warning, = (text for text in record["warnings"] if "recompute" in text)
    assert "failed" in warning and "recompute the document" in warning
    assert f"'{record['label']}'" in warning


def test_what_is_up_to_date_or_only_moved_is_not_warned_of(tmp_path, document):
    body = stale_body(document)
    document.recompute()
    document.getObject("Round").Radius = 1
    document.recompute()
    body.Placement.Base.x = 50  # touched, not recomputed
    after = body.newObject("PartDesign::Fillet", "After")
    after.Base, after.Radius = (document.getObject("Round"), ["Edge1"]), 500
    body.Tip = document.getObject("Round")
    document.recompute()
    assert "Invalid" in after.State
    file = tmp_path / "fresh.FCStd"
    document.saveAs(str(file))
    record, = records(thinpart("classify", file, "--json", "--no-info"))
    assert record["warnings"] == []


def test_faces_beside_the_solids_of_one_shape_are_warned_of(tmp_path, document):
    import FreeCAD
    import Part

    block, plate = Part.makeBox(10, 10, 10), Part.makePlane(5, 5, FreeCAD.Vector(50, 0, 0))
    document.addObject("Part::Feature", "Both").Shape = Part.Compound([block, plate])
    file = tmp_path / "made.FCStd"
    document.saveAs(str(file))
    Part.Compound([block, plate]).exportBrep(str(tmp_path / "made.brep"))
    for record in records(thinpart("classify", file, tmp_path / "made.brep", "--json", "--no-info")):
        assert any("1 face beside its solids" in text for text in record["warnings"])
    neighbours = Part.makeBox(10, 10, 10).generalFuse(
        [Part.makeBox(10, 10, 10, FreeCAD.Vector(10, 0, 0))])[0]
    assert len(neighbours.Faces) == 11
    neighbours.exportBrep(str(tmp_path / "two.brep"))
    lines = records(thinpart("classify", tmp_path / "two.brep", "--json", "--no-info"))
    assert [line["warnings"] for line in lines] == [[], []]
