# SPDX-License-Identifier: LGPL-2.1-or-later
"""The language of the window: its translations, and which one it is."""

from pathlib import Path

import FreeCADGui as Gui

TRANSLATIONS = Path(__file__).resolve().parents[3] / "resources" / "translations"


def language_of(codes):
    """FreeCAD's language where it is one of some codes, else the first of them: str."""
    code = Gui.supportedLocales().get(Gui.getLocale(), "")
    return code if code in codes else codes[0]


def add_translations():
    """Register the translations, so that texts appear in the language chosen in FreeCAD."""
    Gui.addLanguagePath(TRANSLATIONS.as_posix())
    # FreeCAD sets its language before it loads any workbench.
    Gui.updateLocale()
