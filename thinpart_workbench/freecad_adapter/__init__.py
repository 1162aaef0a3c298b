"""The only place that knows FreeCAD's modules. Never imports FreeCADGui or Qt."""
