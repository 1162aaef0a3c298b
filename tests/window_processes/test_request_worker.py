# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that calls functions of api: in order, to the end of what it was given, unless it can be stopped."""

import json
import os
import subprocess
import sys
import time

import pytest
from made_library import record_of, store

from thinpart_workbench.storage.info.info_file import read_info


@pytest.fixture
def info(tmp_path):
    return store(tmp_path, "Block.step", [record_of("cube")])


def label(info, category, person="Anna"):
    return {"ask": "document_info.keep_label", "preferred": {"person": person, "folder": "/none"},
            "arguments": {"path": str(info), "part": "Solid1", "category": category, "is_sure": True}}


def run(*requests, keep_open=False, **options):
    """The process, to which requests were sent; its input is closed unless it is to stay open."""
    process = subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench.window_processes.request_worker", "test"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", **options)
    process.stdin.write("".join(json.dumps(each) + "\n" for each in requests))
    process.stdin.flush()
    if not keep_open:
        process.stdin.close()
    return process


def answers(process):
    """All that it says until its end, and its status."""
    with process:
        lines = [json.loads(line) for line in process.stdout]
        return lines, process.wait(60)


def test_everything_it_was_given_is_done_in_order_after_its_input_has_ended(info):
    lines, status = answers(run(label(info, "thin"), label(info, "normal", "Bert"), label(info, "normal")))
    assert status == 0 and [len(line["answer"]) for line in lines] == [1, 2, 2]
    record, = read_info(info)["parts"]
    assert {each["person"]: each["category"] for each in record["labels"]} == {"Anna": "normal", "Bert": "normal"}


def test_what_cannot_be_done_is_a_sentence_and_the_next_is_done(info):
    lines, status = answers(run(label(info, "nonsense"), label(info, "thin")))
    assert "nonsense" in lines[0]["refused"] and lines[1]["answer"][0]["category"] == "thin" and status == 0


def test_what_nobody_has_foreseen_ends_it_with_a_failure(info):
    process = run({"ask": "document_info.nothing", "arguments": {}, "preferred": {}}, label(info, "thin"))
    (line,), status = answers(process)
    assert line["failure"]["kind"] == "failed" and status == 1 and "labels" not in read_info(info)["parts"][0]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="a file that never answers")
def test_what_can_be_stopped_is_stopped_with_its_input_even_where_it_hangs(tmp_path):
    os.mkfifo(tmp_path / "labels.csv")
    pytest.importorskip("sklearn")
    process = run({"ask": "learning.learn", "preferred": {}, "arguments": {
        "library": str(tmp_path), "labels": [str(tmp_path / "labels.csv")]}}, keep_open=True)
    time.sleep(3)
    process.stdin.close()
    begun = time.monotonic()
    assert process.wait(60) in (0, 1) and time.monotonic() - begun < 10
    process.stdout.close()
    process.stderr.close()
