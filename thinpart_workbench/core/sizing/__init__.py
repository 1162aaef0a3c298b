# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element sizes that follow the thickness of walls."""
