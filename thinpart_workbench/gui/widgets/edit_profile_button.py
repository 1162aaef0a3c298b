# SPDX-License-Identifier: LGPL-2.1-or-later
"""The button that opens the profile editor, beside a choice of a profile."""

from ..application import lifelong
from ..application.icons import icon
from ..application.qt import QtWidgets, translate


def edit_profile_button(parent, name, chosen):
    """A QToolButton with the icon of the editor; `chosen` returns the profile to edit, as a name or a path."""
    button = QtWidgets.QToolButton(parent)
    button.setObjectName(name)
    button.setIcon(icon("ThinPart_EditProfile"))
    button.setAccessibleName(translate("ThinPart", "Edit profile"))
    button.setToolTip(translate("ThinPart", "Shows the thresholds of this profile, to change and save them as your own"))
    button.clicked.connect(lambda *_: lifelong.profile_signals.edit_requested.emit(chosen()))
    return button
