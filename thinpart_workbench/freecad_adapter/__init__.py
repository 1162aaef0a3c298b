# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only package that uses FreeCAD's modules. It never imports FreeCADGui or Qt."""
