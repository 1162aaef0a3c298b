# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read by FreeCAD when it starts, with and without a window. ThinPart adds nothing without one."""
