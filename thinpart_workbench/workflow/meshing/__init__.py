# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volume meshes: how Gmsh meshes parts, and element sizes with which it does."""
