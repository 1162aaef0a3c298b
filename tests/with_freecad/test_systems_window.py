# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modules of the window on a simulated Windows and macOS. They are imported without a window."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

PROGRAM = f"""
import sys
sys.path[:0] = [{str(ROOT)!r}, {str(ROOT / 'tests')!r}]
from thinpart_workbench.freecad_adapter.bootstrap import load_freecad
load_freecad()
import FreeCADGui
from pivy import coin
from PySide import QtCore, QtGui
# Two modules ask FreeCAD's window for something while they are imported.
FreeCADGui.getMainWindow = lambda: QtCore.QObject()
FreeCADGui.activateWorkbench = lambda name: None
import simulated_system as simulated
simulated.use(sys.argv[1])
import importlib, pkgutil, thinpart_workbench.gui
names = [each.name for each in pkgutil.walk_packages(thinpart_workbench.gui.__path__, "thinpart_workbench.gui.")]
for name in names:
    importlib.import_module(name)
print(sys.platform, len(names) > 100)
"""


@pytest.mark.parametrize("system", ["win32", "darwin"])
def test_every_module_of_the_window_is_imported(system):
    run = subprocess.run([sys.executable, "-c", PROGRAM, system], capture_output=True, encoding="utf-8", timeout=120)
    assert run.stdout.split()[-2:] == [system, "True"], run.stderr
