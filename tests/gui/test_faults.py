# SPDX-License-Identifier: LGPL-2.1-or-later
"""What nobody foresaw ends as one sentence, in FreeCAD's notification area where it has one, and as no traceback."""

import subprocess

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window

from thinpart_workbench.freecad_adapter.objects import thickness_object
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.application import faults, lifelong
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.classify import controller
from thinpart_workbench.gui.commands import clear_colours
from thinpart_workbench.gui.document import active_task
from thinpart_workbench.gui.view3d import scene_sync, view_provider

pytestmark = pytest.mark.complains("unexpected error", "Broken", "has no attribute 'of'", "The disk is full")

# A fault that nobody foresaw cannot be provoked: what is called at each kind of edge is made to raise.


class Broken(Exception):
    """Raised in place of what was not foreseen."""


def fail(*_arguments, **_named):
    raise Broken("on purpose")


@pytest.fixture(autouse=True)
def report():
    """The Report view's text from here on."""
    view = Gui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view")
    faults.forget_reported_faults()
    view.clear()

    def text():
        window.settle(100)
        return view.toPlainText()

    return text


def told_once(text):
    assert "Traceback" not in text and "File \"" not in text, text
    lines = [each for each in text.splitlines() if each.strip()]
    assert len(lines) == 1 and "(the log has its details)" in lines[0] and "ThinPart: " in lines[0], text
    return True


def test_a_command(document, monkeypatch, report):
    monkeypatch.setattr(controller, "ClassificationController", fail)
    Gui.runCommand("ThinPart_Classify")
    assert told_once(report())


def test_whether_a_command_is_active(document, monkeypatch, report):
    monkeypatch.setattr(lifelong.face_colours, "is_shown", fail)
    assert not Gui.isCommandActive("ThinPart_ClearColours")
    assert told_once(report())


def test_an_observer_of_documents(document, report):
    told = []

    def listen():
        told.append("the next one")

    for call in (fail, listen):
        lifelong.observer.changed.add(call)
    try:
        document.addObject("Part::Box", "Box")
    finally:
        for call in (fail, listen):
            lifelong.observer.changed.remove(call)
    assert told_once(report()), "however often FreeCAD calls it"
    assert told, "one that fails keeps nobody else from being told"


def test_a_proxy_of_an_object(document, monkeypatch, report):
    window.add(document, "Box", Part.makeBox(9, 8, 2))
    window.show_thickness()
    thickness, = thickness_objects(document)
    report()
    Gui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view").clear()
    monkeypatch.setattr(thickness_object, "signature", fail)
    thickness.touch()
    document.recompute()
    text = report()
    assert "Traceback" not in text and "(the log has its details)" in text


def test_a_view_provider(document, monkeypatch, report):
    window.add(document, "Box", Part.makeBox(9, 8, 2))
    window.show_thickness()
    thickness, = thickness_objects(document)
    monkeypatch.setattr(view_provider, "ThicknessColours", None)
    thickness.Bands = 4
    text = report()
    monkeypatch.undo()
    assert "Traceback" not in text and text.count("unexpected error") >= 1


def test_a_task_panel(document, monkeypatch, report):
    window.classify()
    session = active_task.open_session()
    monkeypatch.setattr(type(session.panel), "hide", fail)
    window.mouse_click(window.close_button())
    assert told_once(report())


def test_a_slot_and_a_timer(document, monkeypatch, report):
    monkeypatch.setattr(lifelong.face_colours, "clear", fail)
    button = QtWidgets.QPushButton()
    button.clicked.connect(clear_colours)  # at no edge: Qt calls it
    button.click()
    assert told_once(report())
    faults.forget_reported_faults()
    Gui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view").clear()
    monkeypatch.setattr(scene_sync.SceneSync, "refresh", fail)
    lifelong.map_events.refresh_soon()
    assert told_once(report())


def test_an_event_filter(document, monkeypatch, report):
    from thinpart_workbench.gui.view3d import picking as thickness_picking

    window.add(document, "Box", Part.makeBox(9, 8, 2))
    window.show_thickness()
    view = Gui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")[0]
    window.click("ThinPart_ProbeButton")
    report()
    monkeypatch.setattr(thickness_picking, "mouse_position", fail)
    window.mouse_click(view.graphicsView().viewport())
    assert told_once(report())


def test_what_is_not_ours_is_left_alone(report, capsys):
    def theirs():
        raise Broken("of another workbench")

    QtCore.QTimer.singleShot(0, theirs)
    assert report() == "" and "Traceback" in capsys.readouterr().err


def test_a_failure_with_a_sentence_of_its_own_is_told_by_that(document, monkeypatch, report):
    from thinpart_workbench.core.errors import ThinPartError

    def foreseen():
        raise ThinPartError("The disk is full: make room.", "info_write")

    monkeypatch.setattr(controller, "ClassificationController", foreseen)
    Gui.runCommand("ThinPart_Classify")
    assert report().rstrip().endswith("ThinPart: The disk is full: make room.")


# ---- FreeCAD's notification area ----

has_area = hasattr(App.Console, "PrintNotification")


@pytest.mark.skipif(not has_area, reason="this FreeCAD has no notification area")
def test_the_area_has_one_sentence_and_no_traceback(document, monkeypatch):
    before = window.notification_area()
    monkeypatch.setattr(controller, "ClassificationController", fail)
    Gui.runCommand("ThinPart_Classify")
    window.settle(100)
    found = window.notification_area()
    for notification in before:
        found.remove(notification)
    assert len(found) == 1 and "(the log has its details)" in found[0][1]
    assert not any("Traceback" in text or "File \"" in text for _, text in found)


@pytest.mark.skipif(not has_area, reason="this FreeCAD has no notification area")
@pytest.mark.parametrize("kind", ["warn", "report_warning", "report_error", "show_failure"])
def test_a_notice_reaches_the_area_with_its_document_and_nothing_doubles_it(kind):
    getattr(lifelong.notifications, kind)(f"Walls are thinner now ({kind}).", "My part")
    window.settle(100)
    assert [each for each in window.notification_area() if f"now ({kind})" in each[1]] == [
        ("My part", f"ThinPart: Walls are thinner now ({kind}).")]
    assert not window.is_shown("ThinPart_Notice")


@pytest.mark.skipif(has_area, reason="this FreeCAD has a notification area")
def test_a_warning_stays_in_the_status_bar_where_there_is_no_area():
    lifelong.notifications.warn("Walls are thinner now.")
    window.settle(20)
    assert "Walls are thinner now." in window.text("ThinPart_Notice")
    window.click("ThinPart_Notice")
    assert not window.is_shown("ThinPart_Notice")


def test_what_a_process_said_before_it_died_is_one_line(report):
    lifelong.notifications.report_output(
        "Traceback (most recent call last):\n  File \"x.py\", line 1\nMemoryError: Broken\n")
    lines = [each for each in report().splitlines() if each.strip()]
    assert len(lines) == 1 and lines[0].endswith("ThinPart: MemoryError: Broken")


def test_what_a_process_said_before_it_crashed_is_no_line_of_its_stack(report):
    crashed = subprocess.run(["python3", "-X", "faulthandler", "-c", "import os; os.abort()"],
                             capture_output=True, text=True, check=False)
    assert crashed.stderr.count("\n") > 1
    lifelong.notifications.report_output(crashed.stderr)
    lines = [each for each in report().splitlines() if each.strip()]
    assert len(lines) == 1 and lines[0].endswith("ThinPart: Fatal Python error: Aborted")
