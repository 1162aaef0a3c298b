# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program as people start it, on real files."""

import csv
import json
import os
import re
import shutil
from pathlib import Path

import jsonschema
import pytest
from program import ROOT, SAMPLES, SCHEMA, records, thinpart


@pytest.mark.timeout(180)  # all samples are measured
def test_every_sample_gets_its_verdict_in_both_formats():
    run = thinpart("classify", SAMPLES, "--json", "--no-info")
    assert run.returncode == 0, run.stderr
    expected = {
        entry["name"]: entry.get("solids") or [entry]
        for entry in json.loads((SAMPLES / "samples.json").read_text(encoding="utf-8"))
    }
    found = {}
    for record in records(run):
        found.setdefault(Path(record["file"]), []).append(record)
    assert len(found) == 2 * len(expected) >= 24
    for file, parts in found.items():
        # A STEP file does not say which solids are copies of one.
        verdicts = {(part["category"], part["paper"]["category"], tuple(part["paper"]["criteria"])) for part in parts}
        assert verdicts == {(each["category"], each["paper"]["category"], tuple(each["paper"]["criteria"]))
                            for each in expected[file.stem]}, file
    criteria = {each for parts in found.values() for part in parts for each in part["paper"]["criteria"]}
    assert criteria == {1, 2, 3, 4, 5, 6, 7}


def test_an_assembly_gives_one_record_per_distinct_solid():
    run = thinpart("classify", SAMPLES / "assembly_of_three.FCStd", "--json", "--no-info")
    assert {(each["label"], each["instances"]) for each in records(run)} == {
        ("Base block", 1), ("Cover plate", 1), ("Dowel pin", 2)}


def test_table_names_part_category_criteria_box_fill_and_wall(tmp_path):
    run = thinpart("classify", SAMPLES / "plate.FCStd", "--info-dir", tmp_path, "--profile", "paper")
    assert run.returncode == 0
    header, row = run.stdout.splitlines()[:2]
    assert header.split() == "Part Category Mesh risk Criteria D1 x D2 x D3 mm V/VBB Thinnest mm".split()
    assert re.match(r"Mounting plate\s+thin\s+\d+ %\s+1, 4, 5\s+[\d.]+ x [\d.]+ x [\d.]+\s+0\.\d+\s+[\d.]+$", row)


def test_what_the_paper_would_say_of_a_single_file_stands_below_the_table():
    said = "Shaft: By the paper's criteria: thin (criterion 4: "
    assert said in thinpart("classify", SAMPLES / "shaft.FCStd", "--no-info").stdout
    assert "paper" not in thinpart("classify", SAMPLES / "shaft.FCStd", "--no-info", "--profile", "paper").stdout
    assert "paper" not in thinpart("classify", SAMPLES / "plate.FCStd", "--no-info").stdout  # thin by both
    several = thinpart("classify", SAMPLES / "shaft.FCStd", SAMPLES / "plate.FCStd", "--no-info").stdout
    assert "Shaft" in several and "paper" not in several


@pytest.mark.timeout(180)  # all samples are measured
def test_demo_classifies_the_samples_and_leaves_nothing_behind():
    before = sorted(SAMPLES.iterdir())
    run = thinpart("demo")
    assert run.returncode == 0 and "thin_features" in run.stdout and "Worm" in run.stdout
    assert sorted(SAMPLES.iterdir()) == before


