# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart map``: the thickness map of a part as a picture, or as triangles with values."""

import argparse
import os

from ...api.file_run import write_map
from ...core.errors import ThinPartError
from ...core.foreign_text import json_text, printable
from ...core.kinds.file_marks import MAPS
from ...core.length_unit import MILLIMETRE, UNITS
from ...core.message import message
from ...core.rendering.colour_maps import COLOUR_MAPS
from ...core.rendering.map_picture import LEAST_SIDE, MOST_SIDE, VIEWS, MapLook
from ...core.run_control import RunControl
from ...storage.exchange.map_export import MAP_FORMATS
from ..output_options import add_output_option, replacing
from ..run_options import add_limit_options, add_measurement_options, limits_of, settings_of, shown_measure_of
from ..stop_signals import stop_signals

_FORMATS = {"png": "a picture, with the colour bar", **{ending[1:]: each.use for ending, each in MAP_FORMATS.items()}}


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("path", metavar="PART", help="a part; FreeCAD documents and STEP files may hold several, see --part")
    for name, what in _FORMATS.items():
        ending = f".{name}"
        add_output_option(parser, f"--{name}", mark={ending: MAPS[ending]}, metavar="FILE", help=f"write {what}")
    parser.add_argument("--part", metavar="NAME", help="name or label of the part, where the document has several")
    parser.add_argument("--view", choices=tuple(VIEWS), default=MapLook.view,
                        help="where the picture is seen from (default: %(default)s)")
    parser.add_argument("--pixels", type=_pixels, default=(MapLook.width, MapLook.height), metavar="WxH",
                        help=f"width and height of the picture (default: {MapLook.width}x{MapLook.height})")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"),
                        help="ends of the colours, in --unit (default: those of the window, from the thinnest wall to the "
                             "one that 98 %% of the surface is thinner than)")
    parser.add_argument("--colours", choices=COLOUR_MAPS, default=COLOUR_MAPS[0], help="default: %(default)s")
    parser.add_argument("--reversed", action="store_true", help="thin walls get the colours of thick ones")
    parser.add_argument("--logarithmic", action="store_true", help="equal ratios of thickness are equally far apart")
    parser.add_argument("--bands", type=int, default=0, metavar="N", help="colours in N steps (default: smooth)")
    parser.add_argument("--unit", choices=tuple(UNITS), default=MILLIMETRE.symbol,
                        help="of the picture, of --range and of what is printed (default: %(default)s); .vtp and .ply are "
                             "in mm")
    parser.add_argument("--json", action="store_true", help="print what was found as JSON, in mm")
    add_measurement_options(parser, has_pictures=True)
    add_limit_options(parser)


def run(options):
    """Make the map and return the exit status."""
    files = _files(options)
    unit, control = UNITS[options.unit], RunControl()
    with stop_signals(control):
        found = write_map(
            options.path, files, part=options.part, look=_look(options, unit), measure=shown_measure_of(options),
            profile=options.profile, settings=settings_of(options), limits=limits_of(options), control=control,
            **replacing(options))
    if options.json:
        print(json_text({**found, "files": files}))
    else:
        # Terminals that cannot show the space before a unit would print its code.
        thinnest, low, high = (unit.text(found[name]).replace("\u00a0", " ") for name in ("thinnest", "low", "high"))
        at = f" ({found['thinnest_at']})" if found["thinnest_at"] else ""
        print(printable(f"{found['label']}: thinnest wall {thinnest}{at}, colours from {low} to {high}."))
        print(printable(f"Written: {', '.join(files)}"))
    return 0


def _files(options):
    """The files that are asked for, each with the ending of its option."""
    files = []
    for name in _FORMATS:
        file = getattr(options, name)
        if file is not None:
            if os.path.splitext(file)[1].lower() != f".{name}":
                raise ThinPartError(message("{file} is no name for a file of {option}: give it the ending .{ending}.",
                                            file=file, option=f"--{name}", ending=name), "usage")
            files.append(file)
    if not files:
        raise ThinPartError(message("Name what to write: --png FILE, --vtp FILE or --ply FILE."), "usage")
    return files


def _look(options, unit):
    low, high = options.range or (None, None)
    if options.range and not 0.0 <= low < high < float("inf"):
        raise ThinPartError(message("--range takes the thinner wall first, then the thicker: not {low} and {high}.",
                                    low=f"{low:g}", high=f"{high:g}"), "usage")
    if not 0 <= options.bands <= 64:
        raise ThinPartError(message("--bands takes a number from 0, for smooth colours, to 64."), "usage")
    low, high = (None if end is None else end * unit.millimetres for end in (low, high))
    return MapLook(options.colours, options.reversed, options.logarithmic, options.bands, low, high, options.unit,
                   options.view, *options.pixels)


def _pixels(text):
    """A width and a height."""
    try:
        width, height = map(int, text.lower().split("x"))
    except ValueError:
        width = height = 0
    if not (LEAST_SIDE <= width <= MOST_SIDE and LEAST_SIDE <= height <= MOST_SIDE):
        raise argparse.ArgumentTypeError(
            f"'{text}' is not allowed: --pixels takes a width and a height from {LEAST_SIDE} to {MOST_SIDE}, as 1600x1200.")
    return width, height
