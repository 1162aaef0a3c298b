# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the process that measures a snapshot tells of what fails."""

import json
import os
import subprocess
import sys

import pytest
from program import ROOT

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.objects.snapshot import write_snapshot
from thinpart_workbench.freecad_adapter.reading.document_parts import document_parts


@pytest.fixture
def snapshot(document, tmp_path):
    """Folder with the snapshot of two plates."""
    import Part

    for name in ("First", "Second"):
        document.addObject("Part::Feature", name).Shape = Part.makeBox(40, 30, 3 if name == "First" else 8)
    list(write_snapshot(document_parts(document), str(tmp_path), AnalysisSettings(), load_profile("paper").content))
    return tmp_path


def told(folder, megabytes=4000):
    """The lines of the worker that are no progress, its exit code and its standard error."""
    run = subprocess.run(
        [sys.executable, "-m", "thinpart_workbench.window_processes.snapshot_worker"],
        capture_output=True, encoding="utf-8", input=json.dumps({"folder": str(folder), "megabytes": megabytes}) + "\n",
        env=dict(os.environ, PYTHONPATH=str(ROOT)))
    lines = [json.loads(each) for each in run.stdout.splitlines()]
    return [each for each in lines if "progress" not in each], run.returncode, run.stderr


def test_a_part_that_fails_unforeseen_is_a_failure_and_the_next_is_measured(snapshot):
    (snapshot / "0.brep").write_text("no shape")
    (failure, record, done), code, errors = told(snapshot)
    failure = failure["failure"]
    assert (failure["part"], failure["label"], failure["kind"]) == ("First", "First", "failed")
    assert failure["message"].startswith("First failed (") and "Traceback" in errors
    assert record["record"]["name"] == "Second" and done == {"done": True} and code == 0


def test_a_snapshot_that_cannot_be_read_is_one_failure(snapshot):
    (snapshot / "job.json").write_text("{")
    (line,), code, errors = told(snapshot)
    assert line["failure"]["kind"] == "failed" and set(line["failure"]) == {"kind", "message"}
    assert "not JSON" in line["failure"]["message"] and "JSONDecodeError" in errors and code == 1


def test_a_profile_that_cannot_be_used_is_its_own_sentence(snapshot):
    job = json.loads((snapshot / "job.json").read_text())
    job["profile"] = {}
    (snapshot / "job.json").write_text(json.dumps(job))
    (line,), code, errors = told(snapshot)
    assert line["failure"]["kind"] == "profile" and code == 1 and "Traceback" not in errors
