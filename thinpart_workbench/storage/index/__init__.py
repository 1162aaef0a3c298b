# SPDX-License-Identifier: LGPL-2.1-or-later
"""The index of a library: an SQLite file that can be rebuilt from its info files."""
