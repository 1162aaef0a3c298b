# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog that classifies a folder."""
