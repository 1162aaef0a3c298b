# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of a thickness map with its colour bar, drawn without a graphics card."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..errors import ThinPartError
from ..length_unit import MILLIMETRE, UNITS
from ..maps.level_cuts import cut_at_levels, within_steps
from ..maps.map_summary import typical_range
from ..message import message
from .camera import FROM_BEHIND, ISOMETRIC, framing, looking_from
from .colour_maps import COLOUR_MAPS
from .colour_scale import ColourScale
from .part_views import DARKEST
from .picture import draw
from .pixel_text import HEIGHT as TEXT_HEIGHT
from .pixel_text import text_mask

VIEWS = {
    "isometric": ISOMETRIC, "behind": FROM_BEHIND,
    **{name: looking_from(np.array(towards, dtype=np.float64)) for name, towards in (
        ("front", (0, -1, 0)), ("rear", (0, 1, 0)), ("left", (-1, 0, 0)), ("right", (1, 0, 0)), ("top", (0, 0, 1)),
        ("bottom", (0, 0, -1)))},
}
"""Axes of the camera, see `Camera`, by the name of the view."""

LEAST_SIDE, MOST_SIDE = 64, 8192
"""Bounds of the width and the height of a picture, pixels."""

INK = (30, 30, 30)
_PAPER = 255
_TICKS = 5


@dataclass(frozen=True)
class MapLook:
    """How a map is coloured and drawn, of plain values.

    Attributes
    ----------
    colour_map : str
        One of `colour_maps.COLOUR_MAPS`.
    reversed, logarithmic : bool
    bands : int
        See `ColourScale`.
    low, high : float or None, mm
        Ends of the range; None for those that the window would choose.
    unit : str
        Of the numbers beside the colour bar, one of `UNITS`.
    view : str
        One of `VIEWS`.
    width, height : int
        Pixels.
    """

    colour_map: str = COLOUR_MAPS[0]
    reversed: bool = False
    logarithmic: bool = False
    bands: int = 0
    low: Optional[float] = None
    high: Optional[float] = None
    unit: str = MILLIMETRE.symbol
    view: str = "isometric"
    width: int = 1600
    height: int = 1200

    def scale(self, part):
        """The ColourScale of a MappedPart; ThinPartError of kind ``empty`` where it has no walls."""
        ends = typical_range([part])
        if ends is None:
            raise ThinPartError(message("No wall of {part} could be measured: there is nothing to colour.",
                                        part=part.record["label"]), "empty")
        low = ends[0] if self.low is None else self.low
        high = ends[1] if self.high is None else self.high
        return ColourScale(low, max(low, high), self.colour_map, self.reversed, self.bands, logarithmic=self.logarithmic)


def map_picture(part, look):
    """Draw the map of a part, lit and with edges, on white, with the colour bar beside it.

    Returns an ndarray of shape (height, width, 4), uint8.
    """
    shown, scale = part.map, look.scale(part)
    bar = _bar(scale, UNITS[look.unit], look.height)
    width = max(look.width - bar.shape[1], 1)
    steps, thickness, corners, normals = scale.steps, shown.corner_thickness, shown.corners, shown.normals
    if steps:
        # Cut where the colour changes: between the colours of two corners, others would be invented.
        cuts = cut_at_levels(shown, steps)
        whole = np.ones(shown.count, dtype=bool)
        whole[cuts.facet] = False
        thickness = within_steps(np.concatenate([thickness[whole], cuts.thickness]), steps)
        corners = np.concatenate([corners[whole], cuts.at_corners(corners)])
        normals = np.concatenate([normals[whole], normals[cuts.facet]])
    colours = scale.colours(thickness.ravel()).reshape(-1, 3, 3) / 255.0
    corners = corners + shown.origin
    camera = framing(shown.points + shown.origin, VIEWS[look.view], width, look.height)
    drawn = draw(corners, normals, colours, camera, not part.record["descriptors"]["watertight"], DARKEST)
    share = drawn[:, :, 3:] / 255.0
    pixels = np.full((look.height, look.width, 4), _PAPER, dtype=np.uint8)
    pixels[:, :width, :3] = np.round(share * drawn[:, :, :3] + (1.0 - share) * _PAPER)
    pixels[:, width:, :3] = bar[:, :look.width - width]
    return pixels


def _bar(scale, unit, height):
    """The colour bar with its numbers, the thickest wall on top: ndarray of shape (height, n, 3), uint8."""
    enlarged = max(1, height // 300)
    texts = [text_mask(unit.text(thickness), enlarged)
             for thickness in scale.thickness_at(np.linspace(0.0, 1.0, _TICKS))]
    gap, own = 4 * enlarged, TEXT_HEIGHT * enlarged
    thick, widest = 12 * enlarged, max(each.shape[1] for each in texts)
    pixels = np.full((height, gap + thick + 2 * gap + widest + gap, 3), _PAPER, dtype=np.uint8)
    top, bottom = 2 * own, height - 2 * own
    shares = (bottom - 0.5 - np.arange(top, bottom)) / max(bottom - top, 1)
    pixels[top:bottom, gap:gap + thick] = scale.bar(shares)[:, None]
    for edge in (top, bottom - 1):
        pixels[edge, gap:gap + thick] = INK
    pixels[top:bottom, [gap, gap + thick - 1]] = INK
    for number, mask in enumerate(texts):
        row = round(bottom - 1 - (bottom - 1 - top) * number / (_TICKS - 1))
        pixels[row, gap + thick:gap + thick + gap] = INK
        left, first = gap + thick + 2 * gap, row - own // 2
        pixels[first:first + own, left:left + mask.shape[1]][mask] = INK
    return pixels
