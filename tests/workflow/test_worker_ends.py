# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker of the pool died of, and what becomes of the file that it was at."""

import exit_cases
import pytest

from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.system.exit_cause import ExitCause
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.workers.process_pool import ProcessPool
from thinpart_workbench.workflow.workers.task_run import run_tasks


def do(task):
    exit_cases.end_as(task.file)


def start():
    """Nothing to prepare."""


@pytest.fixture
def death(tmp_path):
    """What `WorkerDied` tells of a worker that ends in one of the ways."""
    made = []

    def death(name, confine=False):
        made.append(ProcessPool(1, 60.0, str(tmp_path), do, start, confine=confine))
        made[-1].submit(FileTask(name))
        while (ended := made[-1].next_finished()) is None:
            pass
        return ended[0]

    yield death
    for each in made:
        each.stop()


WANTED = {"nothing special": ExitCause.FAILED, "enough memory in the end": ExitCause.OUT_OF_MEMORY}
"""In the middle of a task nothing ends well; a worker that wrote of memory before that ran out of it."""

KINDS = {ExitCause.OUT_OF_MEMORY: "memory"}


@pytest.mark.parametrize("confine", [False, True], ids=["free", "confined"])
@pytest.mark.parametrize("name", exit_cases.CASES)
def test_a_worker_that_ends_in_every_way(death, name, confine):
    future = death(name, confine)
    wanted = WANTED.get(name, exit_cases.CASES[name][1])
    end = future.exception().end
    assert end.cause(is_done=False) is wanted, (end.code, end.text)


@pytest.mark.parametrize("name", exit_cases.CASES)
def test_what_becomes_of_its_task(name):
    done, = run_tasks([FileTask(name)], do, lambda task, answer: answer, Limits(megabytes=1024))
    assert done.failure["error"]["kind"] == KINDS.get(WANTED.get(name, exit_cases.CASES[name][1]), "crash")