@pytest.mark.timeout(180)  # some of these parts are large
def test_real_parts_are_read_and_the_papers_sure_finds_are_found(real_samples):
    with open(real_samples / "manifest.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    run = thinpart("classify", real_samples / "parts", "--json", "--no-info", "--profile", "paper")
    assert run.returncode == 0, run.stderr
    category = {}
    for record in records(run):
        category.setdefault("parts/" + Path(record["file"]).name, set()).add(record["category"])
    assert category.keys() == {row["file"] for row in rows}
    for row in rows:
        if row["expert_label"] == "thin" and row["confidence"] == "sure":
            assert "thin" in category[row["file"]], row["file"]
    assert not any("unknown" in found for found in category.values())


FORMATS = ["step", "iges", "brep", "stl", "ascii.stl", "obj", "ply", "off"]


@pytest.fixture(scope="module")
def block_in_all_formats(tmp_path_factory, freecad):
    """The same block in one folder, in every format, and one run over it."""
    import MeshPart
    import Part

    folder = tmp_path_factory.mktemp("formats")
    shape = Part.makeBox(100, 60, 40)
    mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.1, AngularDeflection=0.1)
    for ending in FORMATS:
        file = folder / f"block.{ending}"
        if ending in ("step", "iges", "brep"):
            getattr(shape, f"export{ending.capitalize()}")(str(file))
        elif ending == "ascii.stl":
            mesh.write(Filename=str(file), Format="AST")
        else:
            mesh.write(str(file))
    return thinpart("classify", folder, "--json")


@pytest.mark.parametrize("ending", FORMATS)
def test_formats_agree(block_in_all_formats, ending):
    run = block_in_all_formats
    record, = [each for each in records(run) if Path(each["file"]).name == f"block.{ending}"]
    assert run.returncode == 0 and record["category"] == "normal" and len(records(run)) == len(FORMATS)
    assert record["descriptors"]["box_mm"] == pytest.approx([100, 60, 40], rel=1e-6)
    assert record["descriptors"]["watertight"]


def test_3mf_is_read_or_said_to_be_unreadable_here(tmp_path, freecad):
    import Mesh

    file = tmp_path / "box.3mf"
    try:
        Mesh.createBox(10, 10, 10).write(str(file))
    except Exception:  # 0.20 writes none; what it does with one is the question
        file.write_bytes(b"PK\x03\x04 nothing")
    run = thinpart("classify", file, "--json", "--no-info")
    record, = records(run)
    if run.returncode:
        assert record["error"]["kind"] == "unsupported"
    else:
        assert record["descriptors"]["volume_mm3"] == pytest.approx(1000, rel=1e-5)


# -- options


def test_info_files_beside_the_parts_and_unchanged_parts_taken_from_them(tmp_path):
    file = Path(shutil.copy(SAMPLES / "wedge.FCStd", tmp_path))
    first = thinpart("classify", file, "--json")
    info = tmp_path / "wedge.FCStd.thinpart.json"
    content = json.loads(info.read_text(encoding="utf-8"))
    jsonschema.validate(content, SCHEMA)
    written = info.stat().st_mtime_ns
    again = thinpart("classify", file, "--json")
    assert again.stdout == first.stdout and info.stat().st_mtime_ns == written
    thinpart("classify", file, "--force")
    assert info.stat().st_mtime_ns > written
    thinpart("classify", file, "--measure", "pairs")
    assert json.loads(info.read_text())["settings"]["measure"] == "pairs"


def test_a_touched_document_is_known_by_its_hash_a_changed_one_is_measured_again(tmp_path):
    file = Path(shutil.copy(SAMPLES / "wedge.step", tmp_path))
    thinpart("classify", file)
    info = tmp_path / "wedge.step.thinpart.json"
    before = info.read_bytes()
    os.utime(file, (1, 1))
    thinpart("classify", file)
    assert info.read_bytes() == before
    shutil.copy(SAMPLES / "block.step", file)
    assert thinpart("classify", file, "--json").stdout.count('"normal"')


def test_same_input_gives_the_same_bytes_apart_from_times(tmp_path):
    file = Path(shutil.copy(SAMPLES / "ribbed_block.step", tmp_path))
    contents = []
    for folder in ("a", "b"):
        thinpart("classify", file, "--info-dir", tmp_path / folder)
        text = (tmp_path / folder / "ribbed_block.step.thinpart.json").read_text()
        contents.append(re.sub(r'"(read|tessellate|measure)": [\d.]+', r'"\1": 0', text))
    assert contents[0] == contents[1]


