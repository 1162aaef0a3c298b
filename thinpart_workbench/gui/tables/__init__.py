# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of rows: one model, whose rows are kept here or fetched when they are shown, and one view of it."""
