# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every panel, dialog and page of ThinPart, one after the other, as the tests of all of them see them."""

from contextlib import contextmanager

import FreeCADGui as Gui
import Part
import window_actions as window

from thinpart_workbench.freecad_adapter.preferences import PAGES
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.commands import COMMANDS
from thinpart_workbench.gui.document.active_task import end_session, open_session
from thinpart_workbench.gui.document.part_chooser import PartChooser
from thinpart_workbench.gui.library.command import end_find_parts, show_find_parts
from thinpart_workbench.gui.preferences.form import PreferencesForm
from thinpart_workbench.gui.report.library_dialog import show_library_report
from thinpart_workbench.gui.widgets.single_dialog import end_single_dialog

IN_MAIN_WINDOW = ("classification", "thickness", "mesh sizes", "find parts")


@contextmanager
def _classification(document):
    window.classify()
    yield [window.widget("ThinPart_Panel")]
    end_session()


@contextmanager
def _thickness(document):
    window.show_thickness()
    window.settle(500)
    yield open_session().panel.form
    end_session()


@contextmanager
def _mesh_sizes(document):
    # With several parts it asks which one.
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.getObject("Plate"))
    window.press("ThinPart_MeshSizes")
    window.wait_until(lambda: window.is_shown("ThinPart_MeshEstimate"))
    yield [window.widget("ThinPart_MeshSizesPanel")]
    end_session()
    Gui.Selection.clearSelection()


@contextmanager
def _find_parts(document):
    dock = show_find_parts()
    window.settle(300)
    yield [dock]
    end_find_parts()


def _dialog(command, name):
    @contextmanager
    def shown(document):
        COMMANDS[command].Activated()
        window.settle(300)
        yield [window.widget(f"ThinPart_{name}")]
        end_single_dialog(name)
    return shown


@contextmanager
def _library_report(document):
    show_library_report([str(window.SAMPLES)])
    window.settle(300)
    yield [window.widget("ThinPart_LibraryReportDialog")]
    end_single_dialog("LibraryReportDialog")


def _page(title):
    @contextmanager
    def shown(document):
        form = PreferencesForm(title)
        form.show()
        window.settle(50)
        yield [form]
        form.hide()
        form.deleteLater()
    return shown


@contextmanager
def _chooser(document):
    class Named:
        label, instances = "Bracket", 2

    dialog = PartChooser([Named, Named], Gui.getMainWindow())
    dialog.show()
    yield [dialog]
    dialog.close()
    dialog.deleteLater()


WINDOWS = {
    "classification": _classification,
    "thickness": _thickness,
    "mesh sizes": _mesh_sizes,
    "folder": _dialog("ThinPart_ClassifyFolder", "FolderDialog"),
    "report": _dialog("ThinPart_Report", "ReportDialog"),
    "library report": _library_report,
    "find parts": _find_parts,
    "profile": _dialog("ThinPart_EditProfile", "ProfileDialog"),
    "learning": _dialog("ThinPart_LearnThresholds", "LearnDialog"),
    "part chooser": _chooser,
    **{f"preferences {title}": _page(title) for title in PAGES},
}
"""By name: a context in which a window is shown; it gives its widgets."""


def document_to_show(document):
    """Put a part into a document, for the panels to be about."""
    window.add_ribbed_block(document)
    plate = Part.makeBox(50, 40, 3)
    window.add(document, "Plate", plate).Placement.Base = window.V(0, 100, 0)
    document.recompute()


def wheel_over(widget):
    """Turn the mouse wheel over a widget by three notches."""
    from thinpart_workbench.gui.application.qt import QtGui

    place = QtCore.QPointF(widget.rect().center())
    event = QtGui.QWheelEvent(
        place, QtCore.QPointF(widget.mapToGlobal(widget.rect().center())), QtCore.QPoint(), QtCore.QPoint(0, -360),
        QtCore.Qt.NoButton, QtCore.Qt.NoModifier, QtCore.Qt.NoScrollPhase, False)
    QtWidgets.QApplication.sendEvent(widget, event)
