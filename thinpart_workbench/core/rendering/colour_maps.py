# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colour maps, for what starts without numpy: all that are in ``resources/colour_maps.json``."""

import json
from pathlib import Path

RED_IS_THIN = "red is thin"
"""From dark red over orange, yellow and green to light blue: ThinPart's own. Steps are even, and lightness rises all along,
so that the order is seen without seeing red or green (after Machado, Oliveira, Fernandes 2009,
doi:10.1109/TVCG.2009.113)."""

HEX_OF_MAP = json.loads((Path(__file__).resolve().parents[3] / "resources" / "colour_maps.json").read_text("utf-8"))["maps"]
"""Red, green and blue of 256 colours, from the low end on, by the name of the map."""

COLOUR_MAPS = tuple(HEX_OF_MAP)
"""The names. All are perceptually uniform, and suitable for people with red-green colour blindness."""
