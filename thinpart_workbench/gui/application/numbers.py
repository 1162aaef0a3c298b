# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as text with the decimal mark of the input fields beside them."""

from ...core import number_text
from .qt import QtCore, translate


def decimal_mark():
    """str: the one that FreeCAD's input fields have, a point or a comma."""
    return str(QtCore.QLocale().decimalPoint())


def marked(text):
    """str: a text of numbers, and of nothing that may be a name, with their decimal mark."""
    return number_text.with_decimal_mark(text, decimal_mark())


def number(value):
    """See `number_text.number`."""
    return marked(number_text.number(value))


def percent(share):
    """See `number_text.percent`."""
    return marked(number_text.percent(share))


def duration(seconds):
    """How long something takes, in words."""
    if seconds < 99.5:
        return translate("ThinPart", "{} s").format(max(1, round(seconds)))
    minutes = round(seconds / 60.0)
    if minutes < 100:
        return translate("ThinPart", "{} min").format(minutes)
    return translate("ThinPart", "{} h {} min").format(*divmod(minutes, 60))
