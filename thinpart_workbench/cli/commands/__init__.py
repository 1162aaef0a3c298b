# SPDX-License-Identifier: LGPL-2.1-or-later
"""One module per command, with its options and its `run` function."""
