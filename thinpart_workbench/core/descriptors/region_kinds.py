# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of wall regions. `core/thickness/region_shape` says by which measures a region is of a kind."""

REGION_KINDS = PLATE, TUBE, BAR, BLOCK, TAPER, TOOTH = ("plate", "tube", "bar", "block", "taper", "tooth")
"""A plate is wider than thick, be it flat, bent or a shell; a tube is a plate closed round an axis; a bar is long and about
as wide as thick: a shaft, a wire, a ring; a block is about as long and wide as thick; a taper gets thinner towards one side;
a tooth is a narrow taper on a thicker body: of a gear, a thread."""
