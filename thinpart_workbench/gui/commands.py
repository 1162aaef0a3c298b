"""The commands of ThinPart: what the buttons say, when they can be pressed, and one call each."""

import FreeCAD as App
import FreeCADGui as Gui

from ..freecad_adapter.edge import guarded_methods
from .classify import can_classify, classify_active_document
from .classify_folder import show_folder_dialog
from .face_colours import FACE_COLOURS
from .find_parts import toggle_find_parts
from .preferences_pages import show_preferences
from .report import can_report, show_report_dialog
from .show_thickness import can_show_thickness, show_thickness

# Marks a text for translation; FreeCAD translates it by the command's name.
QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP

# FreeCAD greys commands out while a task of others is open, unless they are for editing too: ours say what is in the way.
_BESIDE_TASKS = "AlterDoc;Alter3DView;AlterSelection;ForEdit"


class Classify:
    """Tell whether a part is thin, has thin features or is normal."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_Classify",
            "CmdType": _BESIDE_TASKS,
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_Classify", "Classify part"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_Classify", "Tells whether the selected part is thin, has thin features "
                "or is normal, and colours its thin faces"),
        }

    def IsActive(self):
        """With a document."""
        return can_classify()

    def Activated(self):
        """Classify the part that is meant."""
        classify_active_document()


class ShowThickness:
    """Show in colours how thick the walls of a part are."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_ShowThickness",
            "CmdType": _BESIDE_TASKS,
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_ShowThickness", "Show thickness"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_ShowThickness", "Colours the selected parts, or all of them, by the thickness of "
                "their walls, and tells how much of the surface lies over which wall"),
        }

    def IsActive(self):
        """With a document."""
        return can_show_thickness()

    def Activated(self):
        """Measure what is meant, or show the map that is selected."""
        show_thickness()


class ClassifyFolder:
    """Classify all parts of a folder."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_ClassifyFolder",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_ClassifyFolder", "Classify folder\u2026"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_ClassifyFolder", "Classifies all parts of a folder in the background and "
                "shows them in a table"),
        }

    def IsActive(self):
        """Always."""
        return True

    def Activated(self):
        """Show the dialog."""
        show_folder_dialog()


class Report:
    """Write pages with pictures about the parts of a document."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_Report",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_Report", "Report\u2026"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_Report", "Writes a page with pictures, walls and criteria about every part of the "
                "document, to read, print or hand on"),
        }

    def IsActive(self):
        """With a document."""
        return can_report()

    def Activated(self):
        """Show the dialog."""
        show_report_dialog()


class FindParts:
    """Find parts in libraries."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_FindParts",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_FindParts", "Find parts"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_FindParts", "Shows or hides the panel that finds classified parts by their "
                "category, walls, size and notes, and parts like another one"),
        }

    def IsActive(self):
        """Always."""
        return True

    def Activated(self):
        """Show or hide the panel."""
        toggle_find_parts()


class ClearColours:
    """Take the analysis colours away."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_ClearColours",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_ClearColours", "Clear thin colours"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_ClearColours", "Gives the faces of this document the colours back that "
                "they had before they were coloured as thin"),
        }

    def IsActive(self):
        """While something is coloured."""
        return App.ActiveDocument is not None and FACE_COLOURS.is_shown(App.ActiveDocument)

    def Activated(self):
        """Clear."""
        FACE_COLOURS.clear(App.ActiveDocument)


class Preferences:
    """Open the preferences."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_Preferences",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_Preferences", "ThinPart preferences\u2026"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_Preferences", "Opens the preferences: thresholds, surface mesh, info files, "
                "colours and automatic classification"),
        }

    def IsActive(self):
        """Always."""
        return True

    def Activated(self):
        """Show the first page."""
        show_preferences()


COMMANDS = {
    "ThinPart_Classify": Classify,
    "ThinPart_ShowThickness": ShowThickness,
    "ThinPart_ClassifyFolder": ClassifyFolder,
    "ThinPart_Report": Report,
    "ThinPart_FindParts": FindParts,
    "ThinPart_ClearColours": ClearColours,
    "ThinPart_Preferences": Preferences,
}


def add_commands():
    """Make the commands known to FreeCAD and return their names."""
    for name, command in COMMANDS.items():
        Gui.addCommand(name, guarded_methods("Activated", IsActive=False)(command)())
    return list(COMMANDS)
