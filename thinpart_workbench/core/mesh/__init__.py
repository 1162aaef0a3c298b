"""The surface mesh of a part, and what is computed from its triangles only."""
