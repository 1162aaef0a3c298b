# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that are readable on the background that the theme really draws behind a widget.

FreeCAD's themes are style sheets. They change the text colour, which the widget's palette reflects, and the
background, which it does not: ``palette().base()`` stays white in a dark theme. So custom painting uses the text
colour, lets the background show through, and tells dark from light by the text colour.
"""

from .qt import QtCore, QtGui

_HALF = 127
"""Text lighter than this stands on a dark background."""


def text_colour(widget, alpha=255):
    """QColor of a widget's text with the opacity `alpha` (0 to 255)."""
    text = QtGui.QColor(widget.palette().text().color())
    text.setAlpha(alpha)
    return text


def is_dark(widget):
    """Whether a widget's background is dark."""
    return widget.palette().text().color().lightness() > _HALF


def plot_background(widget):
    """QColor that sets a plot off from its widget's background, in any theme."""
    return text_colour(widget, 14)


def readable(widget, on_light, on_dark):
    """The one of two colours that is readable on a widget's background."""
    return on_dark if is_dark(widget) else on_light


def is_theme_change(event):
    """Whether a QEvent says that the widget's style or palette has changed."""
    return event.type() in (QtCore.QEvent.StyleChange, QtCore.QEvent.PaletteChange)
