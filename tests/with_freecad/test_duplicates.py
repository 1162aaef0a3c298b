# SPDX-License-Identifier: LGPL-2.1-or-later
"""duplicates, as people call it, on a folder of real documents."""

import csv
import json
import shutil
from collections import defaultdict

import pytest
from program import records, thinpart

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad


@pytest.fixture(scope="module")
def drawer(tmp_path_factory):
    """A bracket and what people have made of it, beside parts that are none."""
    load_freecad()
    import FreeCAD as App
    import Part

    folder = tmp_path_factory.mktemp("drawer")
    turn = App.Placement(App.Vector(210, -40, 9), App.Rotation(App.Vector(1, 2, 0.5), 77))

    def export(name, shape, moved=True):
        shape = shape.copy()
        if moved:
            shape.Placement = turn.multiply(shape.Placement)
        getattr(shape, "exportStep" if name.endswith("step") else f"export{name.rpartition('.')[2].capitalize()}")(
            str(folder / name))

    bracket = _bracket()
    export("bracket.step", bracket, moved=False)
    shutil.copy(folder / "bracket.step", folder / "copy of bracket.step")
    export("turned.step", bracket)
    export("turned.brep", bracket)
    export("triangles.stl", bracket)
    export("left.step", bracket.mirror(App.Vector(), App.Vector(1, 0, 0)))
    inches = bracket.copy()
    inches.scale(1 / 25.4)
    export("inches.step", inches)
    export("longer.step", _bracket(length=64.0))
    export("drilled.step", bracket.cut(Part.makeCylinder(2.5, 20, App.Vector(12, 9, -5))))
    export("wider hole.step", _bracket(hole=4.1))
    export("ball.step", Part.makeSphere(12))
    export("ring.step", Part.makeTorus(30, 4))
    document = App.newDocument("kept")
    document.addObject("Part::Feature", "Angle").Shape = bracket
    document.recompute()
    document.saveAs(str(folder / "kept.FCStd"))
    App.closeDocument(document.Name)
    return folder


def _bracket(length=60.0, hole=4.0):
    """An angle with a slanted flange and two holes: not its own mirror image."""
    import FreeCAD as App
    import Part

    base = Part.makeBox(length, 30, 4)
    flange = Part.makeBox(4, 30, 25)
    lug = Part.makeBox(14, 8, 12, App.Vector(20, 22, 4))
    return base.fuse([flange, lug]).cut(Part.makeCylinder(hole, 20, App.Vector(45, 12, -5))).removeSplitter()


