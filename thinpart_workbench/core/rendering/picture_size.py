# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size of small pictures; apart from what draws them, which takes numpy."""

WIDTH, HEIGHT = 160, 120
"""Pixels."""
