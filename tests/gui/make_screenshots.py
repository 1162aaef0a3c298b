# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's start-up script for the pictures of the documentation; see run_in_freecad.py."""

import json
import os
import shutil
import subprocess
import sys
import traceback
from pathlib import Path

HOME = Path(os.environ["HOME"])
PATIENCE = 300.0
"""Seconds, for a machine that is busy with other things."""


def _opened(sample):
    """A sample in a folder of its own, so that no info file is left beside the original."""
    import FreeCAD as App
    import window_actions as window

    file = HOME / "parts" / f"{sample}.FCStd"
    file.parent.mkdir(exist_ok=True)
    shutil.copyfile(window.SAMPLES / file.name, file)
    return App.openDocument(os.fspath(file))


def _classify(sample, picture):
    """A sample as it looks after one press of the button."""
    import FreeCAD as App
    import FreeCADGui as Gui
    import window_actions as window

    Gui.activateWorkbench("ThinPartWorkbench")
    document = _opened(sample)
    view = Gui.getDocument(document.Name).activeView()
    view.viewAxonometric()
    view.fitAll()
    window.classify()
    _dock_tasks()
    window.settle(500)
    view.fitAll()
    Gui.getMainWindow().statusBar().clearMessage()
    window.settle(1000)
    _take(picture)
    App.closeDocument(document.Name)
    window.settle(100)


def _show_thickness(make, picture, act=lambda: None):
    """A document as it looks after one press of 'Show thickness'."""
    import FreeCAD as App
    import FreeCADGui as Gui
    import window_actions as window

    Gui.activateWorkbench("ThinPartWorkbench")
    document = make()
    view = Gui.getDocument(document.Name).activeView()
    view.viewAxonometric()
    view.fitAll()
    window.press("ThinPart_ShowThickness")
    window.settle(100)
    window.wait_until(window.is_thickness_told)
    _dock_tasks()
    window.settle(500)
    view.fitAll()
    view.getCameraNode().scaleHeight(1.7)  # room for the colour bar
    act()
    Gui.getMainWindow().statusBar().clearMessage()
    window.settle(1500)
    _take(picture)
    App.closeDocument(document.Name)
    window.settle(100)


def _prepare_mesh(sample, picture, act):
    """A sample in the panel that prepares meshes."""
    import FreeCAD as App
    import FreeCADGui as Gui
    import window_actions as window

    Gui.activateWorkbench("ThinPartWorkbench")
    document = _opened(sample)
    view = Gui.getDocument(document.Name).activeView()
    view.viewAxonometric()
    view.fitAll()
    window.press("ThinPart_MeshSizes")
    window.wait_until(lambda: window.is_shown("ThinPart_MeshEstimate"), seconds=PATIENCE)
    _dock_tasks()
    act(window)
    view.fitAll()
    Gui.getMainWindow().statusBar().clearMessage()
    window.settle(1500)
    _take(picture)
    App.closeDocument(document.Name)
    window.settle(300)


def _compare_meshes(window):
    window.click("ThinPart_MeshButton")
    window.wait_until(lambda: window.is_shown("ThinPart_QualityChart"), seconds=PATIENCE)


def _make_shell(window):
    window.widget("ThinPart_MeshKind").setCurrentIndex(1)
    window.click("ThinPart_ShellButton")
    window.wait_until(lambda: window.text("ThinPart_ShellFigures"), seconds=PATIENCE)


def _dock_tasks():
    """Put the task view beside the 3D view, as it is in older FreeCADs: 1.1 lays it over the part."""
    import FreeCADGui as Gui
    import window_actions as window

    from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets

    main = Gui.getMainWindow()
    overlay = main.findChild(QtWidgets.QTabWidget, "OverlayRight")
    if overlay is not None and overlay.isVisible():
        # The command is about what is under the mouse.
        QtGui.QCursor.setPos(overlay.mapToGlobal(overlay.rect().center()))
        window.settle(300)
        Gui.runCommand("Std_DockOverlayToggle")
        window.settle(300)
    tasks = main.findChild(QtWidgets.QDockWidget, "Tasks")
    if tasks is not None:
        main.resizeDocks([tasks], [340], QtCore.Qt.Horizontal)
        window.settle(300)


