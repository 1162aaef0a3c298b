# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that counts what a profile would change, writes it when asked to, and stops when told to."""

import copy
import json
import subprocess
import sys
from collections import Counter

import made_meshes
import pytest
from made_library import PAPER, make_large_library, make_library, measured_record, record_of, store

from thinpart_workbench.api.reclassification import reclassify
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.storage.info.info_file import read_info

FILES = 300


@pytest.fixture
def library(tmp_path):
    models = tmp_path / "models"
    models.mkdir()
    infos = [store(models, "Plate.step", [measured_record("Plate", made_meshes.box(100, 100, 2))]),
             store(models, "Block.step", [measured_record("Block", made_meshes.box(100, 80, 60))])]
    make_large_library(tmp_path / "library", infos, FILES)
    (tmp_path / "library" / "broken.step.thinpart.json").write_text("{")
    return tmp_path / "library"


def filled(share):
    content = copy.deepcopy(PAPER.content)
    content["categories"][0]["criteria"][0]["conditions"] = [{"quantity": "V/VBB", "comparison": ">", "value": share}]
    return content


class Worker:
    """The process, as the window uses it."""

    def __init__(self):
        self.process = subprocess.Popen(
            [sys.executable, "-m", "thinpart_workbench.window_processes.judging_worker"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")

    def ask(self, *requests):
        self.process.stdin.write("".join(json.dumps(each) + "\n" for each in requests))
        self.process.stdin.flush()

    def answer(self, key):
        for line in self.process.stdout:
            content = json.loads(line)
            if key in content:
                return content[key]
        raise AssertionError(self.process.stderr.read())

    def counted(self, serial):
        """The counts once all info files were read."""
        while True:
            counts = self.answer("counted")
            assert counts["serial"] <= serial
            if counts["serial"] == serial and counts["read"] == counts["total"]:
                return counts


@pytest.fixture
def worker():
    worker = Worker()
    yield worker
    worker.process.stdin.close()
    assert worker.process.wait(60) == 0
    worker.process.stdout.close()
    worker.process.stderr.close()


def judge(serial, profile):
    return {"ask": "judge", "serial": serial, "profile": profile}


def expected(library, profile):
    """The changes that reclassifying makes, and the number of info files that differ."""
    files = list(reclassify(library, profile))
    changes = Counter((part.before["category"], part.after["category"]) for file in files for part in file.parts)
    return ({pair: count for pair, count in changes.items() if pair[0] != pair[1]}, sum(file.differs for file in files))


def test_the_counts_are_those_of_reclassifying(library, worker):
    before = {path: path.read_bytes() for path in library.rglob("*.json")}
    worker.ask({"ask": "open", "roots": [str(library)]})
    for serial, profile in enumerate((filled(0.7), filled(0.99), load_profile("calibrated").content)):
        worker.ask(judge(serial, profile))
        counts = worker.counted(serial)
        assert counts["parts"] == FILES and counts["failed"] == 1 and counts["total"] == FILES + 1
        told = {(before, after): count for before, after, count in counts["changes"]}
        assert (told, counts["files"]) == expected(library, profile)
        assert "broken.step.thinpart.json" in counts["problems"][0]
    assert before == {path: path.read_bytes() for path in library.rglob("*.json")}


def test_the_parts_of_a_change_are_named(library, worker):
    worker.ask({"ask": "open", "roots": [str(library)]}, judge(1, filled(0.01)))
    (before, after, count), = worker.counted(1)["changes"]
    assert (before, after) == ("normal", "thin")
    worker.ask({"ask": "parts", "serial": 0, "before": before, "after": after},  # of a profile that is gone
               {"ask": "parts", "serial": 1, "before": before, "after": after})
    found = worker.answer("parts")
    assert found["serial"] == 1 and len(found["rows"]) == count == FILES // 2
    row = found["rows"][0]
    assert row["label"].startswith("Block") and row["name"] == "Solid1"
    assert row["info_file"] == row["file"] + ".thinpart.json" and row["file"].startswith(str(library))


UNMEASURED_LOCAL = {"bins": [], "area": [], "T05": None, "T50": None, "T75": None, "T99": None}


@pytest.mark.parametrize("quantity, key, unmeasured_value", [
    ("plate_share", "plate_share", None), ("L[0;0.08]", "local", UNMEASURED_LOCAL), ("T05", "local", UNMEASURED_LOCAL)])
def test_a_record_without_a_quantity_is_to_be_measured_again(tmp_path, worker, quantity, key, unmeasured_value):
    old = record_of("cube", name="Solid2", label="old")
    del old["descriptors"][key]
    unmeasured = record_of("cube", name="Solid3", label="unmeasured")
    unmeasured["descriptors"][key] = unmeasured_value
    store(tmp_path, "Mixed.step", [record_of("cube"), old, unmeasured])
    content = copy.deepcopy(PAPER.content)
    content["categories"][0]["criteria"][0]["conditions"] = [{"quantity": quantity, "comparison": ">", "value": 0.999}]
    worker.ask({"ask": "open", "roots": [str(tmp_path)]}, judge(1, content))
    counts = worker.counted(1)
    assert counts["changes"] == [["normal", "measure_again", 1], ["normal", "unknown", 1]]
    worker.ask({"ask": "parts", "serial": 1, "before": "normal", "after": "measure_again"})
    assert [row["label"] for row in worker.answer("parts")["rows"]] == ["old"]


def test_other_folders_are_counted_anew(library, tmp_path, worker):
    other = make_library(tmp_path / "other")
    worker.ask({"ask": "open", "roots": [str(library)]}, judge(1, PAPER.content))
    worker.counted(1)
    worker.ask({"ask": "open", "roots": [str(other)]}, judge(2, PAPER.content))
    counts = worker.counted(2)
    assert counts["parts"] == 9 and counts["changes"] == [] and counts["files"] == 0


def test_a_request_ends_the_one_before(library, worker):
    worker.ask({"ask": "open", "roots": [str(library)]},
               *(judge(serial, filled(0.3 + serial / 1000)) for serial in range(200)))
    seen = []
    while not seen or seen[-1]["serial"] < 199 or seen[-1]["read"] < seen[-1]["total"]:
        seen.append(worker.answer("counted"))
    assert len(seen) < 100


def test_a_folder_that_is_not_there_is_a_problem(tmp_path, worker):
    worker.ask({"ask": "open", "roots": [str(tmp_path / "gone")]}, judge(1, PAPER.content))
    counts = worker.counted(1)
    assert counts["parts"] == 0 and "gone" in counts["problems"][0]


def written(worker, profile):
    """What is said of writing when it ends."""
    worker.ask({"ask": "write", "profile": profile})
    while not (told := worker.answer("written"))["ended"]:
        pass
    return told


def test_what_was_written_is_counted_anew_and_does_not_differ_any_more(library, worker):
    content = {**filled(0.01), "name": "generous"}
    worker.ask({"ask": "open", "roots": [str(library)]}, judge(1, content))
    assert worker.counted(1)["files"] == FILES
    told = written(worker, content)
    assert (told["done"], told["total"], told["changed"], told["failed"]) == (FILES + 1, FILES + 1, FILES, 1)
    assert "broken.step.thinpart.json" in told["problems"][0]
    info = read_info(next(library.rglob("part*.json")))
    assert info["profile"]["name"] == "generous" and info["parts"][0]["category"] == "thin"
    counts = worker.counted(1)
    assert counts["changes"] == [] and counts["files"] == 0 and counts["parts"] == FILES


def test_writing_stops_when_told_to_and_what_was_asked_then_is_answered(library, worker):
    content = filled(0.01)
    worker.ask({"ask": "open", "roots": [str(library)]}, {"ask": "write", "profile": content}, {"ask": "stop"},
               judge(5, content))
    while not (told := worker.answer("written"))["ended"]:
        pass
    assert told["done"] < FILES
    assert worker.counted(5)["parts"] == FILES


def test_writing_stops_when_nobody_listens_any_more(library):
    worker = Worker()
    worker.ask({"ask": "open", "roots": [str(library)]}, {"ask": "write", "profile": filled(0.01)})
    worker.process.stdin.close()
    told = [json.loads(line)["written"] for line in worker.process.stdout]
    assert worker.process.wait(60) == 0 and told[-1]["ended"] and told[-1]["done"] < FILES
    for stream in (worker.process.stdout, worker.process.stderr):
        stream.close()
