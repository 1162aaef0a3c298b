"""What ThinPart adds to FreeCAD's window. Draws and listens; it measures and judges nothing."""
