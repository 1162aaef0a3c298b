"""The only package that uses FreeCAD's modules. It never imports FreeCADGui or Qt."""
