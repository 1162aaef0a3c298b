# SPDX-License-Identifier: LGPL-2.1-or-later
"""The flow for one file, and runs over many files."""
