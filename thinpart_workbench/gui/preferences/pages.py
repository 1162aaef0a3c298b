# SPDX-License-Identifier: LGPL-2.1-or-later
"""ThinPart's pages in FreeCAD's preferences."""

import FreeCADGui as Gui

from ...freecad_adapter.guard import guarded_methods
from ...freecad_adapter.preferences import PAGES

GROUP = "ThinPart"


@guarded_methods("loadSettings", "saveSettings")
class _Page:
    """A page in the form that FreeCAD requires: ``form``, ``loadSettings`` and ``saveSettings``.

    FreeCAD creates an instance each time the preferences dialog opens.
    """

    title = ""

    def __init__(self):
        # Imported late: it imports numpy, and the pages are registered when FreeCAD starts.
        from .form import PreferencesForm

        self.form = PreferencesForm(self.title)

    def loadSettings(self):
        """Show the stored preferences."""
        self.form.load()

    def saveSettings(self):
        """Store the preferences on OK or Apply."""
        self.form.save()


def add_pages():
    """Register the pages; called once, when FreeCAD starts."""
    for number, title in enumerate(PAGES):
        # FreeCAD identifies pages by class name.
        page = type(f"ThinPartPreferences{number}", (_Page,), {"title": title})
        Gui.addPreferencePage(page, GROUP)


def show_preferences():
    """Open FreeCAD's preferences on the first page of ThinPart."""
    Gui.showPreferences(GROUP, 0)
