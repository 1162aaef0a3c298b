# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals about profiles, by which the profile editor and whoever chooses a profile know of each other."""

from .qt import QtCore, Signal


class ProfileSignals(QtCore.QObject):
    """Names are those of shipped profiles, or paths of files.

    Signals
    -------
    edit_requested(str)
        The user wants to edit a profile.
    saved(str)
        A profile was written.
    used(str)
        The user has chosen in the editor to judge by a profile from now on.
    """

    edit_requested = Signal(str)
    saved = Signal(str)
    used = Signal(str)
