# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of wall regions. `core/thickness/region_shape` says by which measures a region is of a kind."""

import math

REGION_KINDS = PLATE, TUBE, BAR, BLOCK, TAPER, TOOTH = ("plate", "tube", "bar", "block", "taper", "tooth")
"""A plate is wider than thick, be it flat, bent or a shell; a tube is a plate closed round an axis; a bar is long and about
as wide as thick: a shaft, a wire, a ring; a block is about as long and wide as thick; a taper gets thinner towards one side;
a tooth is a narrow taper on a thicker body: of a gear, a thread."""

THREAD = "thread"
"""What people call a ridge that goes round a part."""

THREAD_TURNS = 1.5
"""Length of a ridge, in ways round the part, from which it is a thread."""


THREAD_THICKNESS = 0.2
"""Thickness of a ridge, by the width of the part, up to which it is a thread: a worm of eight modules has 0.17. The walls of
a housing that run into each other have more, however long they are together."""


def is_thread(kind, length, thickness, width):
    """Whether a region of a kind, length and median thickness is a thread of a part whose box has a middle side `width`."""
    return kind == TOOTH and length >= THREAD_TURNS * math.pi * width and thickness <= THREAD_THICKNESS * width


RIB = "rib"
"""What people call a wall that is low and stands on a solid body."""

RIB_UP_TO, RIB_VOLUME = 6.0, 0.1
"""Height, in thicknesses, and share of the volume up to which a wall on a solid body is a rib."""

CORE = 0.4
"""Share of the volume from which bulky regions are the core of a part."""


def is_rib(kind, width, thickness, volume):
    """Whether a region of a kind, width, median thickness and share of the volume, or None, is a rib on the core."""
    return kind == PLATE and width <= RIB_UP_TO * thickness and volume is not None and volume <= RIB_VOLUME


FEWEST_TEETH = 5
"""Equal ridges from which on they are teeth; between screw holes and round corners, a body has a few such walls."""


def called(kind, count):
    """The kind of so many equal regions as people call it: a few teeth are tapers."""
    return TAPER if kind == TOOTH and count < FEWEST_TEETH else kind
