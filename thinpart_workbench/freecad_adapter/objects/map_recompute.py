# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hook for recomputed thickness maps, in a module of its own because the map's module imports numpy."""

from ...core.hook import Hook
from ..guard import report_fault

RECOMPUTED = Hook(report_fault)
"""Called after each recompute of a map with the map and whether to measure it again."""
