# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts as solids: their shapes, comparing them, and their placements."""
