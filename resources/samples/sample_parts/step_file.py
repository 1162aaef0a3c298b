# SPDX-License-Identifier: LGPL-2.1-or-later
"""A STEP file that the same FreeCAD writes again byte by byte."""

import re

import Part


def write_step(shape, path, name):
    """Write a shape, without the date, its products named after the part.

    Parameters
    ----------
    shape : Part.Shape
    path : str
    name : str
    """
    # Without the edges' curves in the faces' parameters, which readers compute themselves: less than
    # half the size.
    Part.setStaticValue("write.surfacecurve.mode", 0)
    shape.exportStep(path)
    with open(path, encoding="ascii") as file:
        text = file.read()
    text = re.sub(r"'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d'", "'2000-01-01T00:00:00'", text, count=1)
    # The writer calls them "Open CASCADE STEP translator 7.6 1", with a number that depends on how many
    # files were written before.
    default = r"'Open CASCADE STEP translator [\d.]+ \d+((?:\.\d+)*)'"
    text = re.sub(default, lambda match: f"'{name}{match.group(1).replace('.', ' ')}'", text)
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(text)
