# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's start-up script: closes FreeCAD as a user does, while it measures a part, a folder or a
document that was just saved, or reads a library."""

import json
import os
import shutil
import subprocess
import sys
import traceback
from pathlib import Path

HOME = Path(os.environ["HOME"])


def _go():
    with open(HOME / "output.txt", "w", encoding="utf-8") as output:
        try:
            folder, what = json.loads(os.environ["THINPART_GUI_ARGUMENTS"])
            sys.path[:0] = [folder, os.path.dirname(folder)]
            {"part": _measure_a_part, "folder": _classify_a_folder, "library": _read_a_library,
             "document": _save_a_document}[what]()
        except BaseException:  # whatever it was: FreeCAD must end, and tell
            traceback.print_exc(file=output)
            output.flush()
            os._exit(1)


def _measure_a_part():
    import FreeCAD as App
    import FreeCADGui as Gui
    import window_actions as window

    from thinpart_workbench.gui.application.qt import QtWidgets

    Gui.activateWorkbench("ThinPartWorkbench")
    window.add(App.newDocument("Test"), "Sieve", window.slow_shape())
    window.press("ThinPart_Classify")
    window.wait_until(window.workers)

    def discard(question):
        button = question.findChild(QtWidgets.QDialogButtonBox).button(
            QtWidgets.QDialogButtonBox.Discard)
        button.click()

    window.answer("", discard)
    Gui.getMainWindow().close()


def _save_a_document():
    """It is being classified in the background."""
    import FreeCAD as App
    import FreeCADGui as Gui
    import window_actions as window

    from thinpart_workbench.freecad_adapter.preferences import set_preference

    set_preference("AutomaticClassification", True)
    document = App.newDocument("Test")
    window.add(document, "Sieve", window.slow_shape())
    document.saveAs(os.fspath(HOME / "sieve.FCStd"))
    window.wait_until(window.workers)
    window.settle(2000)  # its own worker process is there
    Gui.runCommand("Std_Save")  # the run starts anew, and FreeCAD has nothing to ask
    Gui.getMainWindow().close()


def _classify_a_folder():
    """Some documents are done by then, and some are not."""
    import FreeCADGui as Gui
    import window_actions as window

    Gui.activateWorkbench("ThinPartWorkbench")
    parts = HOME / "parts"
    parts.mkdir()
    for number in range(8):
        shutil.copyfile(window.SAMPLES / "flange.FCStd", parts / f"flange{number}.FCStd")
    window.press("ThinPart_ClassifyFolder")
    window.widget("ThinPart_Folder").setCurrentText(os.fspath(parts))
    window.widget("ThinPart_FolderJobs").setValue(1)
    window.click("ThinPart_FolderStart")
    window.wait_until(lambda: window.widget("ThinPart_FolderTable").model().rowCount() > 0)
    Gui.getMainWindow().close()


def _read_a_library():
    """Notes are written and not saved, more parts are being read, and labels wait behind something that is read."""
    import FreeCADGui as Gui
    import window_actions as window
    from made_library import make_large_library

    from thinpart_workbench.freecad_adapter.preferences import set_preference_list
    from thinpart_workbench.freecad_adapter.python_beside_freecad import python_environment
    from thinpart_workbench.gui.application import lifelong
    from thinpart_workbench.gui.application.qt import QtWidgets
    from thinpart_workbench.gui.library.libraries_page import LibrariesPage
    from thinpart_workbench.gui.processes.freecad_python import python_program
    from thinpart_workbench.gui.processes.request_queue import LABEL

    Gui.activateWorkbench("ThinPartWorkbench")
    parts, many = HOME / "parts", HOME / "many"
    parts.mkdir()
    shutil.copyfile(window.SAMPLES / "block.step", parts / "block.step")
    subprocess.run([python_program(), "-m", "thinpart_workbench", "classify", os.fspath(parts), "--profile", "paper"],
                   env=python_environment(), check=True, stdin=subprocess.DEVNULL, capture_output=True)
    make_large_library(many, [parts / "block.step.thinpart.json"], 8000)
    set_preference_list("Libraries", [os.fspath(parts)])
    window.press("ThinPart_FindParts")
    table = window.widget("ThinPart_FoundTable")
    window.wait_until(lambda: table.model().rowCount() == 1)
    table.selectRow(0)
    window.wait_until(window.widget("ThinPart_KeptNotes").isEnabled)
    window.widget("ThinPart_KeptNotes").setPlainText("written last")
    window.widget("ThinPart_FindParts", QtWidgets.QDockWidget).findChild(LibrariesPage).add(os.fspath(many))
    window.wait_until(lambda: "info files read" in window.widget("ThinPart_LibraryProgress").text())
    lifelong.region_notes.read(os.fspath(parts / "block.step"))
    for person in ("Anna", "Bert"):
        lifelong.requests.keep(LABEL, path=os.fspath(parts / "block.step.thinpart.json"), part=None, category="thin",
                               is_sure=True, person=person)
    Gui.getMainWindow().close()


from PySide import QtCore  # noqa: E402

QtCore.QTimer.singleShot(300, _go)
