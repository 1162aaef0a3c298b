# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness maps in the 3D view."""
