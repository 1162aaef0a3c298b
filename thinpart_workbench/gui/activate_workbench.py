# SPDX-License-Identifier: LGPL-2.1-or-later
"""Script that ``thinpart gui`` runs inside FreeCAD to activate the workbench."""

import FreeCADGui as Gui

if not __package__:  # FreeCAD imports the script by its bare name; as a module of ThinPart it does nothing
    Gui.activateWorkbench("ThinPartWorkbench")
