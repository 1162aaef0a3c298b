# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles from labels: thresholds and probabilities, and how often the verdicts are right on parts left out."""
