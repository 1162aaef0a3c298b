"""A part's verdict in words."""

from ..core.categories import NORMAL, UNKNOWN
from ..core.number_text import bound_text, number, percent  # noqa: F401 - the panels take them from here
from ..core.verdict_reasons import deciding_criteria, nearest_other
from .qt import translate
from .sentences import translated

_COLOURS = {
    "thin": (0.84, 0.15, 0.12),
    "thin_features": (0.96, 0.60, 0.11),
    NORMAL: (0.24, 0.60, 0.32),
}
_OTHER_COLOUR, _UNKNOWN_COLOUR = (0.30, 0.42, 0.68), (0.55, 0.55, 0.55)


def category_title(category, profile):
    """A category in plain words.

    Parameters
    ----------
    category : str
    profile : Profile
        Gives the words of categories of its own.
    """
    titles = {each.name: each.title for each in profile.categories}
    return category_words(category, titles.get(category, category))


def category_words(category, title):
    """As `category_title`, of a category that has this title in its profile."""
    known = {
        "thin": translate("ThinPart", "Thin part"),
        "thin_features": translate("ThinPart", "Part with thin features"),
        NORMAL: translate("ThinPart", "Normal part"),
        UNKNOWN: translate("ThinPart", "Unknown"),
    }
    return known.get(category) or translated(title)


def category_word(category, profile):
    """A category in a word or two, for narrow tables; see `category_title`."""
    known = {
        "thin": translate("ThinPart", "thin"),
        "thin_features": translate("ThinPart", "thin features"),
        NORMAL: translate("ThinPart", "normal"),
        UNKNOWN: translate("ThinPart", "unknown"),
    }
    return known.get(category) or category_title(category, profile)


def category_colour(category):
    """Red, green and blue of a category's swatch."""
    return _UNKNOWN_COLOUR if category == UNKNOWN else _COLOURS.get(category, _OTHER_COLOUR)


def why(record):
    """One sentence: what decided."""
    if record["category"] == UNKNOWN:
        return translated(record["reason"])
    deciding = deciding_criteria(record)
    if not deciding:
        return translate("ThinPart", "No criterion holds: its walls are thick all over.")
    return translate("ThinPart", "Why: {}").format(", ".join(
        translate("ThinPart", "{} (rule {})").format(_as_part_of_sentence(row["title"]), row["criterion"])
        for row in deciding))


def _as_part_of_sentence(title):
    known = translated(title)
    # In other languages it stands in quotes, since their nouns may begin with a capital.
    return known if known != title else title[:1].lower() + title[1:]


def how_sure(record, profile):
    """How far the verdict lies from another one, in words; empty where it is not known."""
    if record["margin"] is None:
        return ""
    margin = percent(record["margin"])
    if not record["borderline"]:
        return translate("ThinPart", "Confidence: clear ({} from the limit)").format(margin)
    other = category_title(nearest_other(record), profile)
    return translate("ThinPart", "Confidence: borderline, close to '{}' ({} from the limit)").format(other, margin)


def holds_text(holds):
    """A symbol and a word for whether something holds."""
    if holds is None:
        return "? " + translate("ThinPart", "unknown")
    return "\u2713 " + translate("ThinPart", "yes") if holds else "\u2717 " + translate(
        "ThinPart", "no")
