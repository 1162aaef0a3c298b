# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python API that `thinpart_workbench` offers to programs; docs/python.md shows how to use it."""
