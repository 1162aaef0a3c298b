# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alias for saved documents, which refer to `WallMeasurement` by this module's name."""

from .objects.wall_measurement import WallMeasurement  # noqa: F401
