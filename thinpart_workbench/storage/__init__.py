# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files on disk. Imports no packages beyond those of core."""
