# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a thickness map has, presented in the boxes of its panel: each box has its presenter."""
