# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls through the shape itself, and not through a mesh."""
