# SPDX-License-Identifier: LGPL-2.1-or-later
"""The icons of commands, which their panels and dialogs have too."""

from pathlib import Path

from .qt import QtGui

ICONS = Path(__file__).resolve().parents[3] / "resources" / "icons"


def icon(name):
    """QIcon of a command."""
    return QtGui.QIcon(str(ICONS / f"{name}.svg"))
