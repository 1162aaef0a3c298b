"""What is told without interrupting anybody: in the status bar and in the Report view."""

import FreeCAD as App
import FreeCADGui as Gui

from .elided_button import ElidedButton
from .qt import translate

_MILLISECONDS = 15000
_LETTERS = 60

_MOST_LINES = 20


class Notices:
    """Warnings that stay in the status bar until they are clicked, and sentences that pass by."""

    def __init__(self):
        self._button = None
        self._sentences = []

    def tell(self, sentence):
        """Show a sentence in the status bar for a while."""
        Gui.getMainWindow().statusBar().showMessage(sentence, _MILLISECONDS)

    def tell_failure(self, sentence):
        """As `tell`, and keep it in the Report view, which does not come to the front for it."""
        App.Console.PrintMessage(f"ThinPart: {sentence}\n")
        self.tell(sentence)

    def warn(self, sentence):
        """Keep a sentence in the status bar until it is clicked, and in the Report view."""
        App.Console.PrintWarning(f"ThinPart: {sentence}\n")
        self._sentences.append(sentence)
        self._show()

    def clear(self):
        """Take the warnings away."""
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


NOTICES = Notices()
"""The ones of this session."""
