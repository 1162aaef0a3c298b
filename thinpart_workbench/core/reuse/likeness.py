# SPDX-License-Identifier: LGPL-2.1-or-later
"""What two parts are to each other, judged by how their surfaces lie upon each other."""

from ..forms.laying import SAME

IDENTICAL, MIRRORED, SCALED, ALIKE = KINDS = ("identical", "mirrored", "scaled", "alike")
"""Kinds of likeness, the closest first."""

SAME_SIZE = 2e-3
"""Share by which lengths may differ of parts of one size: triangles of a round part have less area than it."""

SAME_MEASURE, SAME_MEASURE_OF_TRIANGLES = 3e-3, 2e-2
"""Shares by which volumes and areas of one form differ at most, since facets of another fineness lie otherwise."""

KNOWN_SCALES = (25.4, 10.0, 100.0, 1000.0, 2.54)
"""Factors by which units differ, and their inverses; a scale near one of them is that one."""

WHOLE = 0.95
"""Share of both surfaces that is the same in parts of one form, by outlines: points of triangles lie beside the surface."""

FACE_SAME = 0.5
"""Share of the points of a face that are the same where the face is."""

LIKE = 0.6
"""Share of both surfaces that is the same in parts that are alike but for something."""

MOST_APART, MOST_APART_OF_TRIANGLES = 1e-3, 3e-2
"""Greatest distance of two surfaces that are the same, as a share of the extent: a point may lie beside a trimmed face, and
triangles of a round face far below it."""


def known_scale(scale):
    """A scale as people know it: 1, one of `KNOWN_SCALES` or its inverse where it is near that, else as it is."""
    for known in (1.0, *KNOWN_SCALES, *(1.0 / each for each in KNOWN_SCALES)):
        if abs(scale / known - 1.0) <= SAME_SIZE:
            return known
    return scale


def kind_of(laid, is_whole):
    """The kind of likeness of two parts, one of `KINDS`, or None where they have little in common.

    Parameters
    ----------
    laid : Laid
    is_whole : bool
        Whether they have one form.
    """
    if not is_whole:
        return ALIKE if laid.least_share >= LIKE else None
    if laid.motion.scale != 1.0:
        return SCALED
    return MIRRORED if laid.motion.is_mirrored else IDENTICAL


def is_much_nearer(laid, than, extent):
    """Whether outlines lie much nearer to each other in one way than in another, of a part of an extent in mm."""
    most = 4.0 * SAME * extent
    return laid.apart(most) < 0.5 * than.apart(most) - 2e-5 * extent


def is_whole(compared):
    """Whether two parts are of one form, by what was found face by face: dict as `comparison_task.ANSWER`."""
    most = MOST_APART if compared["are_solids"] else MOST_APART_OF_TRIANGLES
    return all(side["greatest_mm"] <= most * compared["extent_mm"]
               and all(face["share"] >= FACE_SAME for face in side["faces"])
               for side in (compared["part"], compared["reference"]))


def has_same_measures(part, reference, scale, are_solids):
    """Whether volume and area of two parts agree.

    Parameters
    ----------
    part, reference : object with ``volume_mm3``, None where that is not known, and ``area_mm2``
    scale : float
        Factor by which the part is scaled.
    are_solids : bool
        Whether neither is made of triangles.
    """
    known = part.volume_mm3 is not None and reference.volume_mm3 is not None
    pairs = [(part.area_mm2 * scale ** 2, reference.area_mm2), *(
        [(part.volume_mm3 * scale ** 3, reference.volume_mm3)] if known else [])]
    most = SAME_MEASURE if are_solids else SAME_MEASURE_OF_TRIANGLES
    return all(abs(own - other) <= most * other for own, other in pairs)


def is_whole_by_outlines(laid):
    """Whether two outlines are of one form."""
    return laid.least_share >= WHOLE
