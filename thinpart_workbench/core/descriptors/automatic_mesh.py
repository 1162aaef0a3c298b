# SPDX-License-Identifier: LGPL-2.1-or-later
"""The automatic mesh, which Gmsh makes where nobody says a size; and what is small against its elements."""

AUTOMATIC_SHARE = 0.1
"""Greatest element size as a share of the diagonal: Gmsh's own default, and FreeCAD's."""

ELEMENTS_ROUND = 7
"""Elements that Gmsh puts on a circle at least, however small it is: its option ``Mesh.MinimumCircleNodes``."""

SHORT = 0.3
"""An edge is short, and a face narrow, below so much of an element: elements there are three times as long as wide, or
have to shrink."""

TIGHT = 0.25
"""Surface is tightly curved where its radius is below so much of an element."""

FLATTENED = 0.05
"""Flat elements make a curved wall another one where they lie farther from its curve than so much of its thickness: their
nodes of the second order, which are moved there, turn them inside out."""

KNIFE = 30.0
"""Degrees: faces that meet at less inside the material form a knife's edge. Tetrahedra there have such angles too."""
