# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench: its name, icons, toolbar and menu."""

import FreeCADGui as Gui

from .application.icons import ICONS
from .application.qt import translate
from .commands import add_commands

MENU_TEXT = "ThinPart"
TOOL_TIP = translate("ThinPart", "Check before meshing whether a part is thin, and where")


def add_icons():
    """Register the icon folder; called once, when FreeCAD starts."""
    Gui.addIconPath(ICONS.as_posix())


def initialize(workbench):
    """Add commands, toolbar and menu.

    Parameters
    ----------
    workbench : Gui.Workbench
    """
    names = add_commands()
    workbench.appendToolbar("ThinPart", names)
    workbench.appendMenu("&ThinPart", names)
