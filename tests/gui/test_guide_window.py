# SPDX-License-Identifier: LGPL-2.1-or-later
"""What's This, F1 and Help lead to the page of the guide that belongs to what was asked about, and the guide can be read."""

import os
import re
from pathlib import Path

import FreeCADGui as Gui
import pytest
import window_actions as window
from every_window import WINDOWS, document_to_show
from thickness_window import view_of, widget_of

from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.commands import COMMANDS
from thinpart_workbench.gui.document.active_task import open_session
from thinpart_workbench.gui.guide.command import show_guide
from thinpart_workbench.gui.guide.pages import CONTENTS, FOLDER, PAGE_OF, heading_anchor, headings, page_in
from thinpart_workbench.gui.profile.command import show_profile_editor
from thinpart_workbench.gui.widgets.single_dialog import end_single_dialog

HELP_OF = {
    "classification": "ThinPart_Classify", "thickness": "ThinPart_ShowThickness", "folder": "ThinPart_ClassifyFolder",
    "report": "ThinPart_Report", "find parts": "ThinPart_FindParts", "profile": "ThinPart_EditProfile",
    "learning": "ThinPart_LearnThresholds",
}
"""The windows that have a Help button, or one below them in the task view, and the command of each."""

LANGUAGES = {"German": "de", "French": "fr"}
"""FreeCAD's names of the languages that the guide is in, other than English."""


class Browser(QtCore.QObject):
    """Takes what would be opened in the user's browser."""

    def __init__(self):
        super().__init__()
        self.opened = []

    @QtCore.Slot(QtCore.QUrl)
    def take(self, url):
        self.opened.append(url.toString())


@pytest.fixture(autouse=True)
def browser():
    """Nothing opens a browser, or FreeCAD's wiki, unless a test says so."""
    browser = Browser()
    for scheme in ("file", "http", "https"):
        QtGui.QDesktopServices.setUrlHandler(scheme, browser, "take")
    yield browser
    for scheme in ("file", "http", "https"):
        QtGui.QDesktopServices.unsetUrlHandler(scheme)
    end_single_dialog("GuideWindow")


@pytest.fixture
def part(document):
    document_to_show(document)
    return document


def page_of(name):
    """Path of the page that belongs to a command."""
    return FOLDER / PAGE_OF[name].partition("#")[0]


def is_at(name):
    return window.is_shown("ThinPart_GuideWindow") and Path(window.widget("ThinPart_GuideWindow").page) == page_of(name)


def text():
    return window.widget("ThinPart_GuidePage").toPlainText()


def test_every_command_has_a_page_and_every_page_is_there():
    assert set(COMMANDS) <= set(PAGE_OF)
    for name, page in PAGE_OF.items():
        file, _, anchor = page.partition("#")
        headings = re.findall(r"^#+ (.*)$", (FOLDER / file).read_text(encoding="utf-8"), re.MULTILINE)
        assert not anchor or anchor in map(heading_anchor, headings), name


@pytest.mark.parametrize("name", COMMANDS)
def test_whats_this_of_a_button_opens_its_page(name, browser, document):
    button = window.tool_button(name)
    QtWidgets.QWhatsThis.enterWhatsThisMode()
    window.mouse_click(button)
    window.wait_until(lambda: is_at(name))
    assert browser.opened == []


@pytest.mark.parametrize("name", HELP_OF)
def test_whats_this_and_f1_in_a_window_open_its_page(name, browser, part):
    with WINDOWS[name](part) as widgets:
        target = next(each for widget in widgets for each in widget.findChildren(QtWidgets.QAbstractButton)
                      if each.isVisible() and each.isEnabled())
        QtWidgets.QWhatsThis.enterWhatsThisMode()
        window.mouse_click(target)
        window.wait_until(lambda: is_at(HELP_OF[name]))
        end_single_dialog("GuideWindow")
        window.wait_until(lambda: not window.is_shown("ThinPart_GuideWindow"))
        window.key(target, QtCore.Qt.Key_F1)
        window.wait_until(lambda: is_at(HELP_OF[name]))
    assert browser.opened == []


@pytest.mark.parametrize("name", ["ThinPart_ShowThickness", "ThinPart_Classify"])
def test_f1_opens_the_page_of_a_panel_also_while_the_keyboard_acts_on_the_view(name, document):
    COMMANDS[name].Activated()  # says that the document is empty, which is enough
    window.wait_until(lambda: window.is_shown("ThinPart_Message"))
    event = QtGui.QKeyEvent(QtCore.QEvent.ShortcutOverride, QtCore.Qt.Key_F1, QtCore.Qt.NoModifier)
    event.ignore()
    QtWidgets.QApplication.sendEvent(widget_of(view_of(document)), event)
    assert event.isAccepted()
    window.wait_until(lambda: is_at(name))


@pytest.mark.parametrize("name", HELP_OF)
def test_the_help_button_of_a_window_opens_its_page(name, part):
    with WINDOWS[name](part) as widgets:
        if name in ("classification", "thickness"):
            assert open_session().panel.getStandardButtons() & int(
                getattr(QtWidgets.QDialogButtonBox.Help, "value", QtWidgets.QDialogButtonBox.Help))
            box = next(each for each in Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
                       if each.isVisible() and each.button(QtWidgets.QDialogButtonBox.Help))
            button = box.button(QtWidgets.QDialogButtonBox.Help)
        else:
            button = widgets[0].findChild(QtWidgets.QPushButton, "ThinPart_Help")
        window.mouse_click(button)
        window.wait_until(lambda: is_at(HELP_OF[name]))


