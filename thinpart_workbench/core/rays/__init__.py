# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rays through a mesh: which triangle each of them meets first."""