def _hide_tasks():
    """Without a task, the view is an empty one beside the search."""
    import FreeCADGui as Gui

    from thinpart_workbench.gui.application.qt import QtWidgets

    tasks = Gui.getMainWindow().findChild(QtWidgets.QDockWidget, "Tasks")
    if tasks is not None:
        tasks.hide()


def _links():
    """Ribbed blocks, tubes and plates, each a few times."""
    import FreeCAD as App
    import Part
    import window_actions as window

    document = App.newDocument("Frame")
    shapes = [window.ribbed_shape(), Part.makeCylinder(20, 80).cut(Part.makeCylinder(16, 80)),
              Part.makeBox(90, 60, 5)]
    for number, shape in enumerate(shapes):
        feature = window.add(document, ("Block", "Tube", "Plate")[number], shape)
        feature.ViewObject.Visibility = False
        for copy in range(3):
            link = document.addObject("App::Link", f"{feature.Name}_{copy}")
            link.LinkedObject = feature
            link.Placement.Base = window.V(130 * copy, 110 * number, 0)
    document.recompute()
    return document


def _choose_second_part():
    import window_actions as window

    table = window.widget("ThinPart_PartTable")
    window.mouse_click(table.viewport(), table.visualRect(table.model().index(1, 0)).center())


def _library():
    """All samples, classified by the command line with pictures, as a library."""
    import window_actions as window

    from thinpart_workbench.freecad_adapter.preferences import set_preference_list
    from thinpart_workbench.freecad_adapter.python_beside_freecad import python_environment
    from thinpart_workbench.gui.processes.freecad_python import python_program

    folder = HOME / "library"
    folder.mkdir()
    for file in [*window.SAMPLES.glob("*.FCStd"), *window.SAMPLES.glob("*.step")]:
        shutil.copyfile(file, folder / file.name)
    subprocess.run([python_program(), "-m", "thinpart_workbench", "classify", os.fspath(folder)],
                   env=python_environment(), check=True, capture_output=True, stdin=subprocess.DEVNULL)
    set_preference_list("Libraries", [os.fspath(folder)])


def _find(main, folder):
    """The panel at the side with a part's details, and wide with parts that are like it."""
    import FreeCADGui as Gui
    import window_actions as window

    from thinpart_workbench.gui.application.qt import QtCore
    from thinpart_workbench.gui.library.command import show_find_parts

    _library()
    dock = show_find_parts()
    main.resizeDocks([dock], [560], QtCore.Qt.Horizontal)
    _settle(dock)
    table = window.widget("ThinPart_FoundTable")
    names = [table.model().index(row, 1).data() for row in range(table.model().rowCount())]
    table.selectRow(names.index("Ribbed block"))
    _settle(dock)
    table.open_current()
    Gui.Selection.clearSelection()
    Gui.activeDocument().activeView().viewAxonometric()
    Gui.runCommand("Std_ViewFitAll")
    Gui.getMainWindow().statusBar().clearMessage()
    _settle(dock)
    _take(folder / "find.png")
    dock.setFloating(True)
    dock.resize(1340, 700)
    dock.move(30, 100)
    menu = table.menu()
    next(each for each in menu.actions() if each.objectName() == "ThinPart_FoundSimilar").trigger()
    _settle(dock)
    table.selectRow(3)
    _settle(dock)
    _take(folder / "find_similar.png")
    return dock


def _edit_profile(folder):
    """The profile editor with a threshold changed, and the parts that change their category."""
    import window_actions as window

    window.press("ThinPart_EditProfile")
    dialog = window.widget("ThinPart_ProfileDialog")
    window.wait_until(lambda: not dialog.is_waiting, PATIENCE)
    field = window.widget("ThinPart_ProfileForm").findChild(type(window.widget("ThinPart_ConditionValue")),
                                                            "ThinPart_ConditionValue")
    field.setValue(95.0)
    window.settle(50)
    window.wait_until(lambda: not dialog.is_waiting, PATIENCE)
    window.widget("ThinPart_ProfileChangesTable").selectRow(0)
    window.settle(300)
    _grab(dialog, folder / "edit_profile.png")
    dialog.end()


