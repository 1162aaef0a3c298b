# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness maps of parts as files."""
