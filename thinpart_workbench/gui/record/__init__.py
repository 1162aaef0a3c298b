"""Widgets and texts that show part records."""
