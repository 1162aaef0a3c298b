import os
import signal

import pytest
from folder_runs import Run
from program import BARE_PYTHON

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad


@pytest.fixture(scope="session", autouse=True)
def freecad():
    """The real FreeCAD, without a window."""
    return load_freecad()


@pytest.fixture(params=["all libraries", "numpy and scipy alone"])
def each_python(request, monkeypatch):
    """The program runs in a Python with all libraries, and in one as FreeCAD's bundles have it.

    Only tables, bars and reports ask for more than a bundle has (see tests/test_layers.py); what has none of them is
    the same in both.
    """
    if request.param == "numpy and scipy alone":
        monkeypatch.setenv("THINPART_TEST_PATH", str(BARE_PYTHON))
    return request.param


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
