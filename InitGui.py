"""Read by FreeCAD's window when it starts: the workbench, its preferences, the document observer."""

import FreeCADGui as Gui

from thinpart_workbench.gui.language import add_translations

add_translations()  # before any text is made
from thinpart_workbench.gui.loaded_copy import is_to_start

# FreeCAD runs this file inside a function that has the path of it in InstallFile.
if is_to_start(locals().get("InstallFile")):
    from thinpart_workbench.freecad_adapter.edge import guarded_methods
    from thinpart_workbench.freecad_adapter.wall_measurement import add_wall_measurement
    from thinpart_workbench.gui.automatic_classification import AUTOMATIC
    from thinpart_workbench.gui.document_observer import observe
    from thinpart_workbench.gui.faults import tell_faults
    from thinpart_workbench.gui.preferences_pages import add_pages
    from thinpart_workbench.gui.show_thickness import follow_requests
    from thinpart_workbench.gui.unit_watch import UNITS
    from thinpart_workbench.gui.workbench import add_icons

    @guarded_methods("Initialize", "Activated")
    class ThinPartWorkbench(Gui.Workbench):
        """The workbench as FreeCAD's list of workbenches shows it."""

        # What is named outside a method of this file cannot be seen in it.
        from thinpart_workbench.gui.workbench import ICONS, MENU_TEXT, TOOL_TIP

        MenuText = MENU_TEXT
        ToolTip = TOOL_TIP
        Icon = f"{ICONS}/thinpart-workbench.svg"

        def Initialize(self):
            """Called when the workbench is first opened."""
            from thinpart_workbench.gui.workbench import initialize

            initialize(self)

        def Activated(self):
            """Called whenever the workbench is opened: a part will soon be measured."""
            from thinpart_workbench.gui.ready_process import READY

            READY.make_soon()

        def GetClassName(self):
            """A workbench written in Python."""
            return "Gui::PythonWorkbench"

    tell_faults()
    Gui.addWorkbench(ThinPartWorkbench())
    add_icons()
    add_pages()
    add_wall_measurement()
    observe()
    AUTOMATIC.begin()
    UNITS.begin()
    follow_requests()