def test_info_folder_mirrors_the_tree(tmp_path):
    inner = tmp_path / "parts" / "left" / "right"
    inner.mkdir(parents=True)
    shutil.copy(SAMPLES / "wedge.step", inner)
    shutil.copy(SAMPLES / "block.step", tmp_path / "parts")
    thinpart("classify", tmp_path / "parts", "--info-dir", tmp_path / "info")
    assert sorted(str(p.relative_to(tmp_path / "info")) for p in (tmp_path / "info").rglob("*.json")
                  ) == ["block.step.thinpart.json", "left/right/wedge.step.thinpart.json"]
    assert not list((tmp_path / "parts").rglob("*.json"))


def test_info_tree_names_the_top_of_the_tree_that_is_mirrored(tmp_path):
    inner = tmp_path / "parts" / "left"
    inner.mkdir(parents=True)
    shutil.copy(SAMPLES / "wedge.step", inner)
    for paths in ((tmp_path / "parts",), (inner,), (inner / "wedge.step",)):
        run = thinpart("classify", *paths, "--info-dir", tmp_path / "info", "--info-tree", tmp_path)
        assert run.returncode == 0
    run = thinpart("classify", inner, "--info-dir", tmp_path / "info", "--info-tree", "/")
    assert run.returncode == 0
    assert {str(path.relative_to(tmp_path / "info")) for path in (tmp_path / "info").rglob("*.json")} == {
        "parts/left/wedge.step.thinpart.json", str(inner / "wedge.step.thinpart.json")[1:]}
    run = thinpart("classify", tmp_path / "parts", "--info-dir", tmp_path / "info", "--info-tree", inner)
    assert run.returncode == 2 and "does not lie below" in run.stderr


def test_deflections_are_those_that_were_asked_for(tmp_path):
    run = thinpart("classify", SAMPLES / "tube.step", "--info-dir", tmp_path, "--linear-deflection", "0.004",
                   "--angular-deflection", "8")
    assert run.returncode == 0
    info = json.loads((tmp_path / "tube.step.thinpart.json").read_text())
    assert (info["settings"]["linear_deflection"], info["settings"]["angular_deflection"]) == (0.004, 8.0)
    coarse = info["parts"][0]["triangles"]
    run = thinpart("classify", SAMPLES / "tube.step", "--info-dir", tmp_path, "--linear-deflection", "0.0005",
                   "--angular-deflection", "4")
    info = json.loads((tmp_path / "tube.step.thinpart.json").read_text())
    assert info["parts"][0]["triangles"] > 1.5 * coarse
    for option, value in (("--linear-deflection", "0.5"), ("--angular-deflection", "nan")):
        run = thinpart("classify", SAMPLES / "tube.step", "--no-info", option, value)
        assert run.returncode == 2 and "deflection cannot be" in run.stderr.splitlines()[-1]


def test_documents_of_one_name_in_two_folders_have_two_info_files(tmp_path):
    for folder, sample in (("a", "wedge"), ("b", "block")):
        (tmp_path / folder).mkdir()
        shutil.copy(SAMPLES / f"{sample}.step", tmp_path / folder / "part.step")
    thinpart("classify", "a", "b/part.step", "a/part.step", "--info-dir", "info", cwd=tmp_path)
    categories = {
        str(path.relative_to(tmp_path / "info")): json.loads(path.read_text())["parts"][0]["category"]
        for path in (tmp_path / "info").rglob("*.json")
    }
    assert categories == {"a/part.step.thinpart.json": "normal",
                          "b/part.step.thinpart.json": "normal"}


