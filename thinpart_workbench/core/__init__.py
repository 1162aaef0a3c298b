# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measuring and judging a surface mesh. Imports numpy, scipy and the standard library only.

Units inside: mm, mm2, mm3 and radians. ``x`` is always a distance divided by the box diagonal.
"""
