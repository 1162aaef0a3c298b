import sys

import pytest

IN_FREECAD = hasattr(sys.modules.get("FreeCADGui"), "getMainWindow")

# A plain pytest has no window: run_in_freecad.py starts FreeCAD and pytest within it.
collect_ignore_glob = [] if IN_FREECAD else ["test_*.py"]

if IN_FREECAD:
    import FreeCAD as App
    import FreeCADGui as Gui

    import complaints
    import time_limit
    import window_actions as window
    from thinpart_workbench.gui.automatic_classification import AUTOMATIC
    from thinpart_workbench.gui.classify import end_session
    from thinpart_workbench.gui.classify_folder import end_folder_dialog
    from thinpart_workbench.gui.find_parts import end_find_parts
    from thinpart_workbench.gui.notices import NOTICES
    from thinpart_workbench.gui.qt import QtCore
    from thinpart_workbench.gui.report import end_report_dialog

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
        window.dismiss_notices()
        complaints.take()
        yield
        _clean()
        found = complaints.take()
        allowed = request.node.get_closest_marker("complains")
        assert [each for each in found if not allowed or not any(text in each for text in allowed.args)] == []
        window.wait_until(lambda: window.workers() == [])  # one that has said all is not waited for

    def _clean():
        end_session()
        end_folder_dialog()
        end_find_parts()
        AUTOMATIC.end()
        NOTICES.clear()
        end_report_dialog()
        Gui.Control.closeDialog()
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        Gui.Selection.clearSelection()
        window.settle()

    @pytest.fixture
    def document():
        """An empty document."""
        return App.newDocument("Test")
