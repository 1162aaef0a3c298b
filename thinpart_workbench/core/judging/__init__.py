# SPDX-License-Identifier: LGPL-2.1-or-later
"""Criteria, categories, verdicts and their reasons. Nothing is measured here."""
