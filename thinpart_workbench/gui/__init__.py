# SPDX-License-Identifier: LGPL-2.1-or-later
"""The FreeCAD GUI of ThinPart. It displays results and handles input; measuring and classifying is done elsewhere."""
