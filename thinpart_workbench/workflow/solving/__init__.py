# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elastic frequencies of parts by CalculiX, and how far those of the automatic mesh are off."""
