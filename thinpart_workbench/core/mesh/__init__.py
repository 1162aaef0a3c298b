# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface mesh of a part, and what is computed from its triangles only."""
