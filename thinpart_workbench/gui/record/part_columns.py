# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of tables whose rows are parts and failures: what a run or an index has of them."""

from dataclasses import replace

from ...core.descriptors.descriptor_table import QUANTITIES
from ...core.errors import KINDS
from ..application.numbers import number, percent
from ..application.qt import translate
from ..application.sentences import translated
from ..tables.column import Column, figures, length, square
from .verdict_text import category_colour, marked_thinnest, verdict_words

RISK = "risk"
"""Key of the risk of the automatic mesh."""


def category_column(profile, **more):
    """What the part is, by the titles of a profile, or how it failed."""
    def text(row):
        if row.error_kind:
            return "\u2717 " + translate("ThinPart", "Failed: {}").format(
                translated(KINDS.get(row.error_kind, row.error_kind)))
        open_between = (row.unsure_between or "").split()
        words = verdict_words(row.category, open_between, profile)
        return translate("ThinPart", "{} (unsure)").format(words) if row.borderline and not open_between else words

    return Column("category", translate("ThinPart", "Category"), text,
                  picture=lambda row: None if row.error_kind else square(category_colour(row.category)), **more)


def measured(key, title, shown=length, **more):
    """A column of the attribute `key` of rows; see `figures`. Failures have nothing there, also no dash."""
    column = figures(key, title, lambda row: getattr(row, key), shown, **more)
    return replace(column, text=lambda row, unit: "" if row.error_kind else shown(getattr(row, key), unit))


def thinnest_column(**more):
    """The thinnest wall, whether it is in a taper or beside a sharp edge, and how many places are about as thin."""
    column = measured("thinnest_mm", translate("ThinPart", "Thinnest, {}"),
                      meaning=translate("ThinPart", "Thinnest wall, and how many places are about as thin"), **more)
    return replace(column, text=lambda row, unit: marked_thinnest(column.shown(row, unit), row.thinnest_at, row.places))


def risk_column():
    """The risk of the automatic mesh, which the user may choose to see."""
    return measured(RISK, translate("ThinPart", "Mesh risk"), lambda value, unit: percent(value), meaning=risk_title(),
                    is_hidden=True)


def risk_title():
    """What the risk is called where there is room for it."""
    return translate("ThinPart", "Risk of the automatic mesh")


def quantity_columns(but, **more):
    """Columns of the quantities that rows have, which the user may choose to see, except those named in `but`: list of
    Column.
    """
    columns = []
    for quantity in QUANTITIES:
        if quantity.keys and quantity.in_table and quantity.name not in but:
            power = {"mm": 1, "mm2": 2, "mm3": 3}.get(quantity.unit, 0)
            meaning = translated(quantity.meaning)
            title = meaning if quantity.symbol == quantity.name else quantity.symbol  # most have a letter in the paper
            title += ("" if not power else ", {}" + ("", "\u00b2", "\u00b3")[power - 1])
            columns.append(replace(measured(quantity.name, title, _in_power(power), meaning=meaning,
                                            is_hidden=True, **more), has_unit=power > 0))
    return columns


def _in_power(power):
    return lambda value, unit: number(unit.value(value, power) if power else value)
