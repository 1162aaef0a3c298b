# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports: whole pages that need nothing but themselves, whatever a part or file is called."""

import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import time_limit
from program import ROOT, SAMPLES, group_ended, thinpart
from read_page import Page, pages

from thinpart_workbench.core.judging.criteria import load_profile

HOSTILE = "<script>alert('1')</script> \"&amp; \x1b[31m \u202e"


def read_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    """A report on a tree with good and bad files, and everything it says."""
    top = tmp_path_factory.mktemp("report")
    parts = top / "parts"
    (parts / "inner").mkdir(parents=True)
    shutil.copy(SAMPLES / "assembly_of_three.FCStd", parts / "inner")
    shutil.copy(SAMPLES / "ribbed_block.FCStd", parts / "inner")
    shutil.copy(SAMPLES / "tube.step", parts / "a b#?%.step")
    (parts / "damaged.step").write_text("ISO-10303-21;\nthis is no STEP file\n")
    before = {path: path.read_bytes() for path in parts.rglob("*") if path.is_file()}
    run = thinpart("report", parts, "-o", top / "out", "--profile", "paper")
    assert before == {path: path.read_bytes() for path in parts.rglob("*") if path.is_file()}
    return run, top / "out"


def test_it_says_what_failed_and_where_the_report_is(report):
    run, folder = report
    assert run.returncode == 1 and "damaged.step" in run.stderr
    assert run.stdout == f"{folder / 'index.html'}\n"


def test_every_part_has_a_page_that_is_whole(report):
    _, folder = report
    found = pages(folder)
    assert set(found) == {
        "index.html", "pages/inner/assembly_of_three.FCStd~BaseBlock.html",
        "pages/inner/assembly_of_three.FCStd~CoverPlate.html",
        "pages/inner/assembly_of_three.FCStd~DowelPin.html",
        "pages/inner/ribbed_block.FCStd~RibbedBlock.html", next(n for n in found if "~Solid1" in n)}
    for name, page in found.items():
        if name != "index.html":
            assert page.count("script") == 0 and page.count("image") == 3
            assert page.references.count("../index.html" if "inner" not in name else "../../index.html") == 1


@pytest.mark.timeout(120)  # two reports, on a busy machine
@pytest.mark.parametrize("language", ["de", "fr"])
def test_a_report_in_another_language_has_no_english_texts_and_the_same_tables(language, tmp_path):
    parts = tmp_path / "parts"
    parts.mkdir()
    for name in ("wedge.step", "tube.step"):
        shutil.copy(SAMPLES / name, parts)
    (parts / "damaged.step").write_text("ISO-10303-21;\nthis is no STEP file\n")
    options = ("--check", "die_casting:zinc")
    assert thinpart("report", parts, "-o", tmp_path / "en", *options).returncode == 1
    run = thinpart("report", parts, "-o", tmp_path / language, "--language", language, *options)
    assert run.returncode == 1, run.stderr
    english, found = pages(tmp_path / "en"), pages(tmp_path / language)
    assert set(english) == set(found) and len(found) == 3
    sentences = json.loads((ROOT / "resources" / "translations" / f"sentences_{language}.json").read_text(encoding="utf-8"))
    whole = [text for text, other in sentences.items() if text != other and len(text) > 12 and "{" not in text]
    assert len(whole) > 150
    for name, page in found.items():
        assert dict(page.tags)["html"]["lang"] == language and dict(english[name].tags)["html"]["lang"] == "en"
        assert [text for text in whole if text in page.text] == []
        assert re.search(r"\d,\d", page.text) and not re.search(r" \d+\.\d+ ", page.text)
        said = english[name].text
        assert [text for text in whole if text in said] and not re.search(r" \d+,\d+ ", said)
    tube = next(page for name, page in found.items() if "tube" in name)
    assert sentences["Thin part"] in tube.text and sentences["Thin plates nearly everywhere"] in tube.text
    for table in ("parts.csv", "faces.csv"):
        assert (tmp_path / language / table).read_bytes() == (tmp_path / "en" / table).read_bytes()


