"""ThinPart's pages in FreeCAD's preferences."""

import FreeCADGui as Gui

from ..freecad_adapter.edge import guarded_methods
from ..freecad_adapter.settings import PAGES

GROUP = "ThinPart"


@guarded_methods("loadSettings", "saveSettings")
class _Page:
    """What FreeCAD wants of a page: ``form``, ``loadSettings`` and ``saveSettings``.

    FreeCAD makes one each time its dialog opens.
    """

    title = ""

    def __init__(self):
        # Not at the top: it brings numpy, and the pages are known when FreeCAD starts.
        from .preferences_form import PreferencesForm

        self.form = PreferencesForm(self.title)

    def loadSettings(self):
        """Show what is kept."""
        self.form.load()

    def saveSettings(self):
        """OK or Apply."""
        self.form.save()


def add_pages():
    """Make the pages known; called once, when FreeCAD starts."""
    for number, title in enumerate(PAGES):
        # FreeCAD knows pages by the names of their classes.
        page = type(f"ThinPartPreferences{number}", (_Page,), {"title": title})
        Gui.addPreferencePage(page, GROUP)


def show_preferences():
    """Open FreeCAD's preferences with the first of the pages."""
    Gui.showPreferences(GROUP, 0)
