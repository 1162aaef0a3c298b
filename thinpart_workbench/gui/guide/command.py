# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows the guide: from its command, from FreeCAD's What's This, and from F1 in ThinPart's panels."""

from ..application.qt import QtCore, call_later, translate
from ..widgets.buttons import push_button
from ..widgets.single_dialog import show_single_dialog
from .pages import CONTENTS, PAGE_OF


def show_guide(name="ThinPart_Guide"):
    """Bring the guide to the front, at the page of a command or panel in `PAGE_OF`: GuideWindow."""
    # Imported late, since FreeCAD starts more often than the guide is read.
    from .window import GuideWindow

    window = show_single_dialog(GuideWindow)
    window.show_page(PAGE_OF.get(name, CONTENTS))
    return window


class WhatsThis(QtCore.QObject):
    """Answers FreeCAD's What's This for everything of ThinPart, and F1 for the panel that is open.

    Attributes
    ----------
    panel : str
        The command of the panel in the task view, one of `PAGE_OF`; empty where there is none.

    Notes
    -----
    FreeCAD hands the text of what was clicked to its own main window, which looks for a page of that name in FreeCAD's
    wiki, or asks for an add-on. There is no such page of ThinPart. F1 reaches the main window too where the keyboard acts on
    the view or the tree, as it does after a click on anything of a panel that takes no keys.
    """

    def __init__(self):
        super().__init__()
        self.panel = ""

    def watch(self, main):
        """Watch FreeCAD's main window from now on."""
        main.installEventFilter(self)

    def eventFilter(self, _main, event):
        """Take clicks on what has a page of the guide, and F1 while a panel is open."""
        if event.type() == QtCore.QEvent.ShortcutOverride and self.panel and _is_help_key(event):
            event.accept()
            # Not at the key press, which the 3D view may keep for itself.
            call_later(self, lambda: show_guide(self.panel or "ThinPart_Guide"))
            return True
        if event.type() != QtCore.QEvent.WhatsThisClicked or event.href() not in PAGE_OF:
            return False
        show_guide(event.href())
        return True


def lead_to_guide(roots, name):
    """Let What's This and F1 in a panel or dialog open its page of the guide; `name` is one of `PAGE_OF`."""
    for root in roots if isinstance(roots, list) else [roots]:
        if not root.whatsThis():
            root.setWhatsThis(name)
            root.installEventFilter(_HelpKey(root, name))


def help_button(parent, name):
    """A QPushButton that opens the page of a dialog, as F1 and What's This do in it; `name` is one of `PAGE_OF`."""
    lead_to_guide(parent, name)
    button = push_button(
        parent, "ThinPart_Help", translate("ThinPart", "Help"), lambda: show_guide(name), is_for_enter=False)
    button.setToolTip(translate("ThinPart", "Opens the page of the guide about this (F1)"))
    return button


def _is_help_key(event):
    return event.key() == QtCore.Qt.Key_F1 and event.modifiers() == QtCore.Qt.NoModifier


class _HelpKey(QtCore.QObject):
    """Takes F1 in a panel, before FreeCAD takes it for its own start page of help."""

    def __init__(self, root, name):
        super().__init__(root)
        self._name = name

    def eventFilter(self, _root, event):
        if event.type() not in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress):
            return False
        if not _is_help_key(event):
            return False
        event.accept()
        if event.type() == QtCore.QEvent.KeyPress:
            show_guide(self._name)
        return True
