"""Export of thickness maps: pictures, and triangles with values."""