def test_the_limits_of_the_profile_editor_have_a_page_of_their_own():
    dialog = show_profile_editor()
    limits = dialog.findChild(QtWidgets.QTabWidget)
    limits.setCurrentIndex(1)
    window.settle(50)
    tree = limits.currentWidget().findChild(QtWidgets.QTreeWidget)
    window.key(tree, QtCore.Qt.Key_F1)
    window.wait_until(lambda: is_at("ThinPart_Limits"))


def test_f1_outside_of_thinpart_is_freecads_own(part):
    event = QtGui.QKeyEvent(QtCore.QEvent.ShortcutOverride, QtCore.Qt.Key_F1, QtCore.Qt.NoModifier)
    event.ignore()
    QtWidgets.QApplication.sendEvent(Gui.getMainWindow().centralWidget(), event)
    assert not event.isAccepted()


def test_links_lead_to_pages_and_back_and_addresses_to_the_browser(browser):
    guide = show_guide()
    page = window.widget("ThinPart_GuidePage")
    page.anchorClicked.emit(QtCore.QUrl("judge-one-part.md"))
    assert is_at("ThinPart_Classify") and "Worked example" in text()
    page.anchorClicked.emit(QtCore.QUrl("../method.md"))
    assert Path(guide.page).resolve() == FOLDER.parent / "method.md"
    window.click("ThinPart_GuideBack")
    assert is_at("ThinPart_Classify")
    window.click("ThinPart_GuideForward")
    assert guide.page.endswith("method.md")
    window.click("ThinPart_GuideContents")
    assert is_at("ThinPart_Guide") and browser.opened == []
    page.anchorClicked.emit(QtCore.QUrl("https://gmsh.info"))
    assert browser.opened == ["https://gmsh.info"]


def test_a_page_that_belongs_to_a_heading_begins_there():
    guide = show_guide()
    guide.resize(500, 300)
    window.settle(300)
    show_guide("ThinPart_Report")
    assert "A page to hand on" in text()
    bar = window.widget("ThinPart_GuidePage").verticalScrollBar()
    assert bar.value() > 0


def test_pictures_fit_the_window_also_after_it_was_resized():
    guide = show_guide("ThinPart_Classify")
    page = window.widget("ThinPart_GuidePage")
    for width in (900, 600):
        guide.resize(width, 600)
        window.wait_until(lambda least=0.8 * width, most=width: least < picture_width(page) < most)
        assert page.horizontalScrollBar().maximum() == 0


def picture_width(page):
    url = QtCore.QUrl.fromLocalFile(str(FOLDER.parent / "screenshots" / "classify_casting.png"))
    image = page.document().resource(QtGui.QTextDocument.ImageResource, url)
    return image.width() / image.devicePixelRatio() if image is not None else 0


def test_tables_and_commands_of_all_pages_are_shown():
    guide = show_guide()
    for file in sorted(FOLDER.glob("*.md")):
        guide.show_page(file.name)
        heading = file.read_text(encoding="utf-8").partition("\n")[0].lstrip("# ")
        assert text().startswith(heading), file
        assert "|---" not in text() and "](" not in text() and "| ---" not in text(), file
        assert os.path.samefile(guide.page, file)


# -- in other languages

@pytest.fixture(params=LANGUAGES.items(), ids=LANGUAGES)
def language(request):
    """Code of the language that FreeCAD speaks meanwhile."""
    started, (name, code) = Gui.getLocale(), request.param
    Gui.setLocale(name)
    yield code
    Gui.setLocale(started)


def test_f1_opens_the_page_in_the_language_of_the_window_and_contents_too(language, part):
    with WINDOWS["report"](part) as widgets:
        window.key(widgets[0].findChild(QtWidgets.QPushButton, "ThinPart_Help"), QtCore.Qt.Key_F1)
        window.wait_until(lambda: window.is_shown("ThinPart_GuideWindow"))
    guide = window.widget("ThinPart_GuideWindow")
    file, anchor = page_in(language, PAGE_OF["ThinPart_Report"])
    assert Path(guide.page) == file == FOLDER / language / "judge-one-part.md" and anchor != "a-page-to-hand-on"
    bar = window.widget("ThinPart_GuidePage").verticalScrollBar()
    assert 0 < bar.value()
    window.click("ThinPart_GuideContents")
    assert Path(guide.page) == FOLDER / language / CONTENTS
    window.widget("ThinPart_GuidePage").anchorClicked.emit(QtCore.QUrl("../README.md"))
    assert Path(guide.page).resolve() == FOLDER / CONTENTS and text().startswith("Guide")


def test_translated_pages_are_shown_with_tables_and_pictures(language):
    guide = show_guide()
    page = window.widget("ThinPart_GuidePage")
    for file in sorted((FOLDER / language).glob("*.md")):
        guide.show_page(file.name)
        content = file.read_text(encoding="utf-8")
        assert os.path.samefile(guide.page, file)
        # The first line, which says what the page translates, is not shown.
        assert text().startswith(headings(content)[0]), file
        assert "|---" not in text() and "](" not in text() and "| ---" not in text(), file
        for picture in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", content):
            url = QtCore.QUrl.fromLocalFile(os.path.normpath(file.parent / picture))
            shown = page.document().resource(QtGui.QTextDocument.ImageResource, url)
            assert shown is not None and shown.width() > 100, (file, picture)
