"""The benchmark runs and writes what it says; how fast anything is, is not tested."""

import json
import os
import subprocess
import sys

import pytest

from program import ROOT

QUICKEST = ("--solids", "shell", "--sizes", "1000", "--repeat", "1", "--no-peers", "--no-command-line")


def benchmark(*arguments, cache):
    environment = dict(os.environ, THINPART_CACHE=str(cache), COLUMNS="200")
    return subprocess.run(
        [sys.executable, ROOT / "benchmarks" / "run.py", *map(str, arguments)], env=environment,
        capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL,
    )


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("benchmark")
    run = benchmark(*QUICKEST, "-o", folder / "results.json", cache=folder)
    assert run.returncode == 0, run.stderr
    run.file = folder / "results.json"
    run.results = json.loads(run.file.read_text(encoding="utf-8"))
    return run


def test_every_figure_of_both_placements_is_there(run):
    aligned, rotated = run.results["meshes"]
    assert (aligned["placement"], rotated["placement"]) == ("aligned", "rotated")
    for row in (aligned, rotated):
        assert row["failures"] == {}
        assert 700 < row["triangles"] < 1400
        assert {"tessellation", "core", "whole", "box", "nonparallel"} <= row["seconds"].keys()
        assert all(0.0 < seconds < 100.0 for times in row["seconds"].values() for seconds in times)
        assert row["found"]["whole"]["samples"] >= 20_000
        assert row["found"]["box"]["volume"] == pytest.approx(40.0 ** 3, rel=0.03)
        assert 0.0 <= row["bytes_per_triangle"]["core"] < row["bytes_per_triangle"]["whole"]
    # The same triangles, turned.
    assert aligned["triangles"] == rotated["triangles"]


def test_machine_versions_and_date_are_there(run):
    assert {"cpu", "cores", "memory_gb", "os"} <= run.results["machine"].keys()
    assert {"ThinPart", "Python", "numpy", "scipy", "FreeCAD", "OCCT"} <= run.results["versions"].keys()
    assert run.results["date"].startswith("20")


def test_nothing_names_a_folder_of_this_machine(run):
    text = run.file.read_text(encoding="utf-8")
    assert str(ROOT) not in text and str(run.file.parent) not in text


def test_what_was_not_measured_is_said_not_to_be(run):
    verdicts = {line["what"]: line["verdict"] for line in run.results["summary"]}
    assert verdicts["rotated / axis-aligned, worst"] != "not measured"
    assert verdicts["core / trimesh with embreex, geometric mean"] == "not measured"
    assert verdicts["one small part, command line, s"] == "not measured"
    assert "not measured" in run.stdout and "shell" in run.stdout


def test_results_are_shown_again_as_markdown(run):
    shown = benchmark("--show", run.file, "--markdown", cache=run.file.parent)
    assert shown.returncode == 0, shown.stderr
    assert shown.stdout.startswith("| triangles, about | core s |") and "| 1,000 |" in shown.stdout


def test_a_wrong_file_is_one_sentence(tmp_path):
    (tmp_path / "other.json").write_text("{}", encoding="utf-8")
    shown = benchmark("--show", tmp_path / "other.json", cache=tmp_path)
    assert shown.returncode == 1
    assert shown.stderr.count("\n") == 1 and "no results file" in shown.stderr
