# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mid-surface of a solid, as faces that are made of its own and trimmed by it."""
