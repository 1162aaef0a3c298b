# SPDX-License-Identifier: LGPL-2.1-or-later
"""A page about the libraries of the panel that finds parts."""

import FreeCADGui as Gui
import pytest
import window_actions as window
from find_panel import choose, classified, library, no_libraries, opened, workers  # noqa: F401 - fixtures among them
from made_library import make_large_library
from test_report import browser  # noqa: F401 - a fixture

from thinpart_workbench.freecad_adapter.preferences import set_preference_list
from thinpart_workbench.gui.application.qt import QtCore
from thinpart_workbench.gui.library.command import end_find_parts
from thinpart_workbench.gui.library.dock import LIBRARIES

BUTTON, START, LIST = "ThinPart_LibraryReportButton", "ThinPart_LibraryReportStart", "ThinPart_LibraryList"


def asked(*roots):
    """The dialog, as the button of the page opens it."""
    dock = opened(*roots)
    choose(dock, LIBRARIES)
    window.click(BUTTON)
    window.wait_until(lambda: window.is_shown("ThinPart_LibraryReportDialog"))
    return window.widget("ThinPart_LibraryReportDialog")


def wait_for_end():
    window.wait_until(lambda: window.widget(START).isEnabled())


def folder_of_report():
    return window.widget("ThinPart_LibraryReportFolder")


def message():
    return window.text("ThinPart_LibraryReportMessage")


def test_a_page_is_written_by_another_process_and_opened(library, browser):
    dialog = asked(library)
    assert not dialog.isModal()
    assert window.text("ThinPart_LibraryReportSubject") == "Report about the classified parts in 'library'"
    page = library.with_name("library-report") / "library.html"
    assert folder_of_report().text() == str(page.parent)
    window.click(START)
    assert window.is_shown("ThinPart_LibraryReportProgress")
    assert window.text("ThinPart_RunningJobs") == "Writing a report about libraries"
    window.wait_until(lambda: window.workers("request_worker"))
    wait_for_end()
    assert message().startswith(f"The report is in {page.parent}. \u26a0 ") and "damaged.thinpart.json" in message()
    label = window.widget("ThinPart_LibraryReportMessage")
    assert label.heightForWidth(label.width()) <= label.height()  # none of its lines is cut off
    assert browser.opened == [str(page)] and 'data-category="thin"' in page.read_text(encoding="utf-8")
    assert not window.is_shown("ThinPart_LibraryReportProgress") and not window.is_shown("ThinPart_RunningJobs")
    window.click("ThinPart_LibraryReportLook")
    assert browser.opened == [str(page)] * 2
    window.wait_until(lambda: not window.workers("request_worker"))


def test_the_page_is_in_the_language_of_the_window_and_names_what_is_not_classified(library, browser):
    (library / "new.step").write_bytes((window.SAMPLES / "plate.step").read_bytes())
    started = Gui.getLocale()
    Gui.setLocale("German")
    try:
        end_find_parts()
        asked(library)
        window.widget("ThinPart_LibraryReportOpen").setChecked(False)
        window.click(START)
        wait_for_end()
        assert "Noch nicht klassifizierte Dokumente, die darin nur aufgelistet sind: 1." in message()
    finally:
        Gui.setLocale(started)
    page = (library.with_name("library-report") / "library.html").read_text(encoding="utf-8")
    assert '<html lang="de">' in page and "new.step" in page and browser.opened == []


def test_it_is_about_all_libraries_or_the_selected_one(library, browser, tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    (other / "plate.step.thinpart.json").write_bytes((library / "plate.step.thinpart.json").read_bytes())
    dialog = asked(library, other)
    assert window.text("ThinPart_LibraryReportSubject") == "Report about the classified parts in 2 libraries"
    dialog.close()
    libraries = window.widget(LIST)
    libraries.setCurrentRow([libraries.item(row).data(QtCore.Qt.UserRole) for row in range(2)].index(str(other)))
    window.click(BUTTON)
    assert window.text("ThinPart_LibraryReportSubject") == "Report about the classified parts in 'other'"
    window.click(START)
    wait_for_end()
    text = (tmp_path / "other-report" / "library.html").read_text(encoding="utf-8")
    assert "plate.step" in text and "tube.step" not in text


def test_a_folder_that_holds_something_else_is_left_alone(library, browser, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("mine")
    asked(library)
    folder_of_report().setText("mine")  # beside the library
    window.click(START)
    wait_for_end()
    assert message() == (f"{tmp_path / 'mine'} already exists and is not the folder of a report: it was not changed; give a "
                         "new or an empty folder.")
    assert [each.name for each in (tmp_path / "mine").iterdir()] == ["thesis.txt"] and browser.opened == []


@pytest.mark.timeout(120)  # a library of 1,500 parts is made and read
def test_it_shows_its_progress_and_can_be_stopped(classified, browser, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    make_large_library(tmp_path / "many", sorted(classified.glob("*.step.thinpart.json")), 1500)
    asked(tmp_path / "many")
    window.click(START)
    window.wait_until(lambda: message().startswith("Comparing: "))
    bar = window.widget("ThinPart_LibraryReportProgress")
    assert bar.maximum() > 1000
    window.click("ThinPart_LibraryReportCancel")
    assert message() == "Stopped on request before the end." and window.widget(START).isEnabled()
    assert not window.is_shown("ThinPart_RunningJobs") and not bar.isVisible()
    window.wait_until(lambda: not window.workers("request_worker"))
    assert browser.opened == [] and not (tmp_path / "many-report" / "library.html").exists()


def test_a_process_that_is_lost_is_one_sentence(library, browser, monkeypatch):
    monkeypatch.setattr("thinpart_workbench.gui.report.library_dialog._WRITE", "no.function")
    asked(library)
    window.click(START)
    wait_for_end()
    assert message().endswith(".") and "Traceback" not in message() and "\n" not in message() and browser.opened == []


def test_without_libraries_there_is_nothing_to_write():
    set_preference_list("Libraries", [])
    dock = opened()
    choose(dock, LIBRARIES)
    assert not window.widget(BUTTON).isEnabled() and window.widget(BUTTON).toolTip()
