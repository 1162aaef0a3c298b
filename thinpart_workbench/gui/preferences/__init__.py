"""ThinPart's pages in FreeCAD's preferences."""