def test_two_calls_for_one_name_do_not_share_an_info_file(tmp_path):
    for folder, sample in (("a", "wedge"), ("b", "block")):
        (tmp_path / folder).mkdir()
        shutil.copy(SAMPLES / f"{sample}.step", tmp_path / folder / "part.step")
    arguments = ("--info-dir", "info", "--json")
    assert thinpart("classify", "a/part.step", *arguments, cwd=tmp_path).returncode == 0
    info = tmp_path / "info" / "part.step.thinpart.json"
    content = json.loads(info.read_text(encoding="utf-8"))
    jsonschema.validate(content, SCHEMA)
    content["parts"][0]["notes"] = "three layers"
    info.write_text(json.dumps(content))
    before = info.read_bytes()
    for _ in range(2):
        run = thinpart("classify", "b/part.step", *arguments, cwd=tmp_path)
        good, bad = records(run)
        assert run.returncode == 1 and (good["category"], good["notes"]) == ("normal", "")
        assert bad["error"]["kind"] == "info_write" and "a/part.step" in bad["error"]["message"]
        assert info.read_bytes() == before
    again, = records(thinpart("classify", "a/part.step", *arguments, cwd=tmp_path))
    assert again["notes"] == "three layers" and info.read_bytes() == before
    both = thinpart("classify", "a", "b", *arguments, cwd=tmp_path)
    assert both.returncode == 0 and len(list((tmp_path / "info").rglob("*.json"))) == 3


def test_rows_of_files_of_one_name_can_be_told_apart(tmp_path):
    for folder in ("a", "b/deep"):
        (tmp_path / "parts" / folder).mkdir(parents=True)
        shutil.copy(SAMPLES / "wedge.step", tmp_path / "parts" / folder / "part.step")
    (tmp_path / "parts" / "b" / "part.step").write_bytes(b"")
    table = tmp_path / "table.csv"
    run = thinpart("classify", tmp_path / "parts", "--no-info", "--csv", table)
    expected = ["a/part.step", "b/deep/part.step", "b/part.step"]
    assert [line.split()[0] for line in run.stdout.splitlines()[1:4]] == expected
    with open(table, newline="", encoding="utf-8") as file:
        assert [row["file"] for row in csv.DictReader(file)] == expected


def test_one_file_is_measured_once_however_many_ways_lead_to_it(tmp_path):
    real = tmp_path / "real"
    real.mkdir()
    shutil.copy(SAMPLES / "wedge.step", real)
    (tmp_path / "also").symlink_to(real)
    (tmp_path / "link.step").symlink_to(real / "wedge.step")
    run = thinpart("classify", tmp_path / "also", tmp_path / "link.step", real, tmp_path, "--json")
    record, = records(run)
    assert record["file"] == str(real / "wedge.step")
    assert [each.name for each in tmp_path.rglob("*.json")] == ["wedge.step.thinpart.json"]
    record, = records(thinpart("classify", tmp_path / "link.step", "--json", "--no-info"))
    assert record["file"] == str(tmp_path / "link.step")


def test_loops_of_links_are_walked_once(tmp_path):
    (tmp_path / "deep").mkdir()
    shutil.copy(SAMPLES / "wedge.step", tmp_path / "deep")
    (tmp_path / "deep" / "loop").symlink_to(tmp_path)
    assert len(records(thinpart("classify", tmp_path, "--json", "--no-info"))) == 1


def test_a_part_in_which_no_two_faces_enclose_a_wall_is_in_every_table(tmp_path, freecad):
    import FreeCAD
    import Part

    corners = [FreeCAD.Vector(*each) for each in ((10, 10, 10), (10, -10, -10), (-10, 10, -10), (-10, -10, 10))]
    sides = ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))  # which meet under 70 degrees
    faces = [Part.Face(Part.makePolygon([corners[each] for each in (*side, side[0])])) for side in sides]
    Part.makeSolid(Part.makeShell(faces)).exportStep(str(tmp_path / "pyramid.step"))
    table = tmp_path / "table.csv"
    run = thinpart("classify", tmp_path / "pyramid.step", "--regions", "--check", "machining", "--csv", table)
    assert run.returncode == 0, run.stderr
    assert "pyramid: No wall could be measured." in run.stdout and "no wall could be measured." in run.stdout
    with open(table, encoding="utf-8-sig", newline="") as file:
        row, = csv.DictReader(file)
    assert row["thinnest_mm"] == row["places"] == row["walls_mm"] == ""
    found = thinpart("find", tmp_path)
    assert found.returncode == 0 and "pyramid" in found.stdout
    report = thinpart("report", tmp_path / "pyramid.step", "-o", tmp_path / "report")
    assert report.returncode == 0, report.stderr


