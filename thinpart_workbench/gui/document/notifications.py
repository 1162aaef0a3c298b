# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages that do not interrupt the user: in FreeCAD's notification area or the status bar, and in the Report view."""

import re

import FreeCAD as App
import FreeCADGui as Gui

from ..application.qt import QtWidgets, translate
from ..widgets.elided_button import StatusBarButton

_STATUS_MILLISECONDS = 15000
_MAX_CHARACTERS = 60

_MAX_LINES = 20

_OWN_NAME = "ThinPart"

_OF_A_STACK = re.compile(r"\s|File \"|Traceback|(Current t|T)hread\b|Extension modules:|\.\.\.$|<")
"""Lines of a traceback and of faulthandler that say where, and not what."""


class Notifications:
    """Warnings that stay until they are dismissed, and messages that disappear by themselves.

    Notes
    -----
    Since 0.21, FreeCAD has a notification area, a bell in the status bar: it shows new notifications for some seconds,
    counts them and keeps them, with the document that they are about. Where it exists, warnings appear only there and
    not elsewhere in the status bar: the user would have to dismiss a second button with the same sentences as well.
    Where FreeCAD has no notification area, or the user has switched it off, a button of ThinPart keeps the warnings.

    FreeCAD itself passes on to the area what is printed with `PrintWarning` and `PrintError`.
    """

    def __init__(self):
        self._button = StatusBarButton("ThinPart_Notice", _MAX_CHARACTERS, self.clear)
        self._sentences = []

    def show_message(self, sentence):
        """Show a sentence in the status bar for a while."""
        Gui.getMainWindow().statusBar().showMessage(sentence, _STATUS_MILLISECONDS)

    def show_failure(self, sentence, source=_OWN_NAME):
        """Like `show_message`; also keep it in the area and in the Report view, without raising that view.

        Parameters
        ----------
        sentence : str
        source : str, optional
            Label of the document that it is about.
        """
        App.Console.PrintMessage(f"{_OWN_NAME}: {sentence}\n")
        if _has_area():
            App.Console.PrintTranslatedUserWarning(source, f"{_with_own_name(sentence, source)}\n")
        self.show_message(sentence)

    def warn(self, sentence, source=_OWN_NAME):
        """Keep a warning visible until it is dismissed, and in the Report view; see `show_failure`."""
        _print("PrintWarning", sentence, source)
        if not _has_area():
            self._sentences.append(sentence)
            self._show_button()

    def report_warning(self, sentence, source=_OWN_NAME):
        """Add a warning only to the area and the Report view; see `show_failure`."""
        _print("PrintWarning", sentence, source)

    def report_error(self, sentence, source=_OWN_NAME):
        """Like `report_warning`, for an error."""
        _print("PrintError", sentence, source)

    def report_output(self, output):
        """Report the last sentence that a process wrote before it died; the whole output goes to the log.

        Parameters
        ----------
        output : str
            May be a traceback, or what faulthandler writes of a crash: the area would show every line.
        """
        App.Console.PrintLog(output + "\n")
        sentences = [line.strip() for line in output.splitlines() if line.strip() and not _OF_A_STACK.match(line)]
        if sentences:
            self.report_error(sentences[-1])

    def clear(self):
        """Remove the warnings of ThinPart's own button, and hide it."""
        self._sentences.clear()
        self._button.hide()

    def _show_button(self):
        last, count = self._sentences[-1], len(self._sentences)
        text = last if count == 1 else translate("ThinPart", "{} warnings; {}").format(count, last)
        self._button.show("\u26a0 " + text, "\n".join(
            [*self._sentences[-_MAX_LINES:], translate("ThinPart", "Click to close this message.")]))


def _print(kind, sentence, source):
    """Print to the Report view and, where FreeCAD has one, the notification area."""
    if hasattr(App.Console, "PrintNotification"):
        getattr(App.Console, kind)(source, f"{_with_own_name(sentence, source)}\n")
    else:
        getattr(App.Console, kind)(f"{_OWN_NAME}: {sentence}\n")  # FreeCAD 0.20 has no notifier argument


def _with_own_name(sentence, source):
    # FreeCAD prefixes the sentence with its source, which is enough where that is ThinPart itself.
    return sentence if source == _OWN_NAME else f"{_OWN_NAME}: {sentence}"


def _has_area():
    """Whether FreeCAD has the notification area, and the user has not switched it off."""
    area = Gui.getMainWindow().statusBar().findChild(QtWidgets.QWidget, "notificationArea")
    return area is not None and hasattr(App.Console, "PrintTranslatedUserWarning")
