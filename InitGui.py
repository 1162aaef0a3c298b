# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by FreeCAD when its GUI starts: registers the workbench and starts its application-wide objects."""

import FreeCADGui as Gui

from thinpart_workbench.gui.application.language import add_translations

add_translations()  # before any text is made
from thinpart_workbench.gui.loaded_copy import is_to_start  # noqa: E402

# FreeCAD runs this file inside a function that has the path of it in InstallFile.
if is_to_start(locals().get("InstallFile")):
    from thinpart_workbench.freecad_adapter.guard import guarded_methods
    from thinpart_workbench.gui.start import start

    @guarded_methods("Initialize", "Activated")
    class ThinPartWorkbench(Gui.Workbench):
        """The workbench as FreeCAD's list of workbenches shows it."""

        # Imported here, because FreeCAD runs this file so that outer names are not visible inside the class.
        from thinpart_workbench.gui.workbench import ICONS, MENU_TEXT, TOOL_TIP

        MenuText = MENU_TEXT
        ToolTip = TOOL_TIP
        Icon = f"{ICONS}/thinpart-workbench.svg"

        def Initialize(self):
            """Called when the workbench is first opened."""
            from thinpart_workbench.gui.workbench import initialize

            initialize(self)

        def Activated(self):
            """Called whenever the workbench is activated: prepare the worker process for the first measurement."""
            from thinpart_workbench.gui.application import lifelong

            lifelong.standby_worker.prepare_next()

        def GetClassName(self):
            """A workbench written in Python."""
            return "Gui::PythonWorkbench"

    start()
    Gui.addWorkbench(ThinPartWorkbench())
