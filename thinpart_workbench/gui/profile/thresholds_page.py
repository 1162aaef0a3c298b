# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of the profile editor with the categories and their criteria."""

from ...api.window.profiles import never_met
from ...core.categories import NORMAL, UNKNOWN
from ..application.qt import QtWidgets, Signal, call_later, translate
from ..application.sentences import translated
from ..record.record_view import show_text
from ..widgets.buttons import add_button
from ..widgets.exact_field import ExactField
from .category_box import CategoryBox
from .edited_profile import empty_profile, loses_probabilities, new_category, new_criterion
from .kept_text import KeptText
from .removable_list import RemovableList


class ThresholdsPage(QtWidgets.QScrollArea):
    """Edits the content of a profile, except its name.

    Signals
    -------
    changed
        `content` has changed.
    """

    changed = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setFrameShape(QtWidgets.QFrame.NoFrame)
        self.show_content(empty_profile())

    @property
    def categories(self):
        """list of CategoryBox"""
        return self._boxes.editors

    def show_content(self, content):
        """Show a profile that was just read, dict; its content is what editing begins with."""
        self._start = content
        form = QtWidgets.QWidget(self)
        form.setObjectName("ThinPart_ProfileForm")
        column = QtWidgets.QVBoxLayout(form)
        self._add_texts(form, column)
        label = QtWidgets.QLabel(translate(
            "ThinPart", "A part gets the first category of which a criterion holds. If none holds, it is normal."), form)
        label.setWordWrap(True)
        column.addWidget(label)
        self._boxes = RemovableList(self._on_changed)
        column.addLayout(self._boxes)
        for category in content["categories"]:
            self._append(category)
        row = QtWidgets.QHBoxLayout()
        add_button(row, form, "ThinPart_CategoryAdd", translate("ThinPart", "Add a category"), self.add_category,
                   is_for_enter=False)
        row.addStretch(1)
        column.addLayout(row)
        self._add_sureness(form, column)
        column.addStretch(1)
        self.setWidget(form)
        for widget in (self.viewport(), form):
            widget.setAutoFillBackground(False)  # the colour of the tab, in every theme
        self._show_places()
        self._show_sureness()

    def content(self):
        """dict: the profile as it is now, with what the user has not changed as it was written."""
        content = self._criteria_content()
        if loses_probabilities(content, self._start):
            del content["probability"]
        if "probability" in content:
            content["probability"] = {**content["probability"], "unsure_under": self._unsure.exact()}
        elif "borderline_margin" in self._start or self._margin.exact() != 0.1:
            content["borderline_margin"] = self._margin.exact()
        return content

    def problem(self):
        """Look for what cannot be used, and show it at the fields: str, the first sentence; empty if there is none."""
        problems = [*self._name_problems(), *self._bound_problems()]
        if not problems:
            found = {place: translated(problem) for place, problem in never_met(self.content()).items()}
        else:
            found = {}
        for number, category in enumerate(self.categories):
            for place, criterion in enumerate(category.criteria):
                for position, row in enumerate(criterion.conditions):
                    sentence = row.own_problem() or found.get((number, place, position), "")
                    row.show_problem(sentence)
                    problems += [sentence] * bool(sentence and sentence not in problems)
        return problems[0] if problems else ""

    def add_category(self):
        """Add a category after the others."""
        self._append(new_category(self._criteria_content()))
        self._on_changed()

    def _criteria_content(self):
        texts = {"title": self._title.written(), "source": self._source.written()}
        content = {**self._start, "categories": [box.content() for box in self.categories],
                   **{key: text for key, text in texts.items() if text or key in self._start}}
        if self._floor.exact() != self._start.get("area_floor", 1e-4):
            content["area_floor"] = self._floor.exact()
        return content

    def _add_texts(self, form, column):
        grid = QtWidgets.QFormLayout()
        self._title = KeptText("ThinPart_ProfileTitle", self._start.get("title", self._start["name"]), form)
        self._source = KeptText("ThinPart_ProfileSource", self._start.get("source", ""), form)
        self._source.setPlaceholderText(translate("ThinPart", "Where the thresholds are from"))
        for text, field in ((translate("ThinPart", "Title"), self._title), (translate("ThinPart", "Source"), self._source)):
            field.changed.connect(self.changed)
            field.setToolTip(field.text())
            grid.addRow(text, field)
        column.addLayout(grid)

    def _add_sureness(self, form, column):
        box = QtWidgets.QGroupBox(translate("ThinPart", "How sure a verdict is"), form)
        grid = QtWidgets.QFormLayout(box)
        self._sureness = grid
        grid.setFieldGrowthPolicy(QtWidgets.QFormLayout.FieldsStayAtSizeHint)

        def add(name, text, meaning, value):
            field = ExactField(f"ThinPart_Profile{name}", box)
            field.set_form(100.0, "\u00a0%", 4, 0.0, 1.0)
            field.show_exact(value)
            field.changed.connect(self._on_changed)
            field.setToolTip(meaning)
            grid.addRow(text, field)
            return field

        self._unsure = add(
            "Unsure", translate("ThinPart", "Unsure below a probability of"),
            translate("ThinPart", "A verdict that is less probable is called unsure"),
            self._start.get("probability", {}).get("unsure_under", 0.5))
        self._margin = add(
            "Margin", translate("ThinPart", "Borderline within"), translate(
                "ThinPart", "A verdict is called borderline if a quantity lies nearer to its threshold, relative to that"),
            self._start.get("borderline_margin", 0.1))
        self._floor = add(
            "Floor", translate("ThinPart", "Least share of the surface that counts"), translate(
                "ThinPart", "A smaller share of the surface counts as none, because single rays may stray"),
            self._start.get("area_floor", 1e-4))
        self._lost = QtWidgets.QLabel(box)
        self._lost.setObjectName("ThinPart_ProfileProbabilities")
        self._lost.setWordWrap(True)
        grid.addRow(self._lost)
        column.addWidget(box)

    def _show_sureness(self):
        """Show the limit that counts: that of the probabilities, or that of the margin where there are none."""
        lost = loses_probabilities(self._criteria_content(), self._start)
        has_probabilities = "probability" in self._start and not lost
        for field, shown in ((self._unsure, has_probabilities), (self._margin, not has_probabilities)):
            field.setVisible(shown)
            self._sureness.labelForField(field).setVisible(shown)
        show_text(self._lost, translate(
            "ThinPart", "The probabilities of this profile belong to its thresholds before your change: they say how often "
            "engineers agreed with verdicts by those. The changed profile is saved without them, and its verdicts are "
            "borderline near a threshold instead. 'thinpart learn' makes new ones from labels.") if lost else "")

    def _append(self, content):
        box = CategoryBox(content, lambda: new_criterion(self._criteria_content()), self.widget())
        box.moved.connect(lambda places: self._move_category(box, places))
        self._boxes.append(box)

    def _move_category(self, box, places):
        self._boxes.move(box, places)
        call_later(self, lambda: self.ensureWidgetVisible(box))

    def _on_changed(self):
        self._show_places()
        self._show_sureness()
        self.changed.emit()

    def _show_places(self):
        for number, box in enumerate(self.categories):
            box.show_place(number, len(self.categories))

    def _name_problems(self):
        """Show names that are missing or there twice, and return the sentences."""
        problems, names, ids = [], set(), set()
        for box in self.categories:
            content = box.content()
            sentence = _name_problem(content["name"], names)
            box.show_problem(sentence)
            problems += [sentence] * bool(sentence)
            for criterion, criterion_box in zip(content["criteria"], box.criteria):
                text = str(criterion["id"])
                sentence = translate("ThinPart", "The criterion needs a short name.") if not text else translate(
                    "ThinPart", "There are two criteria {}.").format(text) if text in ids else ""
                criterion_box.show_problem(sentence)
                problems += [sentence] * bool(sentence)
                ids.add(text)
        return problems

    def _bound_problems(self):
        rows = (row for box in self.categories for criterion in box.criteria for row in criterion.conditions)
        return [sentence for sentence in (row.own_problem() for row in rows) if sentence]


def _name_problem(name, names):
    """What is wrong with a category's name, given those before it, to which it is added: str."""
    is_twice = name in names
    names.add(name)
    if not name:
        return translate("ThinPart", "The category needs a short name.")
    if name in (NORMAL, UNKNOWN):
        return translate("ThinPart", "'normal' and 'unknown' mean that no criterion holds, or that it cannot be told: "
                                     "choose another name.")
    return translate("ThinPart", "There are two categories {}.").format(name) if is_twice else ""
