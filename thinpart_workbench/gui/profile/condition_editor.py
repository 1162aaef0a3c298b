# SPDX-License-Identifier: LGPL-2.1-or-later
"""One condition of a criterion: a sentence, and the fields that change it."""

import math

from ...core.descriptors.descriptor_table import QUANTITIES, quantity_named
from ...core.judging.condition_text import quantity_text
from ...core.judging.criteria import COMPARISONS
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtWidgets, Signal, translate
from ..application.sentences import translated
from ..record.record_view import show_warning, text_line
from ..widgets.buttons import small_button
from ..widgets.exact_field import ExactField
from ..widgets.narrow_fields import narrow_combo

_UNITS = {"mm2": "mm\u00b2", "mm3": "mm\u00b3"}
_WIDEST = 70
"""Characters of the widest line in the list of quantities."""


class ConditionEditor(QtWidgets.QWidget):
    """Edits one condition.

    Parameters
    ----------
    content : dict
        Of the condition, in a profile.
    parent : QWidget

    Signals
    -------
    changed
        `content` has changed.
    removed
        The user wants to remove the condition.
    """

    changed = Signal()
    removed = Signal()

    def __init__(self, content, parent):
        super().__init__(parent)
        self._written = content
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 2, 0, 2)
        column.setSpacing(2)
        self._sentence = text_line(self, column, "ThinPart_ConditionText")
        row = QtWidgets.QHBoxLayout()
        row.setSpacing(4)
        column.addLayout(row)
        self._quantity = self._new_quantity_combo()
        row.addWidget(self._quantity, 1)
        self._bounds = [self._new_bound(row, end) for end in ("Least", "Most")]
        self._comparison = QtWidgets.QComboBox(self)
        self._comparison.setObjectName("ThinPart_ConditionComparison")
        for comparison in reversed(COMPARISONS):
            self._comparison.addItem(comparison, comparison)
        row.addWidget(self._comparison)
        self._threshold = ExactField("ThinPart_ConditionValue", self)
        self._threshold.setToolTip(translate("ThinPart", "The threshold"))
        self._threshold.setMinimumWidth(11 * self.fontMetrics().averageCharWidth())
        row.addWidget(self._threshold)
        self._remove = small_button(self, "ThinPart_ConditionRemove", "\u2715", translate(
            "ThinPart", "Remove this condition"), self.removed.emit)
        row.addWidget(self._remove)
        self._problem = text_line(self, column, "ThinPart_ConditionProblem")
        self._show(content)
        self._quantity.currentIndexChanged.connect(lambda _: self._on_quantity_chosen())
        self._comparison.currentIndexChanged.connect(lambda _: self._on_changed())
        for field in (*self._bounds, self._threshold):
            field.changed.connect(self._on_changed)
        self.show_problem("")

    def content(self):
        """dict: the condition as it is now, with what the user has not changed as it was written."""
        changed = {"comparison": self._comparison.currentData(), "value": self._threshold.exact()}
        quantity = self._chosen()
        before = quantity_named(self._written["quantity"])
        if (quantity.name, quantity.bounds) != (before.name, before.bounds):
            changed["quantity"] = quantity.symbol
        return {**self._written, **changed}

    def own_problem(self):
        """A sentence about the bounds; empty if they are in order."""
        if self._chosen_base().bounds and self._bounds[0].exact() >= self._bounds[1].exact():
            return translate("ThinPart", "The second bound has to be greater than the first.")
        return ""

    def show_problem(self, sentence):
        """Show what is wrong with the condition; nothing if the sentence is empty."""
        show_warning(self._problem, sentence)

    def allow_removal(self, allowed):
        """Say whether the condition may be removed: not the last one of a criterion."""
        self._remove.setEnabled(allowed)

    def _new_quantity_combo(self):
        combo = narrow_combo(self, "ThinPart_ConditionQuantity", 10)
        for quantity in QUANTITIES:
            meaning = translated(quantity.meaning)
            combo.addItem(f"{quantity.symbol}: {meaning}", quantity.name)
            combo.setItemData(combo.count() - 1, meaning, QtCore.Qt.ToolTipRole)
        widest = min(combo.view().sizeHintForColumn(0) + 30, _WIDEST * combo.fontMetrics().averageCharWidth())
        combo.view().setMinimumWidth(widest)
        return combo

    def _new_bound(self, row, end):
        field = ExactField(f"ThinPart_Condition{end}", self)
        field.setMinimumWidth(7 * self.fontMetrics().averageCharWidth())
        row.addWidget(field)
        return field

    def _show(self, content):
        quantity = quantity_named(content["quantity"])
        self._quantity.setCurrentIndex(self._quantity.findData(quantity.name))
        self._comparison.setCurrentIndex(self._comparison.findData(content["comparison"]))
        self._show_forms()
        for field, bound in zip(self._bounds, quantity.bounds or (0.0, 0.1)):
            field.show_exact(bound)
        self._threshold.show_exact(content["value"])
        self._show_sentence()

    def _show_forms(self):
        """Adapt the fields to the quantity."""
        quantity = self._chosen_base()
        is_angle, unit = quantity.is_wall_distance, length_unit()
        for field, meaning in zip(self._bounds, (translate("ThinPart", "From"), translate("ThinPart", "To"))):
            field.setVisible(bool(quantity.bounds))
            field.set_form(suffix="\u00b0" if is_angle else "", decimals=1 if is_angle else 4, least=0.0,
                           most=90.0 if is_angle else 100.0, first_step=1.0 if is_angle else 0.01)
            field.setToolTip(meaning)
        least, most = quantity.limits
        if (least, most) == (0.0, 1.0):
            self._threshold.set_form(100.0, "\u00a0%", 4, 0.0, 1.0, 1.0)
        elif quantity.unit == "mm":
            self._threshold.set_form(1.0 / unit.millimetres, f"\u00a0{unit.symbol}", unit.decimals, 0.0, math.inf, 0.1)
        else:
            suffix = f"\u00a0{_UNITS[quantity.unit]}" if quantity.unit else ""
            self._threshold.set_form(1.0, suffix, 4, 0.0, math.inf, 0.1)

    def _on_quantity_chosen(self):
        self._show_forms()
        base = self._chosen_base()
        if base.bounds:
            for field, bound in zip(self._bounds, base.bounds if base.is_wall_distance else (0.0, 0.1)):
                field.show_exact(bound)
        self._threshold.show_exact(_typical(base))
        self._on_changed()

    def _on_changed(self):
        self._show_sentence()
        self.changed.emit()

    def _show_sentence(self):
        quantity = self._chosen()
        compared = f"\u00a0{self._comparison.currentData()}\u00a0\u00a0{self._threshold.text()}"
        self._sentence.setText(f"{translated(quantity_text(quantity))} {compared}")
        tip = f"{quantity.symbol}: {translated(self._chosen_base().meaning)}"
        self._sentence.setToolTip(tip)
        self._quantity.setToolTip(tip)

    def _chosen_base(self):
        return next(quantity for quantity in QUANTITIES if quantity.name == self._quantity.currentData())

    def _chosen(self):
        """The Quantity with the bounds of the fields."""
        base = self._chosen_base()
        if not base.bounds:
            return base
        low, high = (field.exact() for field in self._bounds)
        return base.bounded(f"{base.symbol}[{_plain(low)};{_plain(high)}]", low, high)


def _plain(value):
    """A number as `quantity_named` reads it: without an exponent."""
    return f"{value:.6f}".rstrip("0").rstrip(".")


def _typical(quantity):
    """A threshold to begin with."""
    least, most = quantity.limits
    if (least, most) == (0.0, 1.0):
        return 0.5
    return 0.05 if quantity.is_wall_distance else 2.0
