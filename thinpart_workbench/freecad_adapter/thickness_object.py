# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alias for saved documents, which refer to `ThicknessObject` by this module's name."""

from .objects.thickness_object import ThicknessObject  # noqa: F401
