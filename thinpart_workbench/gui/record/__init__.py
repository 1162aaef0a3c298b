# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets and texts that show part records."""
