"""The translations of the window, as FreeCAD finds them."""

from pathlib import Path

import FreeCADGui as Gui

TRANSLATIONS = Path(__file__).resolve().parents[2] / "resources" / "translations"


def add_translations():
    """Have texts translated into the language that the user has chosen in FreeCAD, from now on."""
    Gui.addLanguagePath(TRANSLATIONS.as_posix())
    # FreeCAD has chosen its language before it read any workbench.
    Gui.updateLocale()
