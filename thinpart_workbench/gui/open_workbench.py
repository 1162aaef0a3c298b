"""Run by ``thinpart gui`` inside FreeCAD: opens the workbench, which is otherwise one in a list."""

import FreeCADGui as Gui

Gui.activateWorkbench("ThinPartWorkbench")
