"""The names of the colour maps, for what starts without numpy."""

RED_IS_THIN = "red is thin"
"""From dark red over orange, yellow and green to light blue: ThinPart's own. Steps are even, and lightness rises all along,
so that the order is seen without seeing red or green (after Machado, Oliveira, Fernandes 2009,
doi:10.1109/TVCG.2009.113)."""

COLOUR_MAPS = (RED_IS_THIN, "viridis", "cividis", "plasma", "inferno", "magma")
"""Perceptually uniform, and suitable for people with red-green colour blindness."""
