"""How lists show categories: titles, coloured squares, and the colour of failures."""

from ...storage.index.part_query import FAILED
from ..application.qt import QtGui, colour, translate
from .verdict_text import category_title

FAILED_COLOUR = (0.80, 0.07, 0.07)


def group_title(group, profile):
    """Title of a category or of `FAILED`."""
    if group == FAILED:
        return "\u2717 " + translate("ThinPart", "Failed")
    return category_title(group, profile)


def colour_icon(rgb):
    """QIcon of a small coloured square."""
    return QtGui.QIcon(colour_square(rgb))


def colour_square(rgb):
    """QPixmap of a small coloured square."""
    pixmap = QtGui.QPixmap(12, 12)
    pixmap.fill(colour(rgb))
    return pixmap
