"""Script that ``thinpart gui`` runs inside FreeCAD to activate the workbench."""

import FreeCADGui as Gui

Gui.activateWorkbench("ThinPartWorkbench")
