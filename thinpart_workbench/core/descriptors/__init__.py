# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measured quantities of a part: their table, the thickness distribution."""
