# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dask workers that answer with programs: none of them runs where the command was given."""

import os
import time
from pathlib import Path

import pytest
from program import SAMPLES
from test_cluster import Cluster

from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.cluster.cluster_run import analyse_files_on_cluster

WORKER = Path(__file__).with_name("hostile_dask_worker.py")
TASK = FileTask(str(SAMPLES / "wedge.step"))


@pytest.fixture
def hostile(tmp_path):
    """Starts a worker that answers in some way; its scheduler, and where the programs leave their files."""
    clusters = []

    def start(way):
        folder = tmp_path / "ran"
        folder.mkdir()
        cluster = Cluster(tmp_path, HOSTILE_FOLDER=str(folder), HOSTILE_WAY=way)
        clusters.append(cluster)
        cluster.worker("--no-nanny", "--preload", WORKER)
        return cluster.address, folder

    yield start
    for each in clusters:
        each.stop()


def ran_here(folder):
    return str(os.getpid()) in os.listdir(folder)


def test_without_protection_the_program_runs(hostile):
    """This is what the others would let happen."""
    from distributed import Client

    address, folder = hostile("a_program_as_result")

    def program():
        from hostile_dask_worker import Program

        return Program()

    with Client(address, set_as_default=False) as client:
        client.submit(program, pure=False).result(timeout=30)
    assert ran_here(folder)


@pytest.mark.parametrize("way", ["a_program_as_result", "a_program_as_error", "no_result", "no_text"])
def test_an_answer_that_is_no_result_is_a_failure_and_runs_nothing(hostile, way):
    address, folder = hostile(way)
    try:
        outcome, = analyse_files_on_cluster(address, [TASK], Limits(), patience=10)
    except ThinPartError as error:
        assert way == "a_program_as_result" and error.kind == "cluster" and "was not run" in str(error)
    else:
        assert outcome["file"] == TASK.file and outcome["error"]["kind"] == "failed"
        assert "on the cluster" in outcome["error"]["message"]
    time.sleep(0.5)
    assert not ran_here(folder)


def test_software_that_is_a_program_ends_the_run(hostile):
    address, folder = hostile("a_program_as_software")
    with pytest.raises(ThinPartError) as raised:
        list(analyse_files_on_cluster(address, [TASK], Limits(), patience=10))
    assert raised.value.kind == "cluster" and not ran_here(folder)
