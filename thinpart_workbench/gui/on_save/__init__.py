# SPDX-License-Identifier: LGPL-2.1-or-later
"""Automatic classification of documents when they are saved."""
