"""Files of other programs: Gmsh scripts and meshes, VTK and PLY."""
