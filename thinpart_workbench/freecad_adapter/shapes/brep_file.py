# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes in BREP files."""

import os


def write_brep(shape, path):
    """Write a Part.Shape; raises OSError, which unlike FreeCAD's own exception says that a disk is full."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(shape.exportBrepToString())


def read_brep(path):
    """The Part.Shape of a file; raises FreeCAD's own exceptions, which differ between versions."""
    import Part

    shape = Part.Shape()
    shape.read(os.fspath(path))
    return shape
