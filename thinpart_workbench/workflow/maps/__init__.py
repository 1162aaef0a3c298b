"""Thickness maps of parts as files."""
