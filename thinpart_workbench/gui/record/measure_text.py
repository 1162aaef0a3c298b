"""What the measures of thickness maps are called, and what their values say."""

from ...core.analysis_settings import RAY, SPHERE
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
    ]


def value_title(measure):
    """What a value is called, as a title."""
    return translate("ThinPart", "Largest ball") if measure == SPHERE else translate("ThinPart", "Wall")


def value_title_in(measure, symbol):
    """The title of values in a unit."""
    title = translate("ThinPart", "Largest ball, {}") if measure == SPHERE else translate("ThinPart", "Wall thickness, {}")
    return title.format(symbol)


def plain_title(measure):
    """The title of values without a unit."""
    return translate("ThinPart", "Largest ball") if measure == SPHERE else translate("ThinPart", "Wall thickness")


def axis_title(measure, symbol):
    """The title of an axis that shows values in a unit and as a share of the diagonal."""
    title = translate("ThinPart", "{}, and share of the diagonal")
    if measure == SPHERE:
        title = translate("ThinPart", "Largest ball in {}, and share of the diagonal")
    return title.format(symbol)


def share_sentence(measure, share, value):
    """How much of the area lies over values under a bound; both are texts."""
    sentence = translate("ThinPart", "{} of the area has walls thinner than {}")
    if measure == SPHERE:
        sentence = translate("ThinPart", "On {} of the area the largest ball is smaller than {}")
    return sentence.format(share, value)


def here_sentence(measure, value):
    """The value under the cursor, a text."""
    sentence = translate("ThinPart", "Largest ball here: {}") if measure == SPHERE else translate("ThinPart", "Here: {}")
    return sentence.format(value)
