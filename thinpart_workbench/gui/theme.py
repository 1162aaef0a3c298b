"""Colours that can be read on whatever the theme really draws behind a widget.

FreeCAD's themes are style sheets. They change the letters, which a widget's palette knows, and the grounds, which
it does not: ``palette().base()`` stays white in a dark theme. So what is drawn here takes the colour of the
letters, lets the ground show through, and tells dark from light by the letters.
"""

from .qt import QtCore, QtGui

_HALF = 127
"""Lightness over which letters stand on a dark ground."""


def text_colour(widget, alpha=255):
    """QColor of a widget's letters, as opaque as `alpha` says (0 to 255)."""
    text = QtGui.QColor(widget.palette().text().color())
    text.setAlpha(alpha)
    return text


def is_dark(widget):
    """Whether a widget's ground is dark."""
    return widget.palette().text().color().lightness() > _HALF


def plot_ground(widget):
    """QColor that sets a plot off from the ground of its widget, whichever that is."""
    return text_colour(widget, 14)


def readable(widget, on_light, on_dark):
    """The one of two colours that can be read on a widget's ground."""
    return on_dark if is_dark(widget) else on_light


def is_theme_change(event):
    """Whether a QEvent tells a widget that its colours are others now."""
    return event.type() in (QtCore.QEvent.StyleChange, QtCore.QEvent.PaletteChange)
