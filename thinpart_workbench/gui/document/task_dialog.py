# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adapter for panels in FreeCAD's task view."""

import FreeCAD as App
import FreeCADGui as Gui

from ...freecad_adapter.guard import guarded_methods
from ..application import lifelong
from ..application.front_document import bring_to_front
from ..application.qt import QtCore, QtWidgets, Signal, flags_as_int, translate
from ..guide.command import lead_to_guide, show_guide
from ..widgets.buttons import add_button
from ..widgets.controls import focus_first, prepare_controls


@guarded_methods("helpRequested", reject=True)
class TaskDialog(QtCore.QObject):
    """The task dialog object that FreeCAD's task view expects.

    Parameters
    ----------
    form : QWidget or list of QWidget
        Each becomes a box of the task view.
    name : str
        The command that it belongs to, for the page of the guide.

    Signals
    -------
    closed
        The panel was closed, by FreeCAD or by ThinPart.

    Notes
    -----
    FreeCAD calls methods with certain names itself, such as ``open``, ``accept`` and ``clicked``. It shows one panel
    whatever document is in front: while that is another one, the panel only says what it is about.
    """

    closed = Signal()

    def __init__(self, form, name):
        super().__init__()
        self._note = _ElsewhereNote()
        self.form = [*(form if isinstance(form, list) else [form]), self._note]
        self._name = name
        self._is_open = False
        self._put_away = []  # boxes that are hidden because another document is in front

    @property
    def is_open(self):
        """Whether the panel is in the task view."""
        return self._is_open

    def show(self, takes_keyboard=True):
        """Show the panel; unless nobody asked for it, the keyboard acts on it.

        Raises
        ------
        RuntimeError
            When another task is open.
        """
        self.prepare()
        Gui.Control.showDialog(self)
        self._is_open = True
        lifelong.whats_this.panel = self._name
        self.form[0].destroyed.connect(self._on_gone)
        task_box_of(self._note).hide()
        if takes_keyboard:
            focus_first(self.form)

    @property
    def is_put_away(self):
        """Whether the panel only says what it is about, because another document is in front."""
        return bool(self._put_away)

    def put_away(self, document):
        """Only say which document the panel is about, until `take_out`: FreeCAD.Document."""
        if not self._put_away:
            boxes = [task_box_of(widget) for widget in self.form if widget is not self._note]
            self._put_away = [box for box in boxes if not box.isHidden()]
            for box in self._put_away:
                box.hide()
            self._note.show_document(document)
            task_box_of(self._note).show()

    def take_out(self):
        """Show again what `put_away` has hidden."""
        boxes, self._put_away = self._put_away, []
        for box in boxes:
            box.show()
        task_box_of(self._note).hide()

    def prepare(self):
        """Prepare the controls, also those that were added since."""
        prepare_controls(self.form, Gui.getMainWindow())
        lead_to_guide(self.form, self._name)

    def hide(self):
        """Close the panel."""
        if self._is_open:
            self._on_gone()
            Gui.Control.closeDialog()

    def reject(self):
        """Called by FreeCAD for the Close button and Esc."""
        self.hide()
        return True

    def getStandardButtons(self):
        """Close, since there is nothing to accept, and Help."""
        return flags_as_int(QtWidgets.QDialogButtonBox.Close) | flags_as_int(QtWidgets.QDialogButtonBox.Help)

    def helpRequested(self):
        """Called by FreeCAD for the Help button."""
        show_guide(self._name)

    def isAllowedAlterSelection(self):
        """True, so that the user can go on working while the panel is open."""
        return True

    def isAllowedAlterView(self):
        """See `isAllowedAlterSelection`."""
        return True

    def isAllowedAlterDocument(self):
        """See `isAllowedAlterSelection`."""
        return True

    def come_to_front(self):
        """Bring the document of a panel that is put away to the front."""
        self._note.bring_to_front()

    def _on_gone(self, *_):
        if self._is_open:
            self._is_open = False
            lifelong.whats_this.panel = ""
            self.closed.emit()


class _ElsewhereNote(QtWidgets.QWidget):
    """Names the document that a panel is about, with a button that brings it to the front."""

    def __init__(self):
        super().__init__()
        self._name = ""
        self.setWindowTitle(translate("ThinPart", "Another document"))
        column = QtWidgets.QVBoxLayout(self)
        self._text = QtWidgets.QLabel(self)
        self._text.setObjectName("ThinPart_Elsewhere")
        self._text.setTextFormat(QtCore.Qt.PlainText)
        self._text.setWordWrap(True)
        column.addWidget(self._text)
        add_button(column, self, "ThinPart_GoThere", translate("ThinPart", "Go to it"), self.bring_to_front)

    def show_document(self, document):
        """Name a document."""
        self._name = document.Name
        self._text.setText(translate("ThinPart", "The open panel is about '{}'.").format(document.Label))

    def bring_to_front(self):
        """Bring the document to the front."""
        bring_to_front(App.getDocument(self._name))


def task_box_of(widget):
    """The titled box of FreeCAD's task view that contains a widget of a form; the widget itself in no task view."""
    candidate = widget
    while candidate is not None:
        if candidate.metaObject().className() in ("Gui::TaskView::TaskBox", "QSint::ActionGroup"):
            return candidate
        candidate = candidate.parentWidget()
    return widget
