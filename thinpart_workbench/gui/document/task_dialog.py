# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adapter for panels in FreeCAD's task view."""

import FreeCADGui as Gui

from ...freecad_adapter.guard import guarded_methods
from ..application import lifelong
from ..application.qt import QtCore, QtWidgets, Signal, flags_as_int
from ..guide.command import lead_to_guide, show_guide
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
    FreeCAD calls methods with certain names itself, such as ``open``, ``accept`` and ``clicked``.
    """

    closed = Signal()

    def __init__(self, form, name):
        super().__init__()
        self.form = form
        self._name = name
        self._is_open = False

    @property
    def is_open(self):
        """Whether the panel is in the task view."""
        return self._is_open

    def show(self):
        """Show the panel.

        Raises
        ------
        RuntimeError
            When another task is open.
        """
        self.prepare()
        Gui.Control.showDialog(self)
        self._is_open = True
        lifelong.whats_this.panel = self._name
        first = self.form[0] if isinstance(self.form, list) else self.form
        first.destroyed.connect(self._on_gone)
        focus_first(self.form)

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

    def _on_gone(self, *_):
        if self._is_open:
            self._is_open = False
            lifelong.whats_this.panel = ""
            self.closed.emit()
