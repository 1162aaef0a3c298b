# SPDX-License-Identifier: LGPL-2.1-or-later
"""Differences between Linux, macOS and Windows, one topic per module; independent of parts."""
