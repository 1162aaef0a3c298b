# SPDX-License-Identifier: LGPL-2.1-or-later
"""How lists show categories: titles, coloured squares, and the colour of failures."""

from ...storage.index.part_query import FAILED
from ..application.qt import QtGui, translate
from ..tables.column import square
from .verdict_text import category_title


def group_title(group, profile):
    """Title of a category or of `FAILED`."""
    if group == FAILED:
        return "\u2717 " + translate("ThinPart", "Failed")
    return category_title(group, profile)


def colour_icon(rgb):
    """QIcon of a small coloured square."""
    return QtGui.QIcon(square(rgb))
