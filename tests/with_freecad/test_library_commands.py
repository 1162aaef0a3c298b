# SPDX-License-Identifier: LGPL-2.1-or-later
"""find, similar, note and reclassify as people call them, on real documents."""

import json
import shutil

import pytest
from program import SAMPLES, SCHEMA, records, thinpart

NAMES = ("tube.step", "plate.step", "block.FCStd", "assembly_of_three.step", "vee_block.step")


@pytest.fixture(scope="module")
def classified(tmp_path_factory):
    folder = tmp_path_factory.mktemp("library")
    for name in NAMES:
        shutil.copy(SAMPLES / name, folder)
    (folder / "damaged.step").write_text("ISO-10303-21; nothing more")
    assert thinpart("classify", folder, "--jobs", 2, "--profile", "paper").returncode == 1
    return folder


@pytest.fixture
def library(classified, tmp_path, monkeypatch):
    """A copy, so that a test may change it, with a cache of its own."""
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    return shutil.copytree(classified, tmp_path / "library", copy_function=shutil.copy2)


def labels(run):
    return sorted(line["label"] for line in records(run))


def test_find_by_everything(library):
    everything = thinpart("find", library, "--json")
    assert everything.returncode == 0 and len(labels(everything)) == 7
    for line in records(everything):
        jsonschema_part(line)
    thin = labels(thinpart("find", library, "--category", "thin", "--json"))
    assert "tube" in thin and "block" not in thin
    assert labels(thinpart("find", library, "--criterion", "3", "--json")) == ["tube"]
    assert labels(thinpart("find", library, "--max-thickness", "2.5", "--text", "TUBE", "--json")) == ["tube"]
    assert labels(thinpart("find", library, "--where", "D2/D3 < 1.1 and V/VBB < 0.3", "--json")) == ["tube"]
    assert labels(thinpart("find", library, "--min-size", "1e6", "--json")) == []
    assert len(labels(thinpart("find", library, "--changed-since", "1d", "--json"))) == 7
    assert labels(thinpart("find", library, "--changed-since", "2999-12-31", "--json")) == []
    largest = records(thinpart("find", library, "--sort", "d1_mm", "--reverse", "-n", 2, "--json"))
    sizes = [line["descriptors"]["box_mm"][0] for line in largest]
    assert len(sizes) == 2 and sizes == sorted(sizes, reverse=True)


def jsonschema_part(line):
    import jsonschema

    part = {key: value for key, value in line.items() if key not in ("file", "info_file")}
    schema = SCHEMA["properties"]["parts"]["items"]
    jsonschema.validate(part, {**schema, "definitions": SCHEMA.get("definitions", {})})


def test_the_table_is_for_people(library):
    run = thinpart("find", library, "--category", "thin")
    assert run.returncode == 0 and "tube.step" in run.stdout and "60 x 40 x 40" in run.stdout
    assert "damaged" not in run.stdout
    nothing = thinpart("find", library, "--text", "no such words")
    assert nothing.returncode == 0 and nothing.stdout == "" and "No stored part" in nothing.stderr


def test_libraries_in_each_other_give_each_part_once(library):
    (library / "inner").mkdir()
    shutil.move(library / "tube.step", library / "inner")
    shutil.move(library / "tube.step.thinpart.json", library / "inner")
    assert len(labels(thinpart("find", library, library / "inner", "--json"))) == 7


@pytest.mark.parametrize("arguments, status, sentence", [
    (["--where", "nonsense"], 2, "is not understood"),
    (["--where", "wall > 3"], 2, "There is no quantity 'wall'"),
    (["--changed-since", "yesterday"], 2, "is no date"),
    (["--min-thickness", "thin"], 2, "invalid float value"),
])
def test_wrong_usage(library, arguments, status, sentence):
    run = thinpart("find", library, *arguments)
    assert run.returncode == status and sentence in run.stderr and "Traceback" not in run.stderr


def test_folders_that_are_none(library, tmp_path):
    run = thinpart("find", library, tmp_path / "gone", library / "tube.step", "--json")
    assert run.returncode == 1 and len(labels(run)) == 7
    assert "There is no folder" in run.stderr and "is a file" in run.stderr


def test_info_files_that_cannot_be_used_are_named(library):
    (library / "block.FCStd.thinpart.json").write_text("{")
    for number in range(6):
        (library / f"{number}.step.thinpart.json").write_text('{"format": "another"}')
    run = thinpart("find", library, "--json")
    assert run.returncode == 0 and "Block" not in labels(run) and len(labels(run)) == 6
    assert run.stderr.count("thinpart: ") == 6 and "2 more info files" in run.stderr
    failed = records(thinpart("find", library, "--failed", "--json"))
    assert {line["error"]["kind"] for line in failed} == {"info_file"} and len(failed) == 7


def test_similar_says_why(library):
    run = thinpart("similar", library / "tube.step", library, "-n", 3, "--json")
    found = records(run)
    assert run.returncode == 0 and len(found) == 3 and "tube" not in labels(run)
    scores = [line["score"] for line in found]
    assert scores == sorted(scores, reverse=True) and all(line["reasons"] for line in found)
    table = thinpart("similar", library / "tube.step", library)
    assert "%" in table.stdout and found[0]["reasons"][:20] in table.stdout


