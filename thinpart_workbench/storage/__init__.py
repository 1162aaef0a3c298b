"""Files on disk. Imports no packages beyond those of core."""