def test_tables_and_exit_status_respect_limits_of_single_faces_as_the_pages_do(tmp_path):
    part, limits = tmp_path / "rib.step", tmp_path / "own.json"
    shutil.copy(SAMPLES / "cuboid_with_rib.step", part)
    limits.write_text(json.dumps({"format": "thinpart-wall-limits", "version": 1, "processes": [
        {"id": "nine", "title": "Nine", "min_mm": 9, "max_mm": None}]}))
    check = "--check", "nine", "--limits", limits
    assert thinpart("classify", part, *check).returncode == 3
    assert thinpart("report", part, "-o", tmp_path / "before", *check).returncode == 3
    record, = json.loads((tmp_path / "rib.step.thinpart.json").read_text())["parts"]
    faces = [face["face"] for face in record["faces"] if face["min"] is not None and face["min"] < 9.0]
    assert thinpart("note", part, "--face", ",".join(faces), "--at-least", 1, "--reason", "a crush rib").returncode == 0
    assert thinpart("report", part, "-o", tmp_path / "after", *check).returncode == 0
    before, after = (read_csv(tmp_path / name / "parts.csv")[0] for name in ("before", "after"))
    assert (before["check nine"], after["check nine"]) == ("fails", "passes")
    assert "a crush rib" in after["check nine sentence"]
    page, = (page for name, page in pages(tmp_path / "after").items() if name != "index.html")
    assert "a crush rib" in page.text
    found = thinpart("find", tmp_path, "--passes", "nine", "--limits", limits, "--json")
    assert len(found.stdout.splitlines()) == 1
    assert thinpart("classify", part, *check, "--csv", tmp_path / "parts.csv").returncode == 0
    assert read_csv(tmp_path / "parts.csv")[0]["check nine"] == "passes"


def test_a_report_in_inches_says_no_millimetres_and_has_the_same_tables(tmp_path):
    reports = {unit: tmp_path / unit for unit in ("mm", "in")}
    for unit, folder in reports.items():
        assert thinpart("report", SAMPLES / "tube.step", "-o", folder, "--unit", unit).returncode == 0
    for name, page in pages(reports["in"]).items():
        assert not re.search(r"\bmm\b", page.text), name
        assert re.search(r"\bmm\b", pages(reports["mm"])[name].text), name
    part, = (page for name, page in pages(reports["in"]).items() if name != "index.html")
    assert re.search(r"[\d.]+\sin\b", part.text)
    for table in ("parts.csv", "faces.csv"):
        assert (reports["in"] / table).read_bytes() == (reports["mm"] / table).read_bytes()


def test_a_language_that_there_is_not_is_refused(tmp_path):
    run = thinpart("report", SAMPLES / "tube.step", "-o", tmp_path / "out", "--language", "xx")
    assert run.returncode == 2 and "--language" in run.stderr and not (tmp_path / "out").exists()


def test_the_verdict_is_said_in_words_and_not_by_the_name_of_a_criterion(tmp_path):
    shutil.copy(SAMPLES / "plate.step", tmp_path)
    assert thinpart("report", tmp_path / "plate.step", "-o", tmp_path / "out").returncode == 0
    page, = [page for name, page in pages(tmp_path / "out").items() if name != "index.html"]
    said = re.search(r"[\d.]+\smm (sheet|plate), \d+\s% of the surface: consider shells .*\. Probability: ", page.text)
    assert said
    assert "thin_walls" not in page.text and "Thin plates nearly everywhere" in page.text


