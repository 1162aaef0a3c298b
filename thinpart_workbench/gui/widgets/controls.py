# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the controls of a window usable by keyboard, in the order of reading, and safe from the mouse wheel.

Notes
-----
What Qt does by itself serves where it can. Tab in the order in which widgets were made was tried in the twelve windows: it
is wrong in three, because rows that are added at run time come last. Qt presses what has a letter in its text, but chooses
no letters; one that two controls share, or a control and a menu, is ambiguous to it and only moves the focus.
"""

from functools import partial

from ..application.qt import QtCore, QtGui, QtWidgets, flags_as_int
from .wheel import ignore_wheel_unless_focused

STOPS = "ThinPart_Stops"
"""Property of buttons that stop what was just begun: none is the first control of a panel."""

_FIRST = (QtWidgets.QAbstractButton, QtWidgets.QComboBox, QtWidgets.QAbstractSpinBox, QtWidgets.QLineEdit,
          QtWidgets.QAbstractItemView)
_TURNED = (QtWidgets.QComboBox, QtWidgets.QAbstractSpinBox, QtWidgets.QAbstractSlider)


def prepare_controls(roots, window=None):
    """Give each control below some widgets a letter of its own to press with Alt, order them for Tab, and keep the wheel
    for scrolling.

    Parameters
    ----------
    roots : QWidget or list of QWidget
        A panel, a page or a dialog, about to be shown; the boxes of one panel share the letters.
    window : QMainWindow, optional
        The window that will hold it: letters of its menus are not used.

    Notes
    -----
    Letters that the texts name (``&Folder``) stay where they are free. A translation cannot know which letters the
    menus of FreeCAD have in that language, so all others are chosen here. Pages of which one is seen at a time may use
    the same letters.
    """
    roots = roots if isinstance(roots, list) else [roots]
    for field in (field for root in roots for kind in _TURNED for field in root.findChildren(kind)):
        if not isinstance(field, QtWidgets.QScrollBar) and not field.property("ThinPart_KeepsWheel"):
            field.setProperty("ThinPart_KeepsWheel", True)
            ignore_wheel_unless_focused(field)
    taken = menu_letters(window) if window is not None else set()
    _give([entry for root in roots for entry in controls(root)], taken)
    keeper = roots[0].findChild(_Keeper) or _Keeper(roots, window)
    keeper.order_for_tab(roots)


def focus_first(roots):
    """Let the keyboard act on the first control of a panel that was just opened.

    Parameters
    ----------
    roots : QWidget or list of QWidget
        What `prepare_controls` was given.

    Notes
    -----
    Until there is a control, the panel itself has the focus, so that Tab and Esc act on it; the control gets it once it is
    there, unless the user has gone elsewhere meanwhile.
    """
    roots = roots if isinstance(roots, list) else [roots]
    roots[0].setFocus(QtCore.Qt.OtherFocusReason)
    _pass_focus_on(roots)


def _pass_focus_on(roots):
    """Give the focus that a panel itself has to its first control, if it has one now."""
    if roots[0].hasFocus():
        for each in (each for root in roots for each in reading_order(root)):
            if isinstance(each, _FIRST) and each.isVisible() and each.isEnabled() and not each.property(STOPS):
                each.setFocus(QtCore.Qt.OtherFocusReason)
                return


def reading_order(root):
    """The controls below a widget that Tab can reach, as one reads them: list of QWidget.

    Layouts say in which order; places do not, since there are none yet before the window is shown.
    """
    return [each for each in _in_order(root) if flags_as_int(each.focusPolicy()) & flags_as_int(QtCore.Qt.TabFocus)]


def _in_order(widget):
    """A widget and all in it, in the order of reading; fields of several parts are one control."""
    yield widget
    if isinstance(widget, (QtWidgets.QComboBox, QtWidgets.QAbstractSpinBox, QtWidgets.QAbstractItemView)):
        return
    if isinstance(widget, QtWidgets.QTabWidget):
        inner = [widget.tabBar(), *(widget.widget(page) for page in range(widget.count()))]
    elif isinstance(widget, (QtWidgets.QStackedWidget, QtWidgets.QSplitter)):
        inner = [widget.widget(page) for page in range(widget.count())]
    elif isinstance(widget, (QtWidgets.QScrollArea, QtWidgets.QDockWidget)):
        inner = [widget.widget()]
    else:
        inner = _widgets_of(widget.layout())
    for each in inner:
        if each is not None:
            yield from _in_order(each)


def _widgets_of(layout):
    """The widgets of a layout and of those in it, in the order of reading."""
    places = range(layout.count() if layout is not None else 0)
    if isinstance(layout, QtWidgets.QGridLayout):
        places = sorted(places, key=lambda place: layout.getItemPosition(place)[:2])
    for place in places:
        item = layout.itemAt(place)
        if item.widget() is not None:
            yield item.widget()
        elif item.layout() is not None:
            yield from _widgets_of(item.layout())


class _Keeper(QtCore.QObject):
    """Prepares controls again once their texts have changed, or others were added."""

    def __init__(self, roots, window):
        super().__init__(roots[0])
        self._ordered = []
        self._timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._timer.timeout.connect(lambda: self._prepare_again(roots, window))
        for root in roots:
            root.installEventFilter(self)
            # The request to lay out what scrolls ends there.
            for area in root.findChildren(QtWidgets.QScrollArea):
                if area.widget() is not None:
                    area.widget().installEventFilter(self)

    def _prepare_again(self, roots, window):
        prepare_controls(roots, window)
        _pass_focus_on(roots)

    def order_for_tab(self, roots):
        """Let Tab visit the controls in the order of reading, where that has changed.

        The order that there is is not asked of Qt: that leads through all widgets of FreeCAD, and PySide2 does not survive
        wrapping those that are about to be deleted.
        """
        wanted = [reading_order(root) for root in roots]
        if wanted != self._ordered:
            for controls_of_root in wanted:
                for before, after in zip(controls_of_root, controls_of_root[1:]):
                    QtWidgets.QWidget.setTabOrder(before, after)
            self._ordered = wanted

    def eventFilter(self, _root, event):
        if event.type() == QtCore.QEvent.LayoutRequest:
            self._timer.start()
        return False


def menu_letters(window):
    """The letters of a main window's menus, and of the buttons below its tasks: set of str."""
    closing = QtWidgets.QDialogButtonBox(
        QtWidgets.QDialogButtonBox.Close | QtWidgets.QDialogButtonBox.Help)  # of the task view
    texts = [action.text() for action in window.menuBar().actions() if action.isVisible()]
    return {mnemonic(text) for text in (*texts, *(button.text() for button in closing.buttons()))} - {""}


