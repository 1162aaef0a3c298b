# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast ThinPart is, beside FreeCAD's tessellation and other programs that cast rays."""