def test_the_overview_counts_and_lists(report):
    _, folder = report
    page = Page(folder / "index.html")
    assert "Wall thickness of 5 parts" in page.text
    assert re.search(r"2 thin 2 thin features 1 normal 1 failed", page.text)
    rows = [attributes["data-category"] for tag, attributes in page.tags
            if tag == "tr" and "data-category" in attributes]
    assert sorted(rows) == ["normal", "thin", "thin", "thin_features", "thin_features"]
    assert "damaged.step" in page.text and "[unreadable]" in page.text


def test_the_page_of_a_part_says_what_was_measured(report):
    _, folder = report
    page = Page(folder / "pages/inner/ribbed_block.FCStd~RibbedBlock.html")
    assert "Part with thin features" in page.text and "Why: Very thin wall on a filled part (rule 5)" in page.text
    assert "Thinnest wall 6 mm" in page.text and "100 \u00d7 60 \u00d7 60 mm" in page.text
    assert "ThinPart 0.1.0" in page.text and "changed 20" in page.text
    faces = page.text.partition("Its faces")[2].partition("How it was measured")[0]
    assert re.search(r"Face\d+ Rib [\d.]+ 6 6 100 % ", faces)
    assert faces.index(" 6 6 ") < faces.index(" 60 60 ")


def test_the_tables_have_a_row_for_everything(report):
    _, folder = report
    parts, faces = read_csv(folder / "parts.csv"), read_csv(folder / "faces.csv")
    assert [row["file"] for row in parts] == [
        "a b#?%.step", "damaged.step", *["inner/assembly_of_three.FCStd"] * 3, "inner/ribbed_block.FCStd"]
    ribbed = [row for row in faces if row["part"] == "RibbedBlock"]
    assert min(float(row["thinnest_mm"]) for row in ribbed) == pytest.approx(6.0)
    assert {row["face"] for row in ribbed} == {f"Face{k + 1}" for k in range(len(ribbed))}
    assert all(row["made_by"] for row in ribbed)
    assert not any(row["made_by"] for row in faces if row["file"].endswith(".step"))


def test_labels_and_names_are_shown_and_never_run(tmp_path, document):
    folder = tmp_path / os.fsdecode(b"caf\xe9 <b>")
    folder.mkdir()
    made = document.addObject("Part::Box", "Box")
    made.Label = HOSTILE.replace("\x1b[31m", "")  # FreeCAD's own file takes no control characters
    made.Length, made.Width, made.Height = 100, 80, 2
    document.recompute()
    file = tmp_path / "x'><img src=y onerror=z>.FCStd"
    document.saveAs(str(file))
    shutil.copy(SAMPLES / "tube.step", folder / "\x1b[31m<script>.step")
    run = thinpart("report", file, folder, "-o", tmp_path / "out")
    assert run.returncode == 0, run.stderr
    found = pages(tmp_path / "out")
    assert len(found) == 3
    for name, page in found.items():
        assert page.count("script") == (1 if name == "index.html" else 0)
        assert page.count("b") <= 3 and not [a for _, a in page.tags if any(k.startswith("on") for k in a)]
        assert not re.search("[\x00-\x08\x1b\u202e]", page.path.read_text(encoding="utf-8"))
    texts = " ".join(page.text for page in found.values())
    for shown in ("<script>alert('1')</script> \"&amp;", r"\u202e", r"\x1b[31m<script>", r"caf\udce9 <b>"):
        assert shown in texts


def test_a_page_has_what_was_kept_with_its_part(tmp_path):
    shutil.copy(SAMPLES / "plate.step", tmp_path / "plate.step")
    assert thinpart("classify", tmp_path / "plate.step").returncode == 0
    run = thinpart("note", tmp_path / "plate.step", "--set", "shell <i>mesh</i>",
                   "--link", "javascript:alert(1)")
    assert run.returncode == 0, run.stderr
    assert thinpart("report", tmp_path / "plate.step", "-o", tmp_path / "out").returncode == 0
    page, = [page for name, page in pages(tmp_path / "out").items() if name != "index.html"]
    assert "shell <i>mesh</i>" in page.text and "javascript:alert(1)" in page.text


