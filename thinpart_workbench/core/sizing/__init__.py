"""Element sizes that follow the thickness of walls."""
