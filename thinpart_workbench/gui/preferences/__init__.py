# SPDX-License-Identifier: LGPL-2.1-or-later
"""ThinPart's pages in FreeCAD's preferences."""
