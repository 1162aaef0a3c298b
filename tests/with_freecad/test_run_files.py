# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs over whole folders: which files they take, odd names, and places that cannot be read or written."""

import csv
import io
import json
import os
import resource
import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from folder_runs import TUBE, infos, messages, tubes
from program import ROOT, SAMPLES, failures, records, thinpart

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad


def test_only_the_files_of_a_list_and_the_tree_of_the_paths(tmp_path):
    top = tmp_path / "parts"
    for place in ("a/1.step", "a/2.step", "b/new\nline.step", "b/4.step"):
        (top / place).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(TUBE, top / place)
    wanted = tmp_path / "list"
    wanted.write_bytes(b"".join(os.fsencode(top / place) + b"\0" for place in
                                ("b/new\nline.step", "a/2.step", "a/2.step", "gone.step")))
    run = thinpart("classify", top, "--only", wanted, "--info-dir", tmp_path / "info", "--json")
    assert run.returncode == 1 and failures(run) == {"gone.step": "missing"}
    assert {line["file"] for line in records(run)} == {
        str(top / place) for place in ("b/new\nline.step", "a/2.step", "gone.step")}
    assert sorted(str(path.relative_to(tmp_path / "info")) for path in
                  (tmp_path / "info").rglob("*.json")) == [
        "a/2.step.thinpart.json", "b/new\nline.step.thinpart.json"]


def test_a_list_that_cannot_be_used_is_answered_with_a_sentence(tmp_path):
    folder = tubes(tmp_path / "parts", "a.step")
    wanted = tmp_path / "list"
    run = thinpart("classify", folder, "--only", wanted)
    assert run.returncode == 2 and "cannot be read (No such file" in run.stderr
    wanted.write_bytes(b"a.step\0")
    run = thinpart("classify", folder, "--only", wanted, cwd=folder)
    assert run.returncode == 2 and "not an absolute path" in run.stderr
    wanted.write_bytes(os.fsencode(TUBE) + b"\0")
    run = thinpart("classify", folder, "--only", wanted, "--info-dir", tmp_path / "info")
    assert run.returncode == 2 and "does not lie below" in run.stderr
    assert thinpart("classify", folder, "--only", wanted, "--no-info").returncode == 0
    wanted.write_bytes(b"")
    assert "no parts" in thinpart("classify", folder, "--only", wanted).stderr


def test_include_and_exclude(tmp_path):
    top = tubes(tmp_path / "parts", "keep.STEP", "other.step")
    tubes(top / "old", "keep.step")
    run = thinpart("classify", top, "--json", "--no-info", "--include", "keep*", "--include", "x*",
                   "--exclude", "OLD/*")
    record, = records(run)
    assert run.returncode == 0 and record["file"] == str(top / "keep.STEP")


@pytest.mark.timeout(180)  # six runs, with up to four workers
def test_several_workers_give_the_same_as_one(tmp_path):
    folder = tubes(tmp_path / "parts", "b.step", "a.step", "d.step")
    shutil.copy(SAMPLES / "assembly_of_three.FCStd", folder / "c.FCStd")
    (folder / "e.step").write_bytes(b"")
    tables, printed, lines = [], [], []
    for jobs in ("1", "2", "4"):
        table = tmp_path / f"{jobs}.csv"
        run = thinpart("classify", folder, "--no-info", "--jobs", jobs, "--csv", table)
        tables.append(table.read_bytes())
        printed.append(run.stdout)
        run = thinpart("classify", folder, "--no-info", "--jobs", jobs, "--json")
        found = records(run)
        for line in found:
            line.pop("seconds", None)
        lines.append(sorted(json.dumps(line) for line in found))
    assert tables[0] == tables[1] == tables[2] and tables[0].count(b"\n") == 8
    assert printed[0] == printed[1] == printed[2] and lines[0] == lines[1] == lines[2]
    rows = list(csv.DictReader(io.StringIO(tables[0].decode())))
    assert [row["file"] for row in rows] == ["a.step", "b.step", *["c.FCStd"] * 3, "d.step", "e.step"]


def test_every_name_that_a_file_may_have(tmp_path):
    names = [b"with space.step", b"quote'\".step", b"new\nline.step", b"[red]x.step", b"-dash.step",
             b"colour\x1b[31m.step", b"latin\xe9.step", "üñí.step".encode(), b"a" * 236 + b".step"]
    folder = tmp_path / "parts"
    folder.mkdir()
    for name in names:
        shutil.copy(TUBE, os.fsencode(folder) + b"/" + name)
    table = tmp_path / "table.csv"
    run = thinpart("classify", folder, "--json")
    assert run.returncode == 0, run.stderr
    assert {os.fsencode(Path(line["file"]).name) for line in records(run)} == set(names)
    assert len(infos(folder)) == len(names)
    run = thinpart("classify", folder, "--csv", table)
    assert run.returncode == 0 and len(run.stdout.splitlines()) >= 1 + len(names)
    assert "new\\nline.step" in run.stdout and "[red]x.step" in run.stdout
    assert "\x1b" not in run.stdout and "latin\\udce9.step" in run.stdout
    with open(table, newline="", encoding="utf-8") as file:
        assert "new\nline.step" in [row["file"] for row in csv.DictReader(file)]


