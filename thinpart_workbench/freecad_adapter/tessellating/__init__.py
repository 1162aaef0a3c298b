"""Tessellate B-Rep solids."""
