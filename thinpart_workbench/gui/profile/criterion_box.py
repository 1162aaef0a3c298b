# SPDX-License-Identifier: LGPL-2.1-or-later
"""One criterion of a category: its conditions, which must all hold."""

from ..application.qt import QtWidgets, Signal, translate
from ..record.record_view import show_warning, text_line
from ..widgets.buttons import add_button, small_button
from .condition_editor import ConditionEditor
from .edited_profile import new_condition
from .kept_text import KeptText
from .removable_list import RemovableList


class CriterionBox(QtWidgets.QFrame):
    """Edits one criterion.

    Parameters
    ----------
    content : dict
        Of the criterion, in a profile.
    parent : QWidget

    Signals
    -------
    changed
        `content` has changed.
    removed
        The user wants to remove the criterion.
    """

    changed = Signal()
    removed = Signal()

    def __init__(self, content, parent):
        super().__init__(parent)
        self._written = content
        self.setFrameShape(QtWidgets.QFrame.StyledPanel)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 4, 6, 4)
        column.setSpacing(2)
        row = QtWidgets.QHBoxLayout()
        row.setSpacing(4)
        label = QtWidgets.QLabel(translate("ThinPart", "Criterion"), self)
        row.addWidget(label)
        self._id = QtWidgets.QLineEdit(str(content["id"]), self)
        self._id.setObjectName("ThinPart_CriterionId")
        self._id.setCursorPosition(0)
        self._id.setToolTip(translate("ThinPart", "The criterion's short name, by which results and searches refer to it"))
        self._id.textEdited.connect(lambda _: self.changed.emit())
        label.setBuddy(self._id)
        row.addWidget(self._id, 1)
        self._title = KeptText("ThinPart_CriterionTitle", content.get("title", ""), self)
        self._title.setPlaceholderText(translate("ThinPart", "What it says about a part"))
        self._title.changed.connect(self.changed)
        row.addWidget(self._title, 3)
        row.addWidget(small_button(self, "ThinPart_CriterionRemove", "\u2715", translate(
            "ThinPart", "Remove this criterion"), self.removed.emit))
        column.addLayout(row)
        self._rows = RemovableList(self._show_change)
        column.addLayout(self._rows)
        row = QtWidgets.QHBoxLayout()
        self._add = add_button(row, self, "ThinPart_ConditionAdd", translate("ThinPart", "Add a condition (and)"),
                               self.add_condition, is_for_enter=False)
        self._add.setFlat(True)
        row.addStretch(1)
        column.addLayout(row)
        self._problem = text_line(self, column, "ThinPart_CriterionProblem")
        for condition in content["conditions"]:
            self._rows.append(ConditionEditor(condition, self))
        self._show_removal()
        self.show_problem("")

    @property
    def conditions(self):
        """list of ConditionEditor"""
        return self._rows.editors

    def content(self):
        """dict: the criterion as it is now."""
        text = self._id.text().strip()
        number = self._written["id"] if text == str(self._written["id"]) else text
        title = self._title.written()
        return {**self._written, "id": number, **({"title": title} if title or "title" in self._written else {}),
                "conditions": [row.content() for row in self.conditions]}

    def add_condition(self):
        """Add a condition."""
        self._rows.append(ConditionEditor(new_condition(), self))
        self._show_change()

    def show_problem(self, sentence):
        """Show what is wrong with the criterion; nothing if the sentence is empty."""
        show_warning(self._problem, sentence)

    def _show_change(self):
        self._show_removal()
        self.changed.emit()

    def _show_removal(self):
        for row in self.conditions:
            row.allow_removal(len(self.conditions) > 1)
