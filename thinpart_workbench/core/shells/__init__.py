# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shells: which faces make a wall, the mesh of its middle, and how thick it is there."""
