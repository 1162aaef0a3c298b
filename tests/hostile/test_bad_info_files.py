# SPDX-License-Identifier: LGPL-2.1-or-later
"""Info files of every bad kind beside good ones: each is named with a sentence, none is changed, the rest goes on."""

import csv
import json
import os
import shutil

import pytest
from bad_info_files import BAD
from made_meshes import box
from program import thinpart

from thinpart_workbench.api.document_info import file_stamp, write_document_info
from thinpart_workbench.cli import main
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.storage.info.info_file import SUFFIX, info_path, read_info
from thinpart_workbench.window_processes.library_worker import LibraryWorker

LATIN_1 = os.fsdecode(b"caf\xe9.stl")
GOOD = ("good.stl", "also good.stl", LATIN_1)


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """Measured documents, a good one and one for each bad kind, whose info files are spoilt then."""
    folder = tmp_path_factory.mktemp("bad") / "library"
    folder.mkdir()
    corners, triangles = box(30, 20, 2)
    facets = ""
    for each in triangles:
        loop = "\n".join("vertex {:g} {:g} {:g}".format(*corners[corner]) for corner in each)
        facets += f"facet normal 0 0 0\nouter loop\n{loop}\nendloop\nendfacet\n"
    for name in (*GOOD, *(f"{kind}.stl" for kind in BAD)):
        (folder / name).write_text(f"solid x\n{facets}endsolid x\n")
    assert thinpart("classify", folder, "--jobs", 2, "--no-thumbnails").returncode == 0
    for kind, spoil in BAD.items():
        info = info_path(folder / f"{kind}.stl")
        bad = spoil(info.read_text(encoding="utf-8"))
        info.write_bytes(bad if isinstance(bad, bytes) else bad.encode())
    _add_failure(info_path(folder / LATIN_1))
    return folder


def _add_failure(info):
    """One solid of the document that is none: the sentence about it names the file, whose name is no text."""
    content = read_info(info)
    label = os.fsdecode(b"caf\xe9")
    content["failures"] = [
        {"part": "Solid2", "label": label, "kind": "no_solid", "message": f"{label} bounds no solid."}]
    info.write_text(json.dumps(content))


@pytest.fixture
def untouched(library):
    """Whatever a test does, what is bad stays as it is."""
    before = {kind: info_path(library / f"{kind}.stl").read_bytes() for kind in BAD}
    yield library
    for kind, content in before.items():
        assert info_path(library / f"{kind}.stl").read_bytes() == content, kind


def run_over(*arguments):
    run = thinpart(*arguments, errors="surrogateescape")
    assert "Traceback" not in run.stderr, run.stderr
    return run


def lines(run):
    """Lines of JSON, which has no NaN and no Infinity."""
    return [json.loads(line, parse_constant=pytest.fail) for line in run.stdout.splitlines()]


def parts(run):
    """The documents whose parts a command printed."""
    return sorted(os.path.basename(line["file"]) for line in lines(run) if "error" not in line)


def kinds(paths):
    """The bad kinds among paths of documents or info files."""
    names = {os.path.basename(path).removesuffix(SUFFIX).removesuffix(".stl") for path in paths}
    return names & set(BAD)


def test_there_are_many_kinds():
    assert len(BAD) >= 65


def test_find(untouched):
    run = run_over("find", untouched)
    assert run.returncode == 0 and len(kinds(run.stdout.split())) == 0
    assert all(name.split(".")[0] in run.stdout for name in GOOD[:2])
    assert run.stderr.count("thinpart: ") == 6 and f"{len(BAD) - 5} more info files" in run.stderr


def test_find_json(untouched):
    assert parts(run_over("find", untouched, "--json")) == sorted(GOOD)
    failed = [line for line in lines(run_over("find", untouched, "--json", "--failed"))]
    sentences = {line["info_file"]: line["error"]["message"] for line in failed
                 if line["error"]["kind"] == "info_file"}
    assert kinds(sentences) == set(BAD)
    for path, sentence in sentences.items():
        assert os.path.basename(path) in sentence and sentence.endswith(".") and len(sentence) < 400, sentence
    own, = (line for line in failed if line["error"]["kind"] == "no_solid")
    assert own["file"].endswith(LATIN_1) and own["error"]["message"].endswith("bounds no solid.")


