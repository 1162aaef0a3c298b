# SPDX-License-Identifier: LGPL-2.1-or-later
"""Room for what comes and goes, so that nothing that is pressed moves under the mouse."""

from ..application.qt import QtCore


def keep_room(widget, lines=0):
    """Keep the room of a QWidget while it is hidden; of a label, room for at least so many lines of text."""
    _retain(widget, True)
    if lines:
        widget.setMinimumHeight(lines * widget.fontMetrics().lineSpacing())


class LeftRoom(QtCore.QObject):
    """Shows and hides a widget whose room is given up only once the mouse has left its panel.

    Parameters
    ----------
    widget : QWidget
    panel : QWidget
    """

    def __init__(self, widget, panel):
        super().__init__(panel)
        self._widget, self._panel = widget, panel

    def show(self):
        """Show the widget."""
        self._give_up()
        self._widget.show()

    def hide(self):
        """Hide the widget; what is below it moves up at once only where the mouse is not over the panel."""
        if self._widget.isVisible() and self._panel.underMouse():
            _retain(self._widget, True)
            self._panel.installEventFilter(self)
        self._widget.hide()

    def eventFilter(self, watched, event):
        """Wait for the mouse to leave."""
        if event.type() == QtCore.QEvent.Leave:
            self._give_up()
        return False

    def _give_up(self):
        self._panel.removeEventFilter(self)
        _retain(self._widget, False)


def _retain(widget, is_retained):
    policy = widget.sizePolicy()
    policy.setRetainSizeWhenHidden(is_retained)
    widget.setSizePolicy(policy)
