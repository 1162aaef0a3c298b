# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of other programs: Gmsh scripts and meshes, VTK and PLY."""
