"""The workbench: its name, icons, toolbar and menu."""

from pathlib import Path

import FreeCADGui as Gui

from .application.qt import translate
from .commands import add_commands

ICONS = (Path(__file__).resolve().parents[2] / "resources" / "icons").as_posix()
MENU_TEXT = "ThinPart"
TOOL_TIP = translate("ThinPart", "Check before meshing whether a part is thin, and where")


def add_icons():
    """Register the icon folder; called once, when FreeCAD starts."""
    Gui.addIconPath(ICONS)


def initialize(workbench):
    """Add commands, toolbar and menu.

    Parameters
    ----------
    workbench : Gui.Workbench
    """
    names = add_commands()
    workbench.appendToolbar("ThinPart", names)
    workbench.appendMenu("&ThinPart", names)
