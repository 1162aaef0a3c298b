# SPDX-License-Identifier: LGPL-2.1-or-later
import os
import signal

import pytest
from folder_runs import Run

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad


@pytest.fixture(scope="session", autouse=True)
def freecad():
    """The real FreeCAD, without a window."""
    return load_freecad()


@pytest.fixture
def document(freecad):
    """An empty document, closed afterwards."""
    document = freecad.newDocument("Test")
    yield document
    freecad.closeDocument(document.Name)


@pytest.fixture
def start():
    """Starts runs of the program; those that still go on are killed afterwards."""
    runs = []

    def new(*arguments, **options):
        runs.append(Run(*arguments, **options))
        return runs[-1]

    yield new
    for run in runs:
        if run.process.poll() is None:
            os.killpg(run.process.pid, signal.SIGKILL)
            run.process.wait()
        run.close()