@pytest.mark.parametrize("ending", ["step", "brep", "stl", "FCStd"])
def test_bytes_of_a_folder_that_are_no_text(tmp_path, ending):
    import Mesh
    import Part

    folder = tmp_path / os.fsdecode(b"caf\xe9")
    folder.mkdir()
    made = tmp_path / f"made.{ending}"
    if ending == "stl":
        Mesh.createBox(10, 10, 10).write(str(made))
    elif ending == "brep":
        Part.makeBox(10, 10, 10).exportBrep(str(made))
    else:
        shutil.copy(SAMPLES / f"block.{ending}", made)
    made.rename(folder / made.name)
    run = thinpart("classify", folder, "--json")
    record, = records(run)
    assert record["category"] == "normal" and infos(folder)
    assert record["label"] == ("Block" if ending == "FCStd" else "made")


def test_failures_of_odd_names_are_one_line_each(tmp_path):
    (tmp_path / "new\nline\x1b[31m.step").write_bytes(b"")
    run = thinpart("classify", tmp_path)
    assert len(run.stderr.splitlines()) == 1 and "new\\nline\\x1b[31m.step is empty" in run.stderr
    assert "new\\nline\\x1b[31m.step" in run.stdout and "\x1b" not in run.stdout + run.stderr


def test_a_name_too_long_for_an_info_file_is_told_and_the_part_classified(tmp_path):
    name = "a" * 237 + ".step"
    folder = tubes(tmp_path / "parts", name, "b.step")
    run = thinpart("classify", folder, "--json")
    assert run.returncode == 1 and set(infos(folder)) == {"b.step"}
    part, error = [line for line in records(run) if Path(line["file"]).name == name]
    assert part["category"] == "thin" and error["error"]["kind"] == "info_write"
    assert "has 242 bytes, at most 241 are possible" in error["error"]["message"]
    assert "--info-dir" not in run.stderr and messages(run.stderr)[0][-1]["progress"]["failed"] == 1
    assert thinpart("classify", folder, "--no-info").returncode == 0


def test_dangling_and_looping_links_are_rows(tmp_path):
    folder = tubes(tmp_path / "parts", "a.step")
    (folder / "gone.step").symlink_to("nothing")
    (folder / "self.step").symlink_to("self.step")
    (folder / "folder").symlink_to(".")
    table = tmp_path / "table.csv"
    run = thinpart("classify", folder, "--json", "--no-info", "--csv", table)
    assert run.returncode == 1 and failures(run) == {"gone.step": "missing", "self.step": "missing"}
    assert len(records(run)) == 3 and len(table.read_text().splitlines()) == 4
    assert messages(run.stderr)[0][-1]["progress"]["total"] == 1


def test_info_files_that_a_shell_names_are_no_parts(tmp_path):
    folder = tubes(tmp_path / "parts", "a.step")
    assert thinpart("classify", folder).returncode == 0
    assert len(list(folder.iterdir())) == 2
    run = thinpart("classify", *folder.iterdir(), "--json")
    assert run.returncode == 0 and len(records(run)) == 1


@pytest.fixture
def nobody(tmp_path):
    """As a user who may do nothing, in a place that he may enter: root may read everything."""
    if os.geteuid() != 0:
        return {}
    for parent in [tmp_path, *tmp_path.parents]:
        if parent.stat().st_uid == os.geteuid() and parent != Path("/"):
            parent.chmod(parent.stat().st_mode | 0o755)
    return {"user": 65534, "group": 65534, "extra_groups": []}


def test_a_folder_without_permission_is_named(tmp_path, nobody):
    folder = tubes(tmp_path / "parts", "a.step")
    tubes(folder / "locked", "b.step").chmod(0)
    (folder / "half").mkdir()
    tubes(folder / "half", "c.step").chmod(0o444)  # may be listed; what lies in it may not be opened
    try:
        run = thinpart("classify", folder, "--json", "--no-info", **nobody)
        assert run.returncode == 1
        assert failures(run) == {"locked": "permission", "c.step": "permission"}
        assert "no permission to search the folder locked" in run.stderr
        assert [line["category"] for line in records(run) if "category" in line] == ["thin"]
        inner = thinpart("classify", folder / "locked" / "b.step", "--no-info", "--json", **nobody)
        assert inner.returncode == 1 and failures(inner) == {"b.step": "permission"}
        alone = thinpart("classify", folder / "locked", "--no-info", **nobody)
        assert alone.returncode == 1 and "no permission to search" in alone.stderr
        assert "failed: permission" in alone.stdout
    finally:
        (folder / "locked").chmod(0o755)
        (folder / "half").chmod(0o755)