def test_similar_to_a_part_that_was_never_classified(library, tmp_path):
    shutil.copy(SAMPLES / "tube.FCStd", tmp_path / "mine.FCStd")
    best = records(thinpart("similar", tmp_path / "mine.FCStd", library, "-n", 1, "--json"))
    assert best[0]["label"] == "tube" and best[0]["score"] > 99
    assert not (tmp_path / "mine.FCStd.thinpart.json").exists()
    several = thinpart("similar", library / "assembly_of_three.step", library)
    assert several.returncode == 2 and "--part" in several.stderr


def test_notes_survive_a_new_classification_and_are_found(library):
    part = library / "tube.step"
    assert thinpart("note", part, "--set", "shell mesh, 3 layers", "--mesh", '{"size": 1.5}',
                    "--link", "mesh/tube.geo").returncode == 0
    assert thinpart("classify", part, "--force").returncode == 0
    shown = thinpart("note", part)
    assert "shell mesh, 3 layers" in shown.stdout and '{"size": 1.5}' in shown.stdout
    assert records(thinpart("note", part, "--json"))[0]["mesh"] == {"settings": {"size": 1.5}}
    assert labels(thinpart("find", library, "--text", "3 layers", "--json")) == ["tube"]
    assert labels(thinpart("find", library, "--notes", "--json")) == ["tube"]
    assert len(labels(thinpart("find", library, "--no-notes", "--json"))) == 6


def test_notes_that_cannot_be_set(library):
    never = thinpart("note", library / "damaged.step", "--set", "x")
    assert never.returncode == 1 and "classify damaged.step first" in never.stderr
    several = thinpart("note", library / "assembly_of_three.step", "--set", "x")
    assert several.returncode == 2 and "--part" in several.stderr
    wrong = thinpart("note", library / "tube.step", "--mesh", "{size: 2")
    assert wrong.returncode == 2 and "is not a JSON object" in wrong.stderr


def test_reclassify_tells_first_and_writes_when_asked(library, tmp_path):
    profile = json.loads((SAMPLES.parent / "profiles" / "paper.json").read_text(encoding="utf-8"))
    profile["name"] = "nothing is thin"
    profile["categories"] = [each for each in profile["categories"] if each["name"] != "thin"]
    (tmp_path / "house.json").write_text(json.dumps(profile))
    before = {path.name: path.read_bytes() for path in library.glob("*.thinpart.json")}
    told = thinpart("reclassify", library, "--profile", tmp_path / "house.json")
    assert told.returncode == 0 and "from thin to" in told.stdout and "--write updates" in told.stdout
    assert {path.name: path.read_bytes() for path in library.glob("*.thinpart.json")} == before
    lines = records(thinpart("reclassify", library, "--profile", tmp_path / "house.json", "--json", "--write"))
    assert len(lines) == 7
    assert {line["label"] for line in lines if line["changed"]} >= {"tube", "plate"}
    assert labels(thinpart("find", library, "--category", "thin", "--json")) == []
    # Back again: the paper's verdicts, without a document.
    for name in NAMES:
        (library / name).unlink()
    assert thinpart("reclassify", library, "--profile", "paper", "--write").returncode == 0
    assert "tube" in labels(thinpart("find", library, "--category", "thin", "--json"))


def test_reclassify_without_anything_stored(tmp_path):
    run = thinpart("reclassify", tmp_path)
    assert run.returncode == 1 and "There are no info files" in run.stderr


def test_find_parts_that_pass_or_fail_a_process(library):
    assert labels(thinpart("find", library, "--fails", "sand_casting", "--json")) == ["tube"]
    passing = labels(thinpart("find", library, "--passes", "sand_casting,sheet_metal", "--json"))
    assert passing and "tube" not in passing and "block" not in {each.casefold() for each in passing}
    table = thinpart("find", library, "--text", "tube.step", "--check", "sand_casting,FDM")
    assert table.returncode == 0 and "FAILS" in table.stdout and "passes" in table.stdout
    tube, = records(thinpart("find", library, "--text", "tube.step", "--check", "FDM", "--json"))
    assert tube["checks"][0]["passes"] is True
    assert thinpart("find", library, "--passes", "wood").returncode == 2


def test_a_report_has_the_checks_on_its_pages(library, tmp_path):
    run = thinpart("report", library / "tube.step", "-o", tmp_path / "report", "--check", "sand_casting,FDM")
    assert run.returncode == 3, run.stderr
    page = next((tmp_path / "report" / "pages").glob("tube*.html")).read_text(encoding="utf-8")
    assert "Limits of the wall" in page and "Sand casting: fails" in page and "https://" in page
    overview = (tmp_path / "report" / "index.html").read_text(encoding="utf-8")
    assert "Sand casting" in overview and "FDM printing" in overview
    assert "check sand_casting" in (tmp_path / "report" / "parts.csv").read_text(encoding="utf-8")