def mnemonic(text):
    """The letter after the single ``&`` of a text, in lower case, or an empty text."""
    return str(QtGui.QKeySequence.mnemonic(text).toString())[-1:].lower()


def controls(root):
    """What a letter can press below a widget: list of (page or None, text, function that sets the text).

    The page is one of those of which one is seen at a time.
    """
    widgets = [label for label in root.findChildren(QtWidgets.QLabel) if label.buddy() is not None]
    widgets += [button for button in root.findChildren(QtWidgets.QAbstractButton) if len(plain(button.text())) > 1]
    found = [(_page_of(widget, root), widget.text(), widget.setText) for widget in widgets]
    for bar in root.findChildren(QtWidgets.QTabBar):
        found += [(_page_of(bar, root), bar.tabText(tab), partial(bar.setTabText, tab)) for tab in range(bar.count())]
    return found


def plain(text):
    """A text as it is seen: without the mark of its letter."""
    return text.replace("&&", "\0").replace("&", "").replace("\0", "&")


def _page_of(widget, root):
    """The outermost page between a widget and a root; only the root's own widgets are asked."""
    page = None
    while widget is not root:
        parent = widget.parentWidget()
        if isinstance(parent, QtWidgets.QStackedWidget):
            page = widget
        widget = parent
    return page


def _give(found, taken):
    """Give letters to controls: first to those outside of pages, since they are seen beside each page."""
    taken, pages = set(taken), {}
    for page, text, set_text in found:
        pages.setdefault(page, []).append((text, set_text))
    outside = pages.pop(None, [])
    named = {mnemonic(text) for page in pages.values() for text, _ in page}
    used = _give_letters(outside, taken, named)
    for page in pages.values():
        _give_letters(page, used, set())


def _give_letters(entries, taken, avoided):
    """Give letters to controls that are seen together; return all that are taken then."""
    taken, without = set(taken), []
    for text, set_text in entries:
        letter = mnemonic(text)
        if letter and letter not in taken:
            taken.add(letter)
        else:
            without.append((plain(text), text, set_text))
    # Controls with few letters choose first.
    for text, old, set_text in sorted(without, key=lambda entry: len(set(entry[0]))):
        place = _place(text, taken | avoided)
        if place is None:
            place = _place(text, taken)
        marked = text.replace("&", "&&") if place is None else (
            text[:place].replace("&", "&&") + "&" + text[place:].replace("&", "&&"))
        if place is not None:
            taken.add(text[place].lower())
        if marked != old:
            set_text(marked)
    return taken


def _place(text, taken):
    """Where the best free letter of a text is: the first of a word, or else any; None where all are taken."""
    free = [place for place, letter in enumerate(text) if letter.isalpha() and letter.lower() not in taken
            and letter.isascii()]
    return min(free, key=lambda place: (place > 0 and text[place - 1].isalnum(), place), default=None)