def test_csv_has_a_row_per_part_and_failure(tmp_path):
    (tmp_path / "bad.step").write_bytes(b"")
    shutil.copy(SAMPLES / "plate.step", tmp_path)
    table = tmp_path / "table.csv"
    run = thinpart("classify", tmp_path, "--no-info", "--csv", table)
    assert run.returncode == 1
    with open(table, newline="", encoding="utf-8") as file:
        rows = {Path(row["file"]).name: row for row in csv.DictReader(file)}
    assert rows["plate.step"]["category"] == "thin" and rows["bad.step"]["error_kind"] == "empty"


def test_own_profile_and_the_papers_verdict_beside_it(tmp_path):
    profile = json.loads((ROOT / "resources" / "profiles" / "paper.json").read_text())
    profile["name"] = "house"
    profile["categories"] = profile["categories"][1:]
    file = tmp_path / "house.json"
    file.write_text(json.dumps(profile))
    run = thinpart("classify", SAMPLES / "plate.step", "--json", "--no-info", "--profile", file)
    record, = records(run)
    assert record["category"] == "thin_features"
    assert record["paper"] == {"category": "thin", "criteria": [1, 4, 5]}


@pytest.mark.parametrize("arguments", [
    ["classify"], ["classify", "x", "--measure", "guess"], ["classify", "x", "--jobs", "0"],
    ["classify", "x", "--memory", "50"],
    ["classify", "x", "--profile", "no-such"], ["no-such-command"], ["classify", "x", "--nonsense"],
    [],
])
def test_wrong_usage_is_two(arguments):
    run = thinpart(*arguments)
    assert run.returncode == 2 and run.stderr and "Traceback" not in run.stderr


@pytest.mark.parametrize("option, value, allowed", [
    ("--jobs", "0", "a whole number from 1"), ("--jobs", "two", "a whole number from 1"),
    ("--timeout", "-1", "a number of seconds from"), ("--timeout", "nan", "a number of seconds from"),
    ("--timeout", "inf", "to 1000000000"), ("--memory", "50", "megabytes from 700"),
    ("--memory", "6 GB", "a whole number of megabytes"), ("--memory", "9" * 30, "to 1000000000"),
])
def test_a_value_that_is_not_allowed_is_answered_with_a_sentence(option, value, allowed):
    run = thinpart("classify", "x", option, value)
    last = run.stderr.splitlines()[-1]
    assert run.returncode == 2 and f"'{value}' is not allowed: {option} takes " in last
    assert allowed in last and "_" not in last and last.endswith(".")


def test_paths_with_odd_names(tmp_path):
    for name in ("with space.step", "quote'\".step", "new\nline.step", "üñí.step", "-dash.step"):
        shutil.copy(SAMPLES / "wedge.step", tmp_path / name)
    run = thinpart("classify", tmp_path, "--json")
    assert run.returncode == 0 and len(records(run)) == 5
    assert len(list(tmp_path.glob("*.thinpart.json"))) == 5
    assert thinpart("classify", tmp_path).returncode == 0


