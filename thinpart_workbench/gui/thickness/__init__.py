# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command 'Show thickness' and the boxes of its panel."""
