"""The verdict on the active document, in the status bar."""

import FreeCADGui as Gui

from .classify import can_classify, classify_active_document
from .elided_button import ElidedButton
from .notices import NOTICES
from .qt import translate

_LETTERS = 50


class VerdictLabel:
    """A small button; pressing it classifies the part in the panel. Made when it is first shown."""

    def __init__(self):
        self._button = None

    def show(self, words, reason=""):
        """Show a verdict, or what there is instead of one.

        Parameters
        ----------
        words : str
        reason : str, optional
            For the tool tip.
        """
        if self._button is None:
            self._button = ElidedButton("ThinPart_StatusVerdict", _LETTERS)
            self._button.clicked.connect(lambda *_: _classify())
            Gui.getMainWindow().statusBar().addPermanentWidget(self._button)
        self._button.setText(translate("ThinPart", "ThinPart: {}").format(words))
        self._button.setToolTip("\n".join(filter(None, [
            reason, translate("ThinPart", "The active document as it was saved. Click to classify it "
                              "in the panel.")])))
        self._button.updateGeometry()
        self._button.show()

    def hide(self):
        """Take it away."""
        if self._button is not None:
            self._button.hide()


def _classify():
    if can_classify():
        classify_active_document()
    else:
        NOTICES.tell(translate(
            "ThinPart", "To classify a part, open a document and close the task that is open."))