def test_similar(untouched):
    found = parts(run_over("similar", untouched / "good.stl", untouched, "--json", "-n", 200))
    assert found == sorted(set(GOOD) - {"good.stl"})
    assert "thinpart: " in run_over("similar", untouched / "good.stl", untouched).stderr


def test_reclassify(untouched, tmp_path):
    for write in ((), ("--write",)):
        run = run_over("reclassify", untouched, "--profile", "paper", "--json", *write)
        assert run.returncode == 1 and parts(run) == sorted(GOOD)
        named = [line.split(": ")[1] for line in run.stderr.splitlines() if line.startswith("thinpart: ")]
        assert kinds(named) == set(BAD)


def test_classify_measures_anew_and_says_why_nothing_was_written(untouched, tmp_path):
    table = tmp_path / "table.csv"
    run = run_over("classify", untouched, "--json", "--jobs", 2, "--no-thumbnails", "--csv", table)
    assert run.returncode == 1 and parts(run) == sorted([*GOOD, *(f"{kind}.stl" for kind in BAD)])
    errors = {line["file"]: line["error"] for line in lines(run) if "error" in line}
    assert kinds(errors) == set(BAD)
    for path, error in errors.items():
        if not path.endswith(LATIN_1):
            assert error["kind"] == "info_write" and "not changed" in error["message"], error
            assert "ove it away" in error["message"], error
    with open(table, newline="", encoding="utf-8") as file:
        assert kinds(row["file"] for row in csv.DictReader(file) if row["error"]) == set(BAD)


@pytest.mark.parametrize("arguments", [("note", "{}"), ("note", "{}", "--set", "mine"), ("note", "{}", "--json"),
                                       ("similar", "{}", ".")], ids=" ".join)
def test_commands_about_one_part_say_what_is_wrong_with_its_info_file(untouched, capsys, arguments):
    for kind in BAD:
        path = os.fspath(untouched / f"{kind}.stl")
        assert main([each.format(path) for each in arguments]) == 1, kind
        said = capsys.readouterr().err
        assert said.count("\n") == 1 and f"{kind}.stl{SUFFIX}" in said, said


def test_what_stands_behind_the_window_goes_on(untouched):
    told = []
    worker = LibraryWorker(lambda **content: told.append(content), told.append)
    for kind in BAD:
        info = os.fspath(info_path(untouched / f"{kind}.stl"))
        worker.record(info, "Mesh")
        worker.keep(os.fspath(untouched), info, "Mesh", "mine", None, None)
        record, kept = (each for each in told[-2:])
        assert record["record"]["sentence"].endswith(".") and kept["kept"]["sentence"].endswith("."), kind
        json.dumps(told, allow_nan=False)


def test_a_document_of_the_window_is_not_written_over_it(untouched):
    good = read_info(info_path(untouched / "good.stl"))
    for kind in BAD:
        document = os.fspath(untouched / f"{kind}.stl")
        with pytest.raises(ThinPartError, match="not changed") as failure:
            write_document_info(document, file_stamp(document), good["parts"], [], good["profile"],
                                AnalysisSettings(**good["settings"]))
        assert failure.value.kind == "info_write"


def test_a_report_shows_what_it_measured(library, tmp_path):
    chosen = "good", "borderline_1e999", "box_of_zeros", "parts_are_a_number", "deep_lists"
    for each in chosen:
        for path in (library / f"{each}.stl", info_path(library / f"{each}.stl")):
            shutil.copy2(path, tmp_path)
    run = run_over("report", tmp_path, "--output", tmp_path / "pages")
    assert len(list((tmp_path / "pages").rglob("*.html"))) == len(chosen) + 1, run.stderr
