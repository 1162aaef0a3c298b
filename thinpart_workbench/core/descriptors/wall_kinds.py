# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of walls by what lies at their thinnest place."""

PARALLEL, TAPERED, EDGE = WALL_KINDS = ("parallel", "tapered", "edge")