def test_its_own_pages_are_replaced_and_are_the_same(tmp_path):
    def written():
        run = thinpart("report", SAMPLES / "tube.step", "-o", tmp_path / "out")
        assert run.returncode == 0, run.stderr
        return {path.name: path.read_bytes() for path in (tmp_path / "out").rglob("*") if path.is_file()}

    first = written()
    assert first == written() and len(first) == 6


@pytest.mark.parametrize("wrong", ["file", "below a file", "not the folder of a report", "unwritable"])
def test_a_place_that_cannot_be_taken(tmp_path, wrong):
    folder = tmp_path / "out"
    if wrong == "not the folder of a report":
        folder.mkdir()
        (folder / "thesis.txt").write_text("mine")
    elif wrong == "unwritable":
        folder = Path("/proc/thinpart")
    else:
        folder.write_text("mine")
    target = folder / "report" if wrong == "below a file" else folder
    before = sorted(tmp_path.rglob("*"))
    run = thinpart("report", SAMPLES / "tube.step", "-o", target)
    assert run.returncode == 2 and run.stdout == ""
    assert re.fullmatch(r"thinpart: [^\n]+[:;] give [^\n]+\n", run.stderr)
    assert sorted(tmp_path.rglob("*")) == before


def test_an_empty_folder_has_no_report(tmp_path):
    (tmp_path / "parts").mkdir()
    run = thinpart("report", tmp_path / "parts", "-o", tmp_path / "out")
    assert run.returncode == 1 and "There are no parts" in run.stderr and not (tmp_path / "out").exists()


def test_nothing_but_failures_is_a_report_too(tmp_path):
    (tmp_path / "a.step").write_bytes(b"")
    run = thinpart("report", tmp_path / "a.step", "-o", tmp_path / "out")
    assert run.returncode == 1
    page = Page(tmp_path / "out" / "index.html")
    assert "1 failed" in page.text and "is empty (0 bytes)" in page.text


@pytest.mark.timeout(180)  # a report that is killed and a whole one, with six pages each
def test_a_run_that_is_killed_leaves_whole_pages(tmp_path):
    parts = tmp_path / "parts"
    parts.mkdir()
    for number in range(6):
        shutil.copy(SAMPLES / "tube.step", parts / f"{number}.step")
    run = subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench", "report", parts, "-o", tmp_path / "out", "--jobs", "2"],
        env=dict(os.environ, PYTHONPATH=str(ROOT)), start_new_session=True)
    time_limit.wait_until(lambda: len(list((tmp_path / "out").rglob("*.html"))) >= 2, "the first two pages")
    os.kill(run.pid, signal.SIGKILL)
    run.wait()
    assert group_ended(run.pid)
    left = list((tmp_path / "out").rglob("*.html"))
    assert 2 <= len(left) < 6
    for path in left:
        assert Page(path).text.endswith("ThinPart 0.1.0")
    assert thinpart("report", parts, "-o", tmp_path / "out").returncode == 0
    assert len(pages(tmp_path / "out")) == 7


def test_the_profile_that_was_asked_for_judges(tmp_path):
    profile = load_profile("paper").content
    house = {**profile, "name": "house", "title": "House <rules>", "categories": [
        {"name": "flat", "title": "Flat 'part'", "criteria": [
            {"id": 1, "title": "Flat", "conditions": [
                {"quantity": "D2/D3", "comparison": ">", "value": 2}]}]}]}
    (tmp_path / "house.json").write_text(json.dumps(house))
    run = thinpart("report", SAMPLES / "plate.step", "-o", tmp_path / "out",
                   "--profile", tmp_path / "house.json")
    assert run.returncode == 0, run.stderr
    for page in pages(tmp_path / "out").values():
        assert "Flat 'part'" in page.text and "House <rules>" in page.text


