"""How fast ThinPart is, beside FreeCAD's tessellation and other programs that cast rays."""
