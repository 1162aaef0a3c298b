"""Parts as solids: their shapes, comparing them, and their placements."""
