# SPDX-License-Identifier: LGPL-2.1-or-later
import sys

import pytest

IN_FREECAD = hasattr(sys.modules.get("FreeCADGui"), "getMainWindow")

# A plain pytest has no window: run_in_freecad.py starts FreeCAD and pytest within it.
collect_ignore_glob = [] if IN_FREECAD else ["test_*.py"]

if IN_FREECAD:
    import complaints
    import FreeCAD as App
    import FreeCADGui as Gui
    import time_limit
    import window_actions as window

    from thinpart_workbench.freecad_adapter.preferences import GROUP
    from thinpart_workbench.gui.application import lifelong
    from thinpart_workbench.gui.application.qt import QtCore
    from thinpart_workbench.gui.document.active_task import end_session
    from thinpart_workbench.gui.library.command import end_find_parts
    from thinpart_workbench.gui.widgets.single_dialog import end_single_dialog

    complaints.listen()

    @pytest.fixture(scope="session", autouse=True)
    def time_limit_in_window():
        """A test that hangs is ended in a dialog too: there Python runs only where something calls it."""
        time_limit.in_window(window.shown, window.dismiss)
        timer = QtCore.QTimer()
        timer.timeout.connect(lambda: None)
        timer.start(500)
        yield
        timer.stop()

    @pytest.fixture(autouse=True)
    def clean_window(request):
        """No document, no panel and no worker, before and after, and nothing to complain of."""
        Gui.activateWorkbench("ThinPartWorkbench")
        _clean()
        _judge_by_the_paper(request.node.get_closest_marker("default_profile") is None)
        window.dismiss_notices()
        complaints.take()
        yield
        _clean()
        found = complaints.take()
        allowed = request.node.get_closest_marker("complains")
        assert [each for each in found if not allowed or not any(text in each for text in allowed.args)] == []
        window.wait_until(lambda: window.workers() == [])  # one that has said all is not waited for

    def _judge_by_the_paper(wanted):
        """The paper's criteria have known answers for simple shapes, and do not change as the default's may."""
        preferences = App.ParamGet(GROUP)
        if wanted:
            preferences.SetString("Profile", "paper")
        else:
            preferences.RemString("Profile")

    def _clean():
        end_session()
        end_single_dialog("FolderDialog")
        end_find_parts()
        lifelong.auto_classifier.end()
        lifelong.notifications.clear()
        for name in ("ReportDialog", "LibraryReportDialog", "ProfileDialog", "LearnDialog"):
            end_single_dialog(name)
        Gui.Control.closeDialog()
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        Gui.Selection.clearSelection()
        window.settle()

    @pytest.fixture
    def document():
        """An empty document."""
        return App.newDocument("Test")
