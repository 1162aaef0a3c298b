# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export of thickness maps: pictures, and triangles with values."""
