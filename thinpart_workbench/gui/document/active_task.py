# SPDX-License-Identifier: LGPL-2.1-or-later
"""The open session of ThinPart, at most one: FreeCAD shows one task panel at a time."""

import FreeCAD as App
import FreeCADGui as Gui

from ..application import lifelong
from ..application.qt import QtCore, QtWidgets, execute, translate
from .measure_tool import MeasureTool
from .task_controller import MeasuringController

CLASSIFICATION, THICKNESS, MESH_SIZES = "classification", "thickness", "mesh_sizes"
"""Kinds of sessions."""

_sessions = []  # at most one (kind, session)
_measure_tool = []  # the MeasureTool, created with the first session


def open_session(kind=None):
    """The session whose panel is open, or None; where a kind is given, only a session of that kind."""
    for session_kind, session in _sessions:
        if session.panel.is_open and kind in (None, session_kind):
            return session
    return None


def is_task_view_free(document=None):
    """Whether a panel can be opened; shows why where a task of FreeCAD, such as measuring, prevents it.

    Asks the user before a measurement of another document is stopped.

    Parameters
    ----------
    document : FreeCAD.Document, optional
        The one that the panel will be about.

    Notes
    -----
    The commands stay enabled in that case, because a greyed-out button does not say what it waits for.
    """
    session = open_session()
    if session is not None:
        is_elsewhere = document is None or session.document_name != document.Name
        return not (session.is_running and is_elsewhere) or _may_be_stopped(session)
    if not Gui.Control.activeDialog():
        return True
    _show_other_task_message()
    return False


def _may_be_stopped(session):
    """Ask whether the measurement of another document may be stopped; True also where it ends meanwhile."""
    label = App.getDocument(session.document_name).Label
    box = QtWidgets.QMessageBox(Gui.getMainWindow())
    box.setObjectName("ThinPart_RunningQuestion")
    box.setIcon(QtWidgets.QMessageBox.Question)
    box.setTextFormat(QtCore.Qt.PlainText)
    box.setText(translate("ThinPart", "'{}' is still being measured.").format(label))
    box.setInformativeText(translate("ThinPart", "Stop it, and go on here?"))
    stop = box.addButton(translate("ThinPart", "&Stop it"), QtWidgets.QMessageBox.DestructiveRole)
    stop.setObjectName("ThinPart_RunningStop")
    stay = box.addButton(translate("ThinPart", "&Keep measuring"), QtWidgets.QMessageBox.RejectRole)
    stay.setObjectName("ThinPart_RunningStay")
    box.setDefaultButton(stay)
    box.setEscapeButton(stay)
    # What was asked about may be over before there is an answer.
    session.measured.ended.connect(stop.click)
    execute(box)
    may_be_stopped = box.clickedButton() is stop
    session.measured.ended.disconnect(stop.click)
    box.deleteLater()
    return may_be_stopped


def _show_other_task_message():
    lifelong.notifications.show_failure(translate(
        "ThinPart", "FreeCAD shows one task at a time: close the one that is open, then try again."))


def _blocks_measure_tool():
    """Whether a panel of ThinPart keeps FreeCAD from opening its measure tool; shows a message if so."""
    if open_session() is None:
        return False
    _show_other_task_message()
    return True


def begin_session(kind, controller, document, *subject):
    """Start a session after closing the open one; see `is_task_view_free` for when that is refused.

    Parameters
    ----------
    controller : type
        A kind of `TaskController`; called with the document and the subject, it makes the session.
    *subject : object
        What in the document it is about.
    """
    if not is_task_view_free(document):
        return
    session = controller(document, *subject)
    end_session()
    if not _measure_tool:
        _measure_tool.append(MeasureTool(_blocks_measure_tool))
    _measure_tool[0].watch()
    _sessions.append((kind, session))
    if isinstance(session, MeasuringController):
        session.measured.ended.connect(follow_active_document)  # another may have come to the front meanwhile
    session.start()


def end_session():
    """Close the open session: its panel and its measurement."""
    while _sessions:
        _sessions.pop()[1].close()


def follow_active_document():
    """Let the open panel be about the document in front, once FreeCAD has brought it there, or say what it is about.

    A panel that measures stays as it is until it has ended.
    """
    QtCore.QTimer.singleShot(0, _follow)


def _follow():
    session, document = open_session(), App.ActiveDocument
    if session is None or document is None or session.is_running or session.document_name is None:
        return
    if session.document_name == document.Name:
        session.panel.take_out()
    elif session.document_name in App.listDocuments() and not session.follow(document):
        session.panel.put_away(App.getDocument(session.document_name))


def close_session_of(name):
    """Close the session of a document that is about to be closed."""
    session = open_session()
    if session is not None and session.document_name == name:
        # Later, because FreeCAD still iterates over the panels while it closes the document.
        session.panel.closed.emit()
        QtCore.QTimer.singleShot(0, end_session)
