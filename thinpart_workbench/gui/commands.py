# SPDX-License-Identifier: LGPL-2.1-or-later
"""The FreeCAD commands of ThinPart as one table: texts, shortcuts, when each is enabled, and what it opens."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

import FreeCAD as App
import FreeCADGui as Gui

from ..freecad_adapter.guard import guarded_methods
from .application import lifelong
from .document.active_task import CLASSIFICATION, MESH_SIZES, THICKNESS, begin_session
from .widgets.single_dialog import show_single_dialog

# Marks a text for translation; FreeCAD translates it in the context of the command's name.
QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP

# FreeCAD disables commands while another task is open, unless they have the type ForEdit.
# Those of panels stay enabled and show which task blocks them.
_ENABLED_DURING_TASKS = "AlterDoc;Alter3DView;AlterSelection;ForEdit"


def always():
    """A command that is always enabled: True."""
    return True


def has_document():
    """Whether a document is open."""
    return App.ActiveDocument is not None


def has_colours():
    """Whether the active document has analysis colours."""
    return has_document() and lifelong.face_colours.is_shown(App.ActiveDocument)


def clear_colours():
    """Remove the analysis colours of the active document."""
    lifelong.face_colours.clear(App.ActiveDocument)


@guarded_methods("Activated", IsActive=False)
@dataclass(frozen=True)
class Command:
    """One command; FreeCAD calls its methods.

    Attributes
    ----------
    name : str
        Also that of its icon, and the context of its texts.
    keys : str
        Shortcut.
    text, tool_tip : str
        Marked for translation.
    opens : str
        ``module:name`` in this package: a function; the class of a dialog, of which one is shown; or where ``task`` is
        given, the controller of a panel. It is imported when the command is used, because numpy would slow down the start
        of FreeCAD.
    is_enabled : callable
        Returns a bool.
    task : str
        Kind of the session that it begins.
    """

    name: str
    keys: str
    text: str
    tool_tip: str
    opens: str
    is_enabled: Callable[[], bool] = always
    task: str = ""

    def GetResources(self):
        """Icon, shortcut, text, tool tip and type."""
        resources = {"Pixmap": self.name, "Accel": self.keys, "MenuText": self.text, "ToolTip": self.tool_tip}
        return {**resources, "CmdType": _ENABLED_DURING_TASKS} if self.task else resources

    def IsActive(self):
        """Whether it is enabled."""
        return self.is_enabled()

    def Activated(self):
        """Open what it opens."""
        module, _, name = self.opens.partition(":")
        opened = getattr(import_module(f".{module}", __package__), name)
        if not isinstance(opened, type):
            opened()
        elif self.task:
            begin_session(self.task, opened, App.ActiveDocument)
        else:
            show_single_dialog(opened)


COMMANDS = {each.name: each for each in (
    Command(
        "ThinPart_Classify", "T, C", QT_TRANSLATE_NOOP("ThinPart_Classify", "Classify part"),
        QT_TRANSLATE_NOOP("ThinPart_Classify", "Checks whether the selected part is thin, has thin features or is normal,"
                                               " and colours its thin faces"),
        "classify.controller:ClassificationController", has_document, CLASSIFICATION),
    Command(
        "ThinPart_ShowThickness", "T, W", QT_TRANSLATE_NOOP("ThinPart_ShowThickness", "Show thickness"),
        QT_TRANSLATE_NOOP("ThinPart_ShowThickness", "Colours the selected parts, or all of them, by the thickness of "
                                                    "their walls, and shows how the area is distributed over thickness"),
        "thickness.command:show_thickness", has_document, THICKNESS),
    Command(
        "ThinPart_MeshSizes", "T, M", QT_TRANSLATE_NOOP("ThinPart_MeshSizes", "Prepare mesh"),
        QT_TRANSLATE_NOOP("ThinPart_MeshSizes", "Proposes element sizes that give the thin walls of the selected part "
                                                "enough layers, and makes a FEM mesh with them"),
        "mesh_sizes.controller:MeshSizesController", has_document, MESH_SIZES),
    Command(
        "ThinPart_ClassifyFolder", "T, F", QT_TRANSLATE_NOOP("ThinPart_ClassifyFolder", "Classify folder\u2026"),
        QT_TRANSLATE_NOOP("ThinPart_ClassifyFolder", "Classifies all parts of a folder in the background and shows them "
                                                     "in a table"),
        "folder.dialog:FolderDialog"),
    Command(
        "ThinPart_Report", "T, R", QT_TRANSLATE_NOOP("ThinPart_Report", "Report\u2026"),
        QT_TRANSLATE_NOOP("ThinPart_Report", "Writes a page with pictures, walls and criteria about every part of the "
                                             "document, to read, print or hand on"),
        "report.dialog:show_report_dialog", has_document),
    Command(
        "ThinPart_FindParts", "T, P", QT_TRANSLATE_NOOP("ThinPart_FindParts", "Find parts"),
        QT_TRANSLATE_NOOP("ThinPart_FindParts", "Shows or hides the panel that finds classified parts by their category, "
                                                "walls, size and notes, and parts like another one"),
        "library.command:toggle_find_parts"),
    Command(
        "ThinPart_EditProfile", "T, E", QT_TRANSLATE_NOOP("ThinPart_EditProfile", "Edit profile\u2026"),
        QT_TRANSLATE_NOOP("ThinPart_EditProfile", "Edits the thresholds by which parts are judged, and the limits of the "
                                                  "wall, and counts meanwhile what would change in your libraries"),
        "profile.command:show_profile_editor"),
    Command(
        "ThinPart_LearnThresholds", "T, L", QT_TRANSLATE_NOOP("ThinPart_LearnThresholds", "Learn thresholds\u2026"),
        QT_TRANSLATE_NOOP("ThinPart_LearnThresholds", "Chooses thresholds that agree with what people say of the parts of"
                                                      " a library, and says how good they are on folders left out"),
        "learning.dialog:LearnDialog"),
    Command(
        "ThinPart_ClearColours", "T, X", QT_TRANSLATE_NOOP("ThinPart_ClearColours", "Clear thin colours"),
        QT_TRANSLATE_NOOP("ThinPart_ClearColours", "Restores the colours that the faces of this document had before they "
                                                   "were coloured as thin"),
        "commands:clear_colours", has_colours),
    Command(
        "ThinPart_Preferences", "T, O", QT_TRANSLATE_NOOP("ThinPart_Preferences", "ThinPart preferences\u2026"),
        QT_TRANSLATE_NOOP("ThinPart_Preferences", "Opens the preferences: thresholds, surface mesh, info files, colours "
                                                  "and automatic classification"),
        "preferences.pages:show_preferences"),
    Command(
        "ThinPart_Guide", "T, H", QT_TRANSLATE_NOOP("ThinPart_Guide", "ThinPart guide"),
        QT_TRANSLATE_NOOP("ThinPart_Guide", "Opens the guide: a page for each job, with pictures and examples"),
        "guide.command:show_guide"),
)}
"""By their names, in the order of the toolbar and the menu."""


def add_commands():
    """Register the commands with FreeCAD and return their names."""
    for name, command in COMMANDS.items():
        Gui.addCommand(name, command)
    return list(COMMANDS)
