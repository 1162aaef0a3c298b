"""The FreeCAD commands of ThinPart: texts, when they are enabled, and the function that each calls."""

import FreeCAD as App
import FreeCADGui as Gui

from ..freecad_adapter.guard import guarded_methods
from .application import lifelong
from .classify.command import can_classify, classify_active_document
from .folder.command import show_folder_dialog
from .guide.command import show_guide
from .learning.command import show_learn_dialog
from .library.command import toggle_find_parts
from .mesh_sizes.command import can_prepare_mesh, prepare_mesh
from .preferences.pages import show_preferences
from .profile.command import show_profile_editor
from .report.command import can_report, show_report_dialog
from .thickness.command import can_show_thickness, show_thickness

# Marks a text for translation; FreeCAD translates it in the context of the command's name.
QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP

# FreeCAD disables commands while another task is open, unless they have the type ForEdit.
# These stay enabled and show which task blocks them.
_ENABLED_DURING_TASKS = "AlterDoc;Alter3DView;AlterSelection;ForEdit"


class Classify:
    """Classify a part as thin, with thin features, or normal."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_Classify",
            "Accel": "T, C",
            "CmdType": _ENABLED_DURING_TASKS,
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_Classify", "Classify part"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_Classify", "Checks whether the selected part is thin, has thin features or is normal, and "
                                     "colours its thin faces"),
        }

    def IsActive(self):
        """With a document."""
        return can_classify()

    def Activated(self):
        """Classify the selected or active part."""
        classify_active_document()


class ShowThickness:
    """Colour parts by their wall thickness."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_ShowThickness",
            "Accel": "T, W",
            "CmdType": _ENABLED_DURING_TASKS,
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_ShowThickness", "Show thickness"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_ShowThickness", "Colours the selected parts, or all of them, by the thickness of their "
                                          "walls, and shows how the area is distributed over thickness"),
        }

    def IsActive(self):
        """With a document."""
        return can_show_thickness()

    def Activated(self):
        """Measure the selected parts, or all, or show the selected thickness map."""
        show_thickness()


class MeshSizes:
    """Propose element sizes for a part, and make its FEM mesh."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_MeshSizes",
            "Accel": "T, M",
            "CmdType": _ENABLED_DURING_TASKS,
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_MeshSizes", "Prepare mesh"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_MeshSizes", "Proposes element sizes that give the thin walls of the selected part enough layers, "
                                      "and makes a FEM mesh with them"),
        }

    def IsActive(self):
        """With a document."""
        return can_prepare_mesh()

    def Activated(self):
        """Propose sizes for the selected or active part."""
        prepare_mesh()


class ClassifyFolder:
    """Classify all parts of a folder."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_ClassifyFolder",
            "Accel": "T, F",
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
    """Write a report with pictures about the parts of a document."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_Report",
            "Accel": "T, R",
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
            "Accel": "T, P",
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


class EditProfile:
    """Edit the thresholds that parts are judged by."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_EditProfile",
            "Accel": "T, E",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_EditProfile", "Edit profile\u2026"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_EditProfile", "Edits the thresholds by which parts are judged, and the limits of the wall, and "
                "counts meanwhile what would change in your libraries"),
        }

    def IsActive(self):
        """Always."""
        return True

    def Activated(self):
        """Show the editor."""
        show_profile_editor()


class LearnThresholds:
    """Learn thresholds from labels."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_LearnThresholds",
            "Accel": "T, L",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_LearnThresholds", "Learn thresholds\u2026"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_LearnThresholds", "Chooses thresholds that agree with what people say of the parts of a library, "
                "and says how good they are on folders left out"),
        }

    def IsActive(self):
        """Always."""
        return True

    def Activated(self):
        """Show the dialog."""
        show_learn_dialog()


class ClearColours:
    """Remove the analysis colours."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_ClearColours",
            "Accel": "T, X",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_ClearColours", "Clear thin colours"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_ClearColours", "Restores the colours that the faces of this document had before they were "
                                         "coloured as thin"),
        }

    def IsActive(self):
        """While the active document has analysis colours."""
        return App.ActiveDocument is not None and lifelong.face_colours.is_shown(App.ActiveDocument)

    def Activated(self):
        """Remove the colours."""
        lifelong.face_colours.clear(App.ActiveDocument)


class Preferences:
    """Open the preferences."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_Preferences",
            "Accel": "T, O",
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


class Guide:
    """Open the guide."""

    def GetResources(self):
        """Icon, text and tool tip."""
        return {
            "Pixmap": "ThinPart_Guide",
            "Accel": "T, H",
            "MenuText": QT_TRANSLATE_NOOP("ThinPart_Guide", "ThinPart guide"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "ThinPart_Guide", "Opens the guide: a page for each job, with pictures and examples"),
        }

    def IsActive(self):
        """Always."""
        return True

    def Activated(self):
        """Show its contents."""
        show_guide()


COMMANDS = {
    "ThinPart_Classify": Classify,
    "ThinPart_ShowThickness": ShowThickness,
    "ThinPart_MeshSizes": MeshSizes,
    "ThinPart_ClassifyFolder": ClassifyFolder,
    "ThinPart_Report": Report,
    "ThinPart_FindParts": FindParts,
    "ThinPart_EditProfile": EditProfile,
    "ThinPart_LearnThresholds": LearnThresholds,
    "ThinPart_ClearColours": ClearColours,
    "ThinPart_Preferences": Preferences,
    "ThinPart_Guide": Guide,
}


def add_commands():
    """Register the commands with FreeCAD and return their names."""
    for name, command in COMMANDS.items():
        Gui.addCommand(name, guarded_methods("Activated", IsActive=False)(command)())
    return list(COMMANDS)