def test_an_info_folder_that_cannot_be_is_one_sentence(tmp_path, nobody):
    folder = tubes(tmp_path / "parts", "a.step", "b.step")
    (tmp_path / "file").write_text("mine")
    for place in (tmp_path / "file", tmp_path / "file" / "inner"):
        run = thinpart("classify", folder, "--info-dir", place)
        assert run.returncode == 2 and len(run.stderr.splitlines()) == 1
        assert "cannot be written into" in run.stderr and "--info-dir" in run.stderr
    closed = tmp_path / "closed"
    closed.mkdir(mode=0o555)
    for place in (closed, closed / "new"):
        run = thinpart("classify", folder, "--info-dir", place, **nobody)
        assert run.returncode == 2 and "Permission denied" in run.stderr
    assert (tmp_path / "file").read_text() == "mine" and not list(closed.iterdir())


def test_a_file_that_changes_while_it_is_read_is_told(tmp_path):
    folder = tubes(tmp_path / "parts", "a.step", "steady.step")
    over = threading.Event()

    def touch():
        number = 0
        while not over.is_set():
            number += 1
            os.utime(folder / "a.step", (number, number))
            time.sleep(0.002)

    thread = threading.Thread(target=touch)
    thread.start()
    try:
        run = thinpart("classify", folder, "--json")
    finally:
        over.set()
        thread.join()
    assert run.returncode == 1 and failures(run) == {"a.step": "unreadable"}
    assert "changed while it was read" in run.stderr and set(infos(folder)) == {"steady.step"}


def test_no_place_for_temporary_files_is_one_sentence(tmp_path):
    def write_nothing():
        resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))

    run = thinpart("classify", TUBE, "--no-info", cwd=tmp_path, preexec_fn=write_nothing)
    assert run.returncode == 1 and "TMPDIR" in run.stderr and "Traceback" not in run.stderr


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no full device here")
@pytest.mark.parametrize("arguments", [[], ["--json"]])
def test_output_without_room_is_one_sentence(tmp_path, arguments):
    folder = tubes(tmp_path / "parts", "a.step")
    with open("/dev/full", "w") as full:
        run = subprocess.run(
            [sys.executable, "-m", "thinpart_workbench", "classify", str(folder), *arguments],
            env=dict(os.environ, PYTHONPATH=str(ROOT)), stdin=subprocess.DEVNULL, stdout=full,
            stderr=subprocess.PIPE, encoding="utf-8")
    sentence, = messages(run.stderr)[1]
    assert run.returncode == 1 and "No space left on device" in sentence and infos(folder)


def test_a_table_without_room_is_one_sentence_and_the_old_one_stays(tmp_path):
    folder = tmp_path / "parts"
    folder.mkdir()
    for number in range(40):
        (folder / f"{number}.step").write_bytes(b"")
    table = tmp_path / "table.csv"
    table.write_text("file,part,label,instances,category,criteria,\n")

    def write_little():
        resource.setrlimit(resource.RLIMIT_FSIZE, (2048, 2048))

    run = thinpart("classify", folder, "--no-info", "--csv", table, preexec_fn=write_little)
    assert run.returncode == 1 and run.stdout.count("failed: empty") == 40
    assert "table.csv could not be written (File too large)" in run.stderr.splitlines()[-1]
    assert table.read_text().startswith("file,part,label,") and sorted(os.listdir(tmp_path)) == ["parts", "table.csv"]


def test_a_document_with_a_drawing_is_read(tmp_path):
    load_freecad()
    import FreeCAD as App
    import Part
    import TechDraw  # noqa: F401

    document = App.newDocument("drawn")
    document.addObject("Part::Feature", "Plate").Shape = Part.makeBox(40, 30, 2)
    page = document.addObject("TechDraw::DrawPage", "Page")
    page.Template = document.addObject("TechDraw::DrawSVGTemplate", "Template")
    templates = Path(App.getResourceDir(), "Mod", "TechDraw", "Templates")
    page.Template.Template = os.fspath(next(path for path in sorted(templates.rglob("*.svg")) if "A4" in path.name))
    document.recompute()
    document.saveAs(os.fspath(tmp_path / "drawn.FCStd"))
    App.closeDocument("drawn")
    # FreeCAD 1.1 changes the mode of its copy of the template when it closes the document, which a reader may not.
    run = thinpart("classify", tmp_path / "drawn.FCStd", "--json")
    assert run.returncode == 0 and [record["category"] for record in records(run)] == ["thin"], run.stderr
