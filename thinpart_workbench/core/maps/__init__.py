# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness maps: the thickness field as it is shown, searched and summed up."""
