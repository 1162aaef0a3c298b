# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of values in files, and the checks compiled from them."""
