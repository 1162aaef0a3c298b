"""A part's verdict in words."""

from ..core.categories import NORMAL, UNKNOWN
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
        UNKNOWN: translate("ThinPart", "Not known"),
    }
    return known.get(category) or translated(title)


def category_colour(category):
    """Red, green and blue of a category's swatch."""
    return _UNKNOWN_COLOUR if category == UNKNOWN else _COLOURS.get(category, _OTHER_COLOUR)


def why(record):
    """One sentence: what decided."""
    if record["category"] == UNKNOWN:
        return translated(record["reason"])
    deciding = [row for row in record["evidence"]
                if row["holds"] and row["category"] == record["category"]]
    if not deciding:
        return translate("ThinPart", "No criterion holds: its walls are thick all over.")
    named = "; ".join(translate("ThinPart", "{}, {}").format(
        row["criterion"], _as_part_of_sentence(row["title"])) for row in deciding)
    if len(deciding) == 1:
        return translate("ThinPart", "It meets criterion {}.").format(named)
    return translate("ThinPart", "It meets criteria {}.").format(named)


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
        return translate("ThinPart", "Clear verdict: margin {}").format(margin)
    other = category_title(nearest_other(record), profile)
    return translate("ThinPart", "Borderline, close to '{}': margin {}").format(other, margin)


def nearest_other(record):
    """The category that the part would get if the quantity nearest its threshold passed it."""
    rows, own = record["evidence"], record["category"]
    deciding = [row["margin"] for row in rows if row["holds"] and row["category"] == own]
    before = rows
    if deciding:
        first = next(index for index, row in enumerate(rows) if row["category"] == own)
        before = rows[:first]
    nearly = [row for row in before if row["holds"] is False and row["margin"] is not None]
    nearest = max(nearly, key=lambda row: row["margin"], default=None)
    if nearest is not None and (not deciding or -nearest["margin"] <= max(deciding)):
        return nearest["category"]
    later = rows[len(before):]
    return next((row["category"] for row in later if row["holds"] and row["category"] != own),
                NORMAL)


def holds_text(holds):
    """A symbol and a word for whether something holds."""
    if holds is None:
        return "? " + translate("ThinPart", "unknown")
    return "\u2713 " + translate("ThinPart", "yes") if holds else "\u2717 " + translate(
        "ThinPart", "no")


def percent(share):
    """A share as people read it; empty for None, and 0 below a twentieth of a percent."""
    if share is None:
        return ""
    value = 100.0 * share
    if abs(value) >= 1000.0:
        return ">999\u00a0%" if value > 0 else "<\u2212999\u00a0%"
    # Sums of shares may end a rounding below 0.
    value = 0.0 if abs(value) < 0.05 else value
    digits = 0 if abs(value) >= 9.95 or value == 0.0 else 1
    return f"{value:.{digits}f}\u00a0%".replace("-", "\u2212")


def number(value):
    """A quantity with three significant digits, never in powers of ten unless it is tiny."""
    if value is None:
        return "\u2013"
    return f"{value:.0f}" if abs(value) >= 1000.0 else f"{value:.3g}"
