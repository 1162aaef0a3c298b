"""Registers the translations of the GUI with FreeCAD."""

from pathlib import Path

import FreeCADGui as Gui

TRANSLATIONS = Path(__file__).resolve().parents[3] / "resources" / "translations"


def add_translations():
    """Register the translations, so that texts appear in the language chosen in FreeCAD."""
    Gui.addLanguagePath(TRANSLATIONS.as_posix())
    # FreeCAD sets its language before it loads any workbench.
    Gui.updateLocale()
