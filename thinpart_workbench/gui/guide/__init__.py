# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guide in FreeCAD: which page belongs to what, the window that shows it, and FreeCAD's ways to help."""
