"""The button in the status bar that shows the verdict on the active document."""

import FreeCADGui as Gui

from ...core.hook import Hook
from ...freecad_adapter.guard import report_fault
from ..application.qt import translate
from ..widgets.elided_button import ElidedButton

_MAX_CHARACTERS = 50


class StatusButton:
    """A small button that is created when it is first shown.

    Attributes
    ----------
    clicked : Hook
        Called when the button is clicked.
    """

    def __init__(self):
        self._button, self.clicked = None, Hook(report_fault)

    def show(self, text, reason=""):
        """Show a verdict, or the state of the classification.

        Parameters
        ----------
        text : str
        reason : str, optional
            Shown in the tool tip.
        """
        if self._button is None:
            self._button = ElidedButton("ThinPart_StatusVerdict", _MAX_CHARACTERS)
            self._button.clicked.connect(lambda *_: self.clicked())
            Gui.getMainWindow().statusBar().addPermanentWidget(self._button)
        self._button.setText(translate("ThinPart", "ThinPart: {}").format(text))
        self._button.setToolTip("\n".join(filter(None, [
            reason, translate("ThinPart", "The active document as it was saved. Click to classify it "
                              "in the panel.")])))
        self._button.updateGeometry()
        self._button.show()

    def hide(self):
        """Hide the button."""
        if self._button is not None:
            self._button.hide()
