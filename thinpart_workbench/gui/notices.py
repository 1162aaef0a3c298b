"""What is told without interrupting anybody: in FreeCAD's notification area or the status bar, and in the Report view."""

import FreeCAD as App
import FreeCADGui as Gui

from .elided_button import ElidedButton
from .qt import QtWidgets, translate

_MILLISECONDS = 15000
_LETTERS = 60

_MOST_LINES = 20

_WE = "ThinPart"


class Notices:
    """Warnings that stay until they are looked at, and sentences that pass by.

    Notes
    -----
    FreeCAD has a notification area since 0.21, a bell in the status bar: it shows what is new for some seconds,
    counts it and keeps it, with the document that it is about. Where it is, warnings go there and to nowhere else in the
    status bar: a second button with the same sentences would have to be dismissed once more. A button of our own
    keeps them where FreeCAD has no area, or the user has switched it off.

    FreeCAD passes what is printed with `PrintWarning` and `PrintError` on to the area itself.
    """

    def __init__(self):
        self._button = None
        self._sentences = []

    def tell(self, sentence):
        """Show a sentence in the status bar for a while."""
        Gui.getMainWindow().statusBar().showMessage(sentence, _MILLISECONDS)

    def tell_failure(self, sentence, about=_WE):
        """As `tell`, and keep it in the area and in the Report view, which does not come to the front for it.

        Parameters
        ----------
        sentence : str
        about : str, optional
            Label of the document that it is about.
        """
        App.Console.PrintMessage(f"{_WE}: {sentence}\n")
        if _has_area():
            App.Console.PrintTranslatedUserWarning(about, f"{_by_us(sentence, about)}\n")
        self.tell(sentence)

    def warn(self, sentence, about=_WE):
        """Keep a sentence where it is seen until it is looked at, and in the Report view; see `tell_failure`."""
        _print("PrintWarning", sentence, about)
        if not _has_area():
            self._sentences.append(sentence)
            self._show()

    def report(self, sentence, about=_WE):
        """Keep a warning in the area and the Report view alone; see `tell_failure`."""
        _print("PrintWarning", sentence, about)

    def complain(self, sentence, about=_WE):
        """As `report`, of an error."""
        _print("PrintError", sentence, about)

    def quote(self, last_words):
        """Keep the last line of what a process wrote before it died; all of it goes to the log.

        Parameters
        ----------
        last_words : str
            A traceback is no sentence, and the area would show every line of it.
        """
        App.Console.PrintLog(last_words + "\n")
        lines = [each.strip() for each in last_words.splitlines() if each.strip()]
        if lines:
            self.complain(lines[-1])

    def clear(self):
        """Take the warnings of our own button away."""
        self._sentences.clear()
        if self._button is not None:
            self._button.hide()

    def _show(self):
        if self._button is None:
            self._button = ElidedButton("ThinPart_Notice", _LETTERS)
            self._button.clicked.connect(lambda *_: self.clear())
            Gui.getMainWindow().statusBar().addPermanentWidget(self._button)
        last, count = self._sentences[-1], len(self._sentences)
        text = last if count == 1 else translate("ThinPart", "{} warnings; {}").format(count, last)
        self._button.setText("\u26a0 " + text)
        self._button.setToolTip("\n".join(
            [*self._sentences[-_MOST_LINES:], translate("ThinPart", "Click to take this away.")]))
        self._button.updateGeometry()
        self._button.show()


def _print(kind, sentence, about):
    """Print to the Report view and, where FreeCAD has one, the notification area."""
    if hasattr(App.Console, "PrintNotification"):
        getattr(App.Console, kind)(about, f"{_by_us(sentence, about)}\n")
    else:
        getattr(App.Console, kind)(f"{_WE}: {sentence}\n")  # FreeCAD 0.20 knows no notifier


def _by_us(sentence, about):
    # FreeCAD names whom it is about before the sentence: that is enough where it is ourselves.
    return sentence if about == _WE else f"{_WE}: {sentence}"


def _has_area():
    """Whether FreeCAD has the area, and the user has not switched it off."""
    area = Gui.getMainWindow().statusBar().findChild(QtWidgets.QWidget, "notificationArea")
    return area is not None and hasattr(App.Console, "PrintTranslatedUserWarning")


NOTICES = Notices()
"""The ones of this session."""