def test_wall_regions_are_listed_below_the_table():
    run = thinpart("classify", SAMPLES / "heat_sink.step", "--regions", "--no-info")
    fins, base = run.stdout.splitlines()[-2:]
    assert fins.startswith("heat_sink: 16 x plate, 1.5 mm thick, ") and " mm wide, 58 % of the volume: Face" in fins
    assert base.startswith("heat_sink: plate, 6 mm thick, ")
    assert "16 x plate" not in thinpart("classify", SAMPLES / "heat_sink.step", "--no-info").stdout


# -- checks of walls against the limits of processes


def test_a_part_that_fails_a_check_gives_exit_status_3(tmp_path):
    table = tmp_path / "table.csv"
    run = thinpart("classify", SAMPLES / "tube.step", SAMPLES / "block.step", "--no-info", "--no-thumbnails",
                   "--check", "FDM,sand_casting", "--csv", table)
    assert run.returncode == 3, run.stderr
    assert "sand_casting" in run.stdout.splitlines()[0]
    assert "tube.step: tube: Sand casting: fails: 97 % of the surface is under 3 mm, thinnest 2 mm on Face" in run.stdout
    with open(table, newline="", encoding="utf-8") as file:
        rows = {row["label"]: row for row in csv.DictReader(file)}
    assert [rows["tube"][f"check {name}"] for name in ("FDM", "sand_casting")] == ["passes", "fails"]
    assert rows["block"]["check sand_casting"] == "passes" and "40 mm" in rows["block"]["check sand_casting sentence"]


def test_checks_stand_in_json_and_what_passes_gives_exit_status_0():
    run = thinpart("classify", SAMPLES / "tube.step", "--no-info", "--no-thumbnails", "--json", "--check", "SLS",
                   "--check", "die_casting:zinc")
    tube, = records(run)
    assert run.returncode == 0 and [check["process"] for check in tube["checks"]] == ["SLS", "die_casting:zinc"]
    assert all(check["passes"] is True and check["thinnest_mm"] == pytest.approx(2.0) for check in tube["checks"])


def test_a_file_that_failed_outweighs_a_check_that_failed(tmp_path):
    shutil.copy(SAMPLES / "tube.step", tmp_path)
    (tmp_path / "damaged.step").write_text("ISO-10303-21; nothing more")
    assert thinpart("classify", tmp_path, "--no-info", "--no-thumbnails", "--check", "sand_casting").returncode == 1


def test_an_unknown_process_is_wrong_usage_and_measures_nothing(tmp_path):
    run = thinpart("classify", SAMPLES / "tube.step", "--no-info", "--check", "wood")
    assert run.returncode == 2 and "wood" in run.stderr and "sheet_metal" in run.stderr and not run.stdout


def test_own_limits_are_checked_and_faults_in_them_are_told(tmp_path):
    own = tmp_path / "own.json"
    own.write_text(json.dumps({"format": "thinpart-wall-limits", "version": 1, "processes": [
        {"id": "FDM", "title": "Coarse FDM", "min_mm": 2.4, "max_mm": None}]}))
    command = ("classify", SAMPLES / "tube.step", "--no-info", "--no-thumbnails", "--check", "FDM", "--limits", own)
    run = thinpart(*command)
    assert run.returncode == 3 and "Coarse FDM: fails" in run.stdout
    own.write_text(own.read_text().replace("2.4", '"thick"'))
    run = thinpart(*command)
    assert run.returncode == 2 and "own.json" in run.stderr and "processes[0].min_mm" in run.stderr


def test_a_record_is_measured_once_and_checked_at_any_limit(tmp_path):
    shutil.copy(SAMPLES / "tube.step", tmp_path)
    assert thinpart("classify", tmp_path, "--no-thumbnails").returncode == 0
    before = next(tmp_path.glob("*.json")).read_bytes()
    assert thinpart("classify", tmp_path, "--no-thumbnails", "--check", "sand_casting").returncode == 3
    assert thinpart("classify", tmp_path, "--no-thumbnails", "--check", "FDM").returncode == 0
    assert next(tmp_path.glob("*.json")).read_bytes() == before
