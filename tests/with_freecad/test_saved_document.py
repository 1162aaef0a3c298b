# SPDX-License-Identifier: LGPL-2.1-or-later
"""A saved document classified in the background, and its info file in a folder that may not answer."""

import fcntl
import json
import os
import shutil
import subprocess
import sys
import time

import pytest
import time_limit
from program import ROOT, SAMPLES, group_ended
from slow_files import held

from thinpart_workbench.api.document_info import file_stamp
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.storage.info.info_location import call_in_folder, info_location


class Worker:
    """The process that calls functions of api, with one request."""

    def __init__(self, function, folder="", **arguments):
        self.process = subprocess.Popen(
            [sys.executable, "-m", "thinpart_workbench.window_processes.request_worker"], stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, env=dict(os.environ, PYTHONPATH=str(ROOT)), start_new_session=True)
        request = {"ask": function, "arguments": arguments, "preferred": {"folder": folder}}
        self.process.stdin.write(json.dumps(request).encode() + b"\n")
        self.process.stdin.flush()

    def answer(self):
        line = self.process.stdout.readline()
        self.process.stdin.close()
        self.process.wait()
        self.process.stdout.close()
        answer = json.loads(line)
        return answer.get("answer") or answer


def job(document, **changes):
    return {"document": str(document), "folder": "", "settings": AnalysisSettings().content(),
            "profile": "paper", "seconds": 300, "megabytes": 6144, **changes}


def classified(document, **changes):
    return Worker("saved_documents.classify_saved", **job(document, **changes)).answer()


@pytest.fixture
def plate(tmp_path):
    return shutil.copy(SAMPLES / "plate.FCStd", tmp_path / "plate.FCStd")


def test_measured_once_and_taken_from_the_info_file_afterwards(plate):
    looked = classified(plate, measure=False)
    assert looked["verdicts"] is None and not looked["current"] and not info_location(plate).exists()
    first = classified(plate)
    verdict, = first["verdicts"].values()
    assert (verdict["label"], verdict["category"]) == ("Mounting plate", "thin")
    assert verdict["title"] == "Thin part"
    assert verdict["thickness"] == pytest.approx(8) and first["before"] is None
    assert not first["current"] and first["failures"] == []
    written = info_location(plate).read_bytes()
    for measure in (True, False):
        again = classified(plate, measure=measure)
        assert again["current"] and again["verdicts"] == again["before"] == first["verdicts"]
    assert info_location(plate).read_bytes() == written
    os.utime(plate, (1, 1))
    shutil.copy(SAMPLES / "block.FCStd", plate)
    changed = classified(plate)
    assert changed["before"] == first["verdicts"] and not changed["current"]
    assert [each["category"] for each in changed["verdicts"].values()] == ["normal"]


def test_documents_of_one_name_do_not_share_an_info_file_in_a_folder(tmp_path):
    info = tmp_path / "info"
    info.mkdir()
    for folder, sample in (("a", "plate"), ("b", "block")):
        (tmp_path / folder).mkdir()
        document = shutil.copy(SAMPLES / f"{sample}.FCStd", tmp_path / folder / "part.FCStd")
        assert classified(document, folder=str(info))["failures"] == []
        assert classified(document, folder=str(info))["current"]
    assert [read_info(info_location(str(tmp_path / folder / "part.FCStd"), str(info)))["parts"][0]["category"]
            for folder in "ab"] == ["thin", "normal"]
    assert len(list(info.rglob("*.thinpart.json"))) == 2 and not list((tmp_path / "a").glob("*.json"))


def test_a_folder_that_is_gone_or_does_not_answer_is_one_sentence_and_the_verdict_comes(plate, tmp_path):
    answer = classified(plate, folder=str(tmp_path / "gone"))
    assert "cannot be reached" in answer["failures"][0] and len(answer["failures"]) == 1
    assert len(answer["verdicts"]) == 1 and not (tmp_path / "gone").exists()
    info = info_location(plate, str(tmp_path))
    info.parent.mkdir(parents=True)
    with held(info):
        answer = classified(plate, folder=str(tmp_path), patience=0.5)
    assert "has not answered for 0.5 s" in answer["failures"][0] and len(answer["verdicts"]) == 1


