# SPDX-License-Identifier: LGPL-2.1-or-later
"""The queue of requests: order, cancelling, a process that dies or hangs, and what is kept."""

import fcntl
import os
import signal

import pytest
import window_actions as window
from made_library import record_of, store

from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.processes.request_queue import LABEL, RequestQueue
from thinpart_workbench.storage.info.info_file import read_info

WORKER = "request_worker\0test"


@pytest.fixture
def infos(tmp_path):
    """Two info files, in folders of their own."""
    folders = [tmp_path / name for name in ("near", "far")]
    for folder in folders:
        folder.mkdir()
    return [store(folder, "Block.step", [record_of("cube")]) for folder in folders]


@pytest.fixture
def new_queue():
    """Makes queues, with a list of the requests that were answered."""
    def new(**options):
        queue = RequestQueue("test", **options)
        queue.told = []
        queue.answered.connect(queue.told.append)
        return queue

    set_preference("Person", "Anna")
    yield new
    set_preference("Person", None)
    window.wait_until(lambda: not window.workers(WORKER))


def keep(queue, info, category):
    return queue.keep(LABEL, path=str(info), part="Solid1", category=category, is_sure=True)


def label(info):
    return [(each["person"], each["category"]) for each in read_info(info)["parts"][0].get("labels", [])]


def held(folder):
    """A lock on a folder, as if another computer were writing there without end."""
    handle = os.open(folder, os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)
    return handle


def test_requests_are_done_in_order_by_one_process_which_then_ends(new_queue, infos):
    queue = new_queue()
    asked = [keep(queue, infos[0], "thin"), keep(queue, infos[0], "nonsense"), keep(queue, infos[1], "normal")]
    window.wait_until(lambda: window.workers(WORKER))
    assert len(window.workers(WORKER)) == 1 and queue.is_busy
    window.wait_until(lambda: not queue.is_busy)
    assert queue.told == asked and [bool(each.sentence) for each in asked] == [False, True, False]
    assert asked[0].answer[0]["category"] == "thin" and "nonsense" in asked[1].sentence
    assert [label(info) for info in infos] == [[("Anna", "thin")], [("Anna", "normal")]]


def test_a_process_that_is_killed_is_replaced_and_only_its_request_is_lost(new_queue, infos):
    queue, handle = new_queue(), held(infos[1].parent)
    lost, done = keep(queue, infos[1], "thin"), keep(queue, infos[0], "thin")
    window.wait_until(lambda: window.workers(WORKER))
    os.kill(window.workers(WORKER)[0], signal.SIGKILL)
    window.wait_until(lambda: not queue.is_busy)
    os.close(handle)
    assert lost.sentence == "The worker process ended unexpectedly; the report view shows its last output."
    assert not done.sentence and label(infos[0]) == [("Anna", "thin")]


def test_a_process_that_hangs_holds_up_others_only_for_a_time(new_queue, infos):
    queue, handle = new_queue(patience=20.0), held(infos[1].parent)
    lost, done = keep(queue, infos[1], "thin"), keep(queue, infos[0], "thin")
    window.wait_until(lambda: window.workers(WORKER))
    os.kill(window.workers(WORKER)[0], signal.SIGSTOP)  # as on a share that is gone
    window.wait_until(lambda: not queue.is_busy)
    os.close(handle)
    assert "has not answered for 20 s" in lost.sentence and label(infos[1]) == []
    assert not done.sentence and label(infos[0]) == [("Anna", "thin")]


def test_a_cancelled_request_is_not_answered_and_the_next_is(new_queue, infos):
    queue, handle = new_queue(), held(infos[1].parent)
    running, waiting, last = keep(queue, infos[1], "thin"), keep(queue, infos[0], "thin"), keep(queue, infos[0], "normal")
    window.wait_until(lambda: window.workers(WORKER))
    queue.cancel(waiting)
    queue.cancel(running)
    window.wait_until(lambda: not queue.is_busy)
    assert queue.told == [last] and label(infos[0]) == [("Anna", "normal")]
    os.close(handle)
    window.wait_until(lambda: label(infos[1]) == [("Anna", "thin")])  # a label cannot be stopped: it is written in the end
