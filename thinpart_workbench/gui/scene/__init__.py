"""Scene graphs and cameras of 3D views: arrays, lines of sight, flights."""
