# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ThinPart does with documents: the flow, and its consumers."""