@pytest.fixture
def library(drawer, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    return shutil.copytree(drawer, tmp_path / "drawer", copy_function=shutil.copy2)


def kinds(lines):
    found = defaultdict(dict)
    for line in lines:
        for part in line["parts"]:
            found[line["kind"]][part["file"].rpartition("/")[2]] = part
    return found


def test_what_a_folder_has_more_than_once(library, tmp_path):
    run = thinpart("duplicates", library, "--json", "--jobs", 2, "--csv", tmp_path / "table.csv")
    assert run.returncode == 0, run.stderr
    lines = records(run)
    found = kinds(lines)
    same = {"kept.FCStd", "bracket.step", "copy of bracket.step", "turned.step", "turned.brep", "triangles.stl"}
    assert set(found["identical"]) == same
    # The document that can be edited is the one to keep.
    assert lines[0]["parts"][0]["kind"] == "reference" and lines[0]["parts"][0]["file"].endswith("kept.FCStd")
    for name, part in found["identical"].items():
        if name != "kept.FCStd":
            assert part["evidence"]["greatest_mm"] < (0.2 if name == "triangles.stl" else 1e-4), name
            assert part["evidence"]["compared"] == "geometry"
    assert set(found["mirrored"]) == {"kept.FCStd", "left.step"}
    assert found["mirrored"]["left.step"]["evidence"]["greatest_mm"] < 1e-4
    assert set(found["scaled"]) == {"kept.FCStd", "inches.step"}
    assert found["scaled"]["inches.step"]["evidence"]["scale"] == pytest.approx(1 / 25.4, rel=1e-5)
    assert set(found["alike"]) == {"kept.FCStd", "longer.step", "drilled.step", "wider hole.step"}
    evidence = {name: part["evidence"] for name, part in found["alike"].items()}
    assert "4 mm longer" in evidence["longer.step"]["says"].replace("\u00a0", " ")
    drilled = [each for each in evidence["drilled.step"]["differences"] if each["surface"] == "cylinder"]
    assert [each["radius_mm"] for each in drilled] == [2.5] and drilled[0]["of"] == "part"
    wider = {each["radius_mm"] for each in evidence["wider hole.step"]["differences"]}
    assert {4.0, 4.1} <= wider
    assert "ball.step" not in run.stdout and "ring.step" not in run.stdout
    rows = list(csv.DictReader((tmp_path / "table.csv").read_text().splitlines()))
    assert len(rows) == sum(len(line["parts"]) for line in lines)
    # The second run reads no documents again.
    (library / "turned.step").unlink()
    shutil.copy(library / "turned.brep", library / "turned.step")
    assert thinpart("duplicates", library, "--stored", "--json").returncode == 0


def test_copies_are_the_same_byte_by_byte_and_nothing_is_read_for_them(library):
    for file in list(library.iterdir()):
        if file.name not in ("bracket.step", "copy of bracket.step"):
            file.unlink()
    copy = library / "elsewhere"
    copy.mkdir()
    shutil.copy(library / "bracket.step", copy)
    assert thinpart("classify", library).returncode == 0
    line, = records(thinpart("duplicates", library, "--stored", "--json"))
    compared = {part["evidence"]["compared"] for part in line["parts"][1:]}
    assert line["kind"] == "identical" and len(line["parts"]) == 3 and "bytes" in compared


def test_a_document_that_is_gone_is_named_and_compared_by_its_record(library):
    assert thinpart("classify", library / "bracket.step", library / "turned.step").returncode == 0
    for file in list(library.iterdir()):
        if not file.name.startswith(("bracket.step", "turned.step.thin")):
            file.unlink()
    run = thinpart("duplicates", library, "--json")
    assert run.returncode == 1 and "turned.step" in run.stderr
    line, = records(run)
    assert line["kind"] == "identical" and line["parts"][1]["evidence"]["compared"] == "outlines"


def test_a_folder_with_nothing_twice_says_so(library):
    for file in list(library.iterdir()):
        if file.name not in ("ball.step", "ring.step"):
            file.unlink()
    run = thinpart("duplicates", library)
    assert run.returncode == 0 and run.stdout == "" and "2 parts compared: none of them is there twice." in run.stderr


def test_the_outline_of_a_record_can_be_damaged(library):
    assert thinpart("classify", library / "bracket.step", library / "turned.brep").returncode == 0
    info = library / "bracket.step.thinpart.json"
    content = json.loads(info.read_text())
    content["parts"][0]["form"]["outline"] = "AAAA"
    info.write_text(json.dumps(content))
    run = thinpart("duplicates", library, "--stored", "--json")
    assert run.returncode == 0 and run.stdout == ""


def test_records_alone_tell_the_same_kinds_but_of_triangles(library):
    assert thinpart("classify", library, "--jobs", 2).returncode == 0
    found = kinds(records(thinpart("duplicates", library, "--stored", "--json")))
    assert {"bracket.step", "turned.step", "turned.brep"} <= set(found["identical"])
    assert not {"drilled.step", "wider hole.step", "longer.step", "left.step"} & set(found["identical"])
    assert "left.step" in found["mirrored"] and "inches.step" in found["scaled"]
    assert {"drilled.step", "longer.step"} <= set(found["alike"])


def test_families_are_what_has_the_same_faces_in_other_sizes(library):
    assert thinpart("classify", library, "--jobs", 2).returncode == 0
    lines = records(thinpart("duplicates", library, "--stored", "--families", "--json"))
    family = next(line for line in lines if any(part["file"].endswith("longer.step") for part in line["parts"]))
    names = {part["file"].rpartition("/")[2] for part in family["parts"]}
    assert {"bracket.step", "longer.step", "wider hole.step"} <= names and "drilled.step" not in names
    sizes = {part["file"].rpartition("/")[2]: part["evidence"] for part in family["parts"]}
    assert sizes["longer.step"]["d1_mm"] == pytest.approx(64.0, abs=1e-3)
    assert {4.1} == {round(value, 6) for name, value in sizes["wider hole.step"].items() if "radius" in name}
    table = thinpart("duplicates", library, "--stored", "--families")
    assert table.returncode == 0 and "radius_1_mm" in table.stdout
    # A part that comes later changes no family but its own.
    (library / "longer.step.thinpart.json").unlink()
    (library / "longer.step").unlink()
    again = records(thinpart("duplicates", library, "--stored", "--families", "--json"))
    assert {part["file"] for part in family["parts"]} - {str(library / "longer.step")} in [
        {part["file"] for part in line["parts"]} for line in again]
