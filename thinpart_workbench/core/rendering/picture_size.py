"""Size of small pictures; apart from what draws them, which takes numpy."""

WIDTH, HEIGHT = 160, 120
"""Pixels."""
