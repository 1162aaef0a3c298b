# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's start-up script: runs pytest once the window is up, then ends FreeCAD.

The tests that have begun and ended are written down in HOME, so that another FreeCAD can go on where this one died.
"""

import faulthandler
import json
import os
import sys

START_SECONDS = 120
"""For pytest to begin; each test has its own limit then."""

TOLD_ONLY = ("-W", "default::ResourceWarning", "-W", "default::pytest.PytestUnraisableExceptionWarning")
"""Errors in pytest.ini, but in this process FreeCAD's own Python and Qt leave things to the collector as well."""


class _Diary:
    """Which tests have begun, which have ended, and what failed."""

    def __init__(self, home, done):
        self.done = done
        self.tests = open(os.path.join(home, "tests.txt"), "w", encoding="utf-8", buffering=1)
        self.failures = open(os.path.join(home, "failures.txt"), "w", encoding="utf-8", buffering=1)

    def pytest_collection_modifyitems(self, config, items):
        left_out = [item for item in items if item.nodeid in self.done]
        if left_out:
            config.hook.pytest_deselected(items=left_out)
            items[:] = [item for item in items if item.nodeid not in self.done]

    def pytest_runtest_logstart(self, nodeid):
        self.tests.write(f"began {nodeid}\n")

    def pytest_runtest_logreport(self, report):
        if report.failed:
            self.failures.write(f"{report.nodeid} ({report.when})\n{report.longreprtext}\n\n")

    def pytest_runtest_logfinish(self, nodeid):
        self.tests.write(f"ended {nodeid}\n")


def _go():
    home = os.environ["HOME"]
    # FreeCAD shows what is printed in a panel of its window; here it has to come out.
    output = open(os.path.join(home, "output.txt"), "w", encoding="utf-8", buffering=1)
    sys.stdout = sys.stderr = output
    faulthandler.enable(output)
    faulthandler.dump_traceback_later(START_SECONDS, exit=True, file=output)
    status = 1
    try:
        import pytest

        given = json.loads(os.environ["THINPART_GUI_ARGUMENTS"])
        status = pytest.main(["--capture=sys", *TOLD_ONLY, *given["pytest"]],
                             plugins=[_Diary(home, set(given["done"]))])
    finally:
        # FreeCAD would ask whether to save the documents.
        output.flush()
        os._exit(int(status))


from PySide import QtCore  # noqa: E402

QtCore.QTimer.singleShot(0, _go)
