"""Criteria, categories, verdicts and their reasons. Nothing is measured here."""
