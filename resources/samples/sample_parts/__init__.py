# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sample parts that are bundled with ThinPart, built from FreeCAD objects.

FreeCAD must have been loaded: importing Part before it can crash.

Lengths are in mm. In the comments *diag* is the diagonal of the part's minimum bounding box, *x* a
thickness divided by it, and a *wedge* is a pair of faces that meet at 10 to 55 degrees with material
between them. These are the quantities the criteria are about, so they explain most of the dimensions.
"""
