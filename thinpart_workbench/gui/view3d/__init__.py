"""Thickness maps in the 3D view."""
