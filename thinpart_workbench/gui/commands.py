"""The commands of ThinPart: what the buttons say, when they can be pressed, and one call each."""

import FreeCAD as App
import FreeCADGui as Gui

from .classify import can_classify, classify_active_document
from .classify_folder import show_folder_dialog
from .face_colours import FACE_COLOURS
from .find_parts import toggle_find_parts

# Marks a text for translation; FreeCAD translates it by the command's name.
QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class Classify:
    """Tell whether a part is thin, has thin features or is normal."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_Classify",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_Classify", "Classify part"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_Classify", "Tells whether the selected part is thin, has thin features "
                "or is normal, and colours its thin faces"),
        }

    def IsActive(self):
        """With a document, while no other task is open."""
        return can_classify()

    def Activated(self):
        """Classify the part that is meant."""
        classify_active_document()


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


COMMANDS = {
    "ThinPart_Classify": Classify,
    "ThinPart_ClassifyFolder": ClassifyFolder,
    "ThinPart_FindParts": FindParts,
    "ThinPart_ClearColours": ClearColours,
}


def add_commands():
    """Make the commands known to FreeCAD and return their names."""
    for name, command in COMMANDS.items():
        Gui.addCommand(name, command())
    return list(COMMANDS)
