# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene graphs and cameras of 3D views: arrays, lines of sight, flights."""