def test_what_is_no_info_file_is_left_alone(plate):
    info_location(plate).write_text("mine")
    answer = classified(plate)
    assert len(answer["verdicts"]) == 1 and "is left" not in answer["no_part"]
    assert len(answer["failures"]) == 1 and info_location(plate).read_text() == "mine"


def test_a_document_without_a_part_is_no_failure(freecad, tmp_path):
    document = freecad.newDocument("Empty")
    document.addObject("Part::Feature", "Wire").Shape = __import__("Part").makeLine((0, 0, 0), (1, 0, 0))
    document.saveAs(str(tmp_path / "wire.FCStd"))
    freecad.closeDocument(document.Name)
    answer = classified(tmp_path / "wire.FCStd")
    assert answer["failures"] == [] and "no closed solid" in answer["no_part"]
    assert not list(tmp_path.glob("*.json"))


def test_failures_are_sentences(plate, tmp_path):
    assert "There is no profile" in classified(plate, profile=str(tmp_path / "none.json"))["refused"]
    assert "took longer than 0.05 s" in classified(plate, seconds=0.05)["failures"][0]


def test_it_ends_when_nobody_listens_while_it_measures(tmp_path):
    document = shutil.copy(SAMPLES / "worm_run_out.FCStd", tmp_path / "worm.FCStd")
    worker = Worker("saved_documents.classify_saved", **job(document))
    time_limit.wait_until(lambda: [*time_limit.children(worker.process.pid)], "the measuring process")
    _assert_it_ends(worker)


def test_it_ends_when_nobody_listens_while_it_waits_for_the_folder(tmp_path):
    document = shutil.copy(SAMPLES / "worm_run_out.FCStd", tmp_path / "worm.FCStd")
    with held(info_location(document)):
        worker = Worker("saved_documents.classify_saved", **job(document))
        time.sleep(2.0)
        _assert_it_ends(worker)


def _assert_it_ends(worker):
    worker.process.stdin.close()
    worker.process.wait()
    with worker.process.stdout as output:
        assert output.read() == b"" and group_ended(worker.process.pid)


@pytest.fixture
def written(tmp_path):
    """Has the info file of a document written, with records that were measured elsewhere."""
    (tmp_path / "elsewhere").mkdir()
    measured = shutil.copy(SAMPLES / "plate.FCStd", tmp_path / "elsewhere" / "plate.FCStd")
    assert classified(measured)["failures"] == []
    records = read_info(info_location(measured))["parts"]

    def write(document, **changes):
        return Worker("document_info.write_document_info", **{
            "document": str(document), "folder": "", "stamp": file_stamp(document),
            "settings": AnalysisSettings().content(), "profile": load_profile("paper").content,
            "records": records, "failures": [], **changes}).answer()

    return write


def test_the_info_file_of_an_open_document_is_written_and_compared(plate, written):
    answer = written(plate)
    assert answer["path"] == str(info_location(plate)) and answer["before"] is None
    assert [each["category"] for each in answer["now"].values()] == ["thin"]
    assert written(plate)["before"] == answer["now"]
    size, time_ns = file_stamp(plate)
    assert "was saved again" in written(plate, stamp=[size, time_ns + 1])["refused"]


def test_writing_waits_only_so_long_for_a_folder(plate, written, tmp_path):
    folder = tmp_path / "info"
    folder.mkdir()
    place = info_location(plate, str(folder)).parent
    place.mkdir(parents=True)
    handle = os.open(place, os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)  # as if another computer were writing there, without end
    answer = written(plate, folder=str(folder), patience=0.5)
    assert "has not answered" in answer["refused"] and not list(place.iterdir())
    os.close(handle)
    assert "path" in written(plate, folder=str(folder))
    shutil.rmtree(folder)
    assert "cannot be reached" in written(plate, folder=str(folder))["refused"]


def test_reach_hands_on_what_was_raised(tmp_path):
    def fail():
        raise ThinPartError("no", "usage")

    with pytest.raises(ThinPartError) as raised:
        call_in_folder(str(tmp_path), fail)
    assert raised.value.kind == "usage"
    assert call_in_folder("", lambda: 5) == 5
