# SPDX-License-Identifier: LGPL-2.1-or-later
"""Worker processes: the pool, its messages, JSON lines, temporary folders."""
