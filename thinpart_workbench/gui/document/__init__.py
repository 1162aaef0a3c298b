# SPDX-License-Identifier: LGPL-2.1-or-later
"""The open documents: observers, selection, measurement and the open task panel."""
