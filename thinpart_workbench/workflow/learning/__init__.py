"""Profiles from labels: thresholds and probabilities, and how often the verdicts are right on parts left out."""
