# SPDX-License-Identifier: LGPL-2.1-or-later
"""One category of a profile: its criteria, of which one must hold."""

from ..application.qt import QtWidgets, Signal, translate
from ..record.record_view import paint_swatch, show_warning, swatch, text_line
from ..record.verdict_text import category_colour, category_words
from ..widgets.buttons import add_button, small_button
from .criterion_box import CriterionBox
from .kept_text import KeptText
from .removable_list import RemovableList


class CategoryBox(QtWidgets.QGroupBox):
    """Edits one category.

    Parameters
    ----------
    content : dict
        Of the category, in a profile.
    new_criterion : callable
        Returns the content of a criterion to begin with.
    parent : QWidget

    Signals
    -------
    changed
        `content` has changed.
    removed
        The user wants to remove the category.
    moved(int)
        The user wants to move the category by a number of places.
    """

    changed = Signal()
    removed = Signal()
    moved = Signal(int)

    def __init__(self, content, new_criterion, parent):
        super().__init__(parent)
        self._written, self._new_criterion = content, new_criterion
        self.setObjectName("ThinPart_CategoryBox")
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        column.setSpacing(4)
        self._add_names(column)
        self._problem = text_line(self, column, "ThinPart_CategoryProblem")
        self._boxes = RemovableList(self.changed.emit)
        column.addLayout(self._boxes)
        row = QtWidgets.QHBoxLayout()
        add_button(row, self, "ThinPart_CriterionAdd", translate("ThinPart", "Add a criterion (or)"), self.add_criterion,
                   is_for_enter=False)
        row.addStretch(1)
        column.addLayout(row)
        for criterion in content["criteria"]:
            self._boxes.append(CriterionBox(criterion, self))
        self.show_problem("")

    @property
    def criteria(self):
        """list of CriterionBox"""
        return self._boxes.editors

    def content(self):
        """dict: the category as it is now."""
        texts = {"title": self._title.written(), "meaning": self._meaning.written()}
        return {**self._written, "name": self._name.text().strip(),
                **{key: text for key, text in texts.items() if text or key in self._written},
                "criteria": [box.content() for box in self.criteria]}

    def show_place(self, number, count):
        """Show its position among all categories; numbers from 0."""
        title = category_words(self._name.text().strip(), self._title.written() or self._name.text().strip())
        self.setTitle(translate("ThinPart", "{}. {}, where one of these holds").format(number + 1, title))
        self._up.setEnabled(number > 0)
        self._down.setEnabled(number < count - 1)

    def add_criterion(self):
        """Add a criterion."""
        self._boxes.append(CriterionBox(self._new_criterion(), self))
        self.changed.emit()

    def show_problem(self, sentence):
        """Show what is wrong with the category; nothing if the sentence is empty."""
        show_warning(self._problem, sentence)

    def _add_names(self, column):
        row = QtWidgets.QHBoxLayout()
        row.setSpacing(4)
        square = swatch(self, "ThinPart_CategorySwatch", 12)
        paint_swatch(square, category_colour(self._written["name"]))
        row.addWidget(square)
        self._name = QtWidgets.QLineEdit(self._written["name"], self)
        self._name.setObjectName("ThinPart_CategoryName")
        self._name.setToolTip(translate("ThinPart", "The category's short name, by which results and searches refer to it"))
        self._name.textEdited.connect(lambda _: self.changed.emit())
        row.addWidget(self._name, 1)
        self._title = KeptText("ThinPart_CategoryTitle", self._written.get("title", ""), self)
        self._title.setPlaceholderText(translate("ThinPart", "Title"))
        self._title.changed.connect(self.changed)
        row.addWidget(self._title, 2)
        self._up = small_button(self, "ThinPart_CategoryUp", "\u25b2", translate(
            "ThinPart", "Ask for this category earlier: a part gets the first one that applies"),
            lambda: self.moved.emit(-1))
        self._down = small_button(self, "ThinPart_CategoryDown", "\u25bc", translate(
            "ThinPart", "Ask for this category later: a part gets the first one that applies"), lambda: self.moved.emit(1))
        remove = small_button(self, "ThinPart_CategoryRemove", "\u2715", translate(
            "ThinPart", "Remove this category"), self.removed.emit)
        for button in (self._up, self._down, remove):
            row.addWidget(button)
        column.addLayout(row)
        self._meaning = KeptText("ThinPart_CategoryMeaning", self._written.get("meaning", ""), self)
        self._meaning.setPlaceholderText(translate("ThinPart", "What to do with such a part"))
        self._meaning.changed.connect(self.changed)
        column.addWidget(self._meaning)
