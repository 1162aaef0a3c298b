# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command 'Prepare mesh': element sizes for a part, and its FEM mesh."""
