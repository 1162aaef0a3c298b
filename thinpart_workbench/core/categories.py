# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two categories that no profile defines; importable without numpy."""

NORMAL, UNKNOWN = "normal", "unknown"
"""Parts for which no criterion holds; parts that could not be measured well enough to decide."""

MEASURE_AGAIN = "measure_again"
"""Stands for the category of a stored part that lacks a quantity, because an earlier version measured it."""
