"""The button that opens the profile editor, beside a choice of a profile."""

from ..application import lifelong
from ..application.icons import icon
from ..application.qt import QtWidgets, translate


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
    button.setIcon(icon("ThinPart_EditProfile"))
    button.setAccessibleName(translate("ThinPart", "Edit profile"))
    button.setToolTip(translate("ThinPart", "Shows the thresholds of this profile, to change and save them as your own"))
    button.clicked.connect(lambda *_: lifelong.profile_signals.edit_requested.emit(chosen()))
    return button
