"""The process that judges libraries again: it counts, writes when asked to, and stops when told to."""

import json
import subprocess
import sys

import made_meshes
import pytest
from made_library import PAPER, make_large_library, measured_record, store

from thinpart_workbench.storage.info.info_file import read_info

FILES = 400
"""More than the processes take at once."""


@pytest.fixture
def library(tmp_path):
    models = tmp_path / "models"
    models.mkdir()
    infos = [store(models, "Plate.step", [measured_record("Plate", made_meshes.box(100, 100, 2))]),
             store(models, "Block.step", [measured_record("Block", made_meshes.box(100, 80, 60))])]
    make_large_library(tmp_path / "library", infos, FILES)
    (tmp_path / "library" / "broken.step.thinpart.json").write_text("{")
    return tmp_path / "library"


@pytest.fixture
def generous():
    content = json.loads(json.dumps(PAPER.content))
    content["name"] = "generous"
    content["categories"][0]["criteria"][0]["conditions"] = [
        {"quantity": "V/VBB", "comparison": ">", "value": 0.01}]
    return content


def started():
    return subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench.window_processes.reclassify_worker"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")


def request(library, profile, write=False):
    return json.dumps({"roots": [str(library)], "profile": profile, "write": write}) + "\n"


def judged(library, profile, write=False):
    with started() as process:
        process.stdin.write(request(library, profile, write))
        process.stdin.flush()
        lines = [json.loads(line) for line in process.stdout]
        assert process.wait(60) == 0, process.stderr.read()
    assert lines[-1]["ended"] == "done"
    return lines[-1]["judged"]


def test_a_preview_counts_and_writes_nothing(library, generous):
    before = {path: path.read_bytes() for path in library.rglob("*.json")}
    told = judged(library, generous)
    assert told["total"] == told["done"] == FILES + 1 and told["failed"] == 1
    assert told["after"] == {"thin": FILES} and sum(told["before"].values()) == FILES
    assert told["differing"] == FILES and 0 < told["changed"] <= FILES
    assert "broken.step.thinpart.json" in told["errors"][0]
    assert before == {path: path.read_bytes() for path in library.rglob("*.json")}


def test_what_was_written_does_not_differ_any_more(library, generous):
    assert judged(library, generous, write=True)["differing"] == FILES
    info = next(library.rglob("part*.json"))
    assert read_info(info)["profile"]["name"] == "generous"
    assert read_info(info)["parts"][0]["category"] == "thin"
    again = judged(library, generous)
    assert (again["differing"], again["changed"]) == (0, 0)


@pytest.mark.parametrize("how", ["told to", "left alone"])
def test_it_stops(library, generous, how):
    with started() as process:
        process.stdin.write(request(library, generous))
        if how == "told to":
            process.stdin.write(json.dumps({"ask": "stop"}) + "\n")
            process.stdin.flush()
        else:
            process.stdin.close()
        lines = [json.loads(line) for line in process.stdout]
        assert process.wait(60) == 0
    assert lines[-1]["ended"] == "stopped" and lines[-1]["judged"]["done"] < FILES
