# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saved documents reference `ThicknessView` by this module; the class is in `gui.view3d.view_provider`."""

from .view3d.view_provider import ThicknessView  # noqa: F401