def test_pictures_can_show_balls_while_the_verdict_is_by_rays(tmp_path):
    shutil.copy(SAMPLES / "wedge.step", tmp_path)
    said = {}
    for measure in ("rays", "sphere", "local"):
        out = tmp_path / measure
        run = thinpart("report", tmp_path / "wedge.step", "-o", out, "--measure", measure)
        assert run.returncode == 0, run.stderr
        page, = (out / "pages").rglob("*.html")
        said[measure] = page.read_text(encoding="utf-8"), (out / "parts.csv").read_text(), (out / "faces.csv").read_text()
        pages(out)
    assert said["rays"][1:] == said["sphere"][1:] == said["local"][1:]
    assert "Colours stand for the local thickness" in said["local"][0]
    assert "largest ball inside" in said["sphere"][0] and "largest ball inside" not in said["rays"][0]
    assert re.findall("base64,([^\"]+)", said["rays"][0])[0] != re.findall("base64,([^\"]+)", said["sphere"][0])[0]


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """Classified samples, one of them twice, and a file that is none."""
    folder = tmp_path_factory.mktemp("library") / "parts"
    (folder / "old").mkdir(parents=True)
    for name in ("plate.step", "tube.step"):
        shutil.copy(SAMPLES / name, folder)
    shutil.copy(SAMPLES / "plate.step", folder / "old" / "plate <b>.step")
    assert thinpart("classify", folder).returncode == 0
    (folder / "damaged.step").write_text("ISO-10303-21;\nthis is no STEP file\n")
    return folder


def test_a_page_about_a_library_reads_no_document(library, tmp_path):
    moved = shutil.copytree(library, tmp_path / "parts", copy_function=shutil.copy2)
    for name in ("plate.step", "tube.step"):
        os.truncate(moved / name, 0)  # whoever reads it fails
    run = thinpart("report", "--library", moved, "-o", tmp_path / "out")
    assert run.returncode == 0 and run.stdout == f"{tmp_path / 'out' / 'library.html'}\n"
    assert "1 document has no info file and is not on the page" in run.stderr
    page = pages(tmp_path / "out")["library.html"]
    assert "Library of 3 parts" in page.text and "The documents are the same, byte by byte." in page.text
    assert "old/plate <b>.step" in page.text and "damaged.step" in page.text
    pictures = [attributes["src"] for tag, attributes in page.tags if tag == "img"]
    assert len(pictures) == 2 and all((tmp_path / "out" / each).is_file() for each in pictures)
    assert len(list((tmp_path / "out" / "pictures").rglob("*.png"))) == 2  # copies share theirs
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["library.html", "pictures", "thinpart-report.json"]


@pytest.mark.parametrize("options", [("--json",), ("--check", "FDM"), ("--info-dir", "x"), ("--include", "*.step"),
                                     ("--profile", "paper"), ("--jobs", "1000")])
def test_a_page_about_a_library_takes_no_options_about_documents(library, tmp_path, options):
    run = thinpart("report", "--library", library, "-o", tmp_path / "out", *options)
    assert run.returncode == 2 and not (tmp_path / "out").exists()
    assert run.stderr == f"thinpart: --library reads info files only, and takes no {options[0]}: leave it out.\n"


def test_a_page_about_a_library_is_about_folders(library, tmp_path):
    for wrong, said in ((library / "plate.step", "is a file: name the folder of a library"),
                        (library / "nowhere", "There is no folder")):
        run = thinpart("report", "--library", wrong, "-o", tmp_path / "out")
        assert run.returncode in (1, 2) and said in run.stderr and not (tmp_path / "out").exists()


def test_a_library_beside_one_that_is_missing_is_shown_and_the_other_named(library, tmp_path):
    run = thinpart("report", "--library", library, library.parent / "nowhere", "-o", tmp_path / "out", "--language", "de")
    assert run.returncode == 1 and "There is no folder" in run.stderr
    assert "Bibliothek mit 3 Teilen" in pages(tmp_path / "out")["library.html"].text
