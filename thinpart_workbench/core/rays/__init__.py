"""Rays through a mesh: which triangle each of them meets first."""
