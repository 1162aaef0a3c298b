"""What a worker of the pool died of, and what becomes of the file that it was at."""

import exit_cases
import pytest

from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.system.exit_cause import ExitCause
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.workers import worker_pool
from thinpart_workbench.workflow.workers.pool_supervisor import PoolSupervisor


def do(task):
    exit_cases.end_as(task.file)


def start():
    """Nothing to prepare."""


@pytest.fixture
def death(tmp_path):
    """What `WorkerDied` tells of a worker that ends in one of the ways."""
    made = []

    def death(name, confine=False):
        made.append(PoolSupervisor(1, 60.0, str(tmp_path), do, start, confine=confine))
        made[-1].submit(FileTask(name))
        while (ended := made[-1].next_finished()) is None:
            assert not made[-1].lost_tasks()
        return ended[0]

    yield death
    for each in made:
        each.stop()


KINDS = {ExitCause.OUT_OF_MEMORY: "memory"}


@pytest.mark.parametrize("confine", [False, True], ids=["free", "confined"])
@pytest.mark.parametrize("name", exit_cases.CASES)
def test_a_worker_that_ends_in_every_way(death, name, confine):
    future = death(name, confine)
    cause = exit_cases.CASES[name][1]
    # In the middle of a task nothing ends well; a worker that wrote of memory before that ran out of it.
    wanted = {"nothing special": ExitCause.FAILED, "enough memory in the end": ExitCause.OUT_OF_MEMORY}.get(name, cause)
    end = future.exception().end
    assert end.cause(is_done=False) is wanted, (end.code, end.text)
    outcome = worker_pool._outcome(future, FileTask("plate.step"), Limits(megabytes=1024))
    assert outcome["error"]["kind"] == KINDS.get(wanted, "crash")
