# SPDX-License-Identifier: LGPL-2.1-or-later
"""Info files: their definition, reading and writing, and the annotations in them."""
