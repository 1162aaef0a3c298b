"""Read by FreeCAD when it starts, with and without a window. ThinPart adds nothing without one."""
