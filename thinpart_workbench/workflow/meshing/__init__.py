"""Volume meshes: how Gmsh meshes parts, and element sizes with which it does."""
