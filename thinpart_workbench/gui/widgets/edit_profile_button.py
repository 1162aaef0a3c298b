"""The button that opens the profile editor, beside a choice of a profile."""

from pathlib import Path

from ..application import lifelong
from ..application.qt import QtGui, QtWidgets, translate

_ICON = Path(__file__).resolve().parents[3] / "resources" / "icons" / "ThinPart_EditProfile.svg"


def edit_profile_button(parent, name, chosen):
    """A QToolButton with the icon of the editor.

    Parameters
    ----------
    parent : QWidget
    name : str
        Object name.
    chosen : callable
        Returns the profile to edit: name of a shipped one, or path of a file.
    """
    button = QtWidgets.QToolButton(parent)
    button.setObjectName(name)
    button.setIcon(QtGui.QIcon(str(_ICON)))
    button.setAccessibleName(translate("ThinPart", "Edit profile"))
    button.setToolTip(translate("ThinPart", "Shows the thresholds of this profile, to change and save them as your own"))
    button.clicked.connect(lambda *_: lifelong.profile_signals.edit_requested.emit(chosen()))
    return button