def _settle(dock):
    import window_actions as window

    window.settle(300)
    window.wait_until(lambda: not dock.is_refreshing and not dock.is_waiting, PATIENCE)
    window.settle(500)


def _classify_folder(folder):
    """The dialog for whole folders: before, while and after it runs."""
    import FreeCADGui as Gui
    import window_actions as window

    parts = HOME / "Gearbox"
    for number, sample in enumerate(sorted(window.SAMPLES.glob("*.FCStd"))):
        place = parts / ("housing", "drive", "mounting")[number % 3] / sample.name
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(sample, place)
    (parts / "housing" / "old_lid.step").write_text("ISO-10303-21;\ntransferred in part\n")
    window.press("ThinPart_ClassifyFolder")
    dialog = window.widget("ThinPart_FolderDialog")
    window.widget("ThinPart_Folder").setCurrentText(os.fspath(parts))
    _grab(dialog, folder / "classify_folder_before.png")
    window.click("ThinPart_FolderStart")
    table = window.widget("ThinPart_FolderTable")
    window.wait_until(lambda: table.model().rowCount() > 8, PATIENCE)
    _grab(dialog, folder / "classify_folder_running.png")
    window.wait_until(window.widget("ThinPart_FolderStart").isEnabled, PATIENCE)
    table.sortByColumn(6, table.horizontalHeader().sortIndicatorOrder())
    table.selectRow(0)
    _grab(dialog, folder / "classify_folder.png")
    dialog.reject()
    Gui.getMainWindow().statusBar().clearMessage()


def _grab(dialog, picture):
    """The dialog alone; nothing in it is drawn by anyone but Qt."""
    import window_actions as window

    window.settle(300)
    dialog.grab().save(os.fspath(picture))


def _take(picture):
    """The whole screen: only the X server has the 3D view together with the rest."""
    subprocess.run(["import", "-window", "root", os.fspath(picture)], check=True, timeout=60)


def _arrange(main):
    """As much room for the part and the panel as a user would give them."""
    from thinpart_workbench.gui.application.qt import QtCore, QtWidgets

    main.showMaximized()
    for dock in main.findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Report view", "Python console", "Selection view"):
            dock.hide()
        if dock.objectName() in ("Combo View", "Tasks", "Model"):
            main.resizeDocks([dock], [380], QtCore.Qt.Horizontal)


def _go():
    status = 1
    output = open(HOME / "output.txt", "w", encoding="utf-8")
    try:
        arguments = json.loads(os.environ["THINPART_GUI_ARGUMENTS"])
        sys.path[:0] = [arguments[0], os.path.dirname(arguments[0])]
        import FreeCADGui as Gui

        _arrange(Gui.getMainWindow())
        _classify("ribbed_block", Path(arguments[1], "classify.png"))
        _classify("thin_walled_casting", Path(arguments[1], "classify_casting.png"))
        _show_thickness(lambda: _opened("thin_walled_casting"), Path(arguments[1], "thickness.png"))
        _show_thickness(_links, Path(arguments[1], "thickness_assembly.png"), _choose_second_part)
        _prepare_mesh("bent_sheet_bracket", Path(arguments[1], "prepare_mesh.png"), _compare_meshes)
        _prepare_mesh("bent_sheet_bracket", Path(arguments[1], "prepare_shell.png"), _make_shell)
        _classify_folder(Path(arguments[1]))
        _hide_tasks()
        _find(Gui.getMainWindow(), Path(arguments[1]))
        _edit_profile(Path(arguments[1]))
        status = 0
    except BaseException:  # whatever it was: FreeCAD must end, and tell
        traceback.print_exc(file=output)
    finally:
        output.flush()
        os._exit(status)


from PySide import QtCore  # noqa: E402

QtCore.QTimer.singleShot(500, _go)
