# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the measures of thickness maps are called, and what their values say."""

from ...core.analysis_settings import LOCAL, RAY, SPHERE
from ..application.qt import translate


def measure_choices():
    """The measures as a user chooses them: list of (measure, title, tool tip)."""
    return [
        (RAY, translate("ThinPart", "Across the wall (ray)"), translate(
            "ThinPart", "How far it is from each point of the surface straight through the material to the other side. "
            "Verdicts are always judged by it.")),
        (SPHERE, translate("ThinPart", "Largest ball inside (sphere)"), translate(
            "ThinPart", "The diameter of the largest ball that fits into the material and touches the surface at each "
            "point. It is no larger than the wall across and does not see past the next face: at sharp edges it goes "
            "down to nothing. It takes longer.")),
        (LOCAL, translate("ThinPart", "Local thickness"), translate(
            "ThinPart", "The diameter of the largest ball that fits into the material and reaches each point. Edges are as "
            "thick as the walls that meet there; ribs, teeth, threads and run-outs have a thickness of their own.")),
    ]


def value_title(measure):
    """What a value is called, as a title."""
    return translate("ThinPart", "Wall") if measure == RAY else plain_title(measure)


def value_title_in(measure, symbol):
    """The title of values in a unit."""
    return {RAY: translate("ThinPart", "Wall thickness, {}"), SPHERE: translate("ThinPart", "Largest ball, {}"),
            LOCAL: translate("ThinPart", "Local thickness, {}")}[measure].format(symbol)


def plain_title(measure):
    """The title of values without a unit."""
    return {RAY: translate("ThinPart", "Wall thickness"), SPHERE: translate("ThinPart", "Largest ball"),
            LOCAL: translate("ThinPart", "Local thickness")}[measure]


def axis_title(measure, symbol):
    """The title of an axis that shows values in a unit and as a share of the diagonal."""
    return {RAY: translate("ThinPart", "{}, and share of the diagonal"),
            SPHERE: translate("ThinPart", "Largest ball in {}, and share of the diagonal"),
            LOCAL: translate("ThinPart", "Local thickness in {}, and share of the diagonal")}[measure].format(symbol)


def share_sentence(measure, share, value):
    """How much of the area lies over values under a bound; both are texts."""
    sentences = {RAY: translate("ThinPart", "{} of the area has walls thinner than {}"),
                 SPHERE: translate("ThinPart", "On {} of the area the largest ball is smaller than {}"),
                 LOCAL: translate("ThinPart", "On {} of the area the local thickness is less than {}")}
    return sentences[measure].format(share, value)


def here_sentence(measure, value):
    """The value under the cursor, a text."""
    return {RAY: translate("ThinPart", "Here: {}"), SPHERE: translate("ThinPart", "Largest ball here: {}"),
            LOCAL: translate("ThinPart", "Local thickness here: {}")}[measure].format(value)
