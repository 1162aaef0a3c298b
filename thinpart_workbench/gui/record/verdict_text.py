# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts about a part's verdict."""

from ...api.window.profiles import known_criteria
from ...api.window.verdicts import between, mesh_risk, paper_sentence, sureness, thinnest, why
from ...core.categories import NORMAL, UNKNOWN
from ..application.numbers import percent
from ..application.qt import translate
from ..application.sentences import translated

_COLOURS = {
    "thin": (0.84, 0.15, 0.12),
    "thin_features": (0.96, 0.60, 0.11),
    NORMAL: (0.24, 0.60, 0.32),
}
_OTHER_COLOUR, _UNKNOWN_COLOUR = (0.30, 0.42, 0.68), (0.55, 0.55, 0.55)


def category_title(category, profile):
    """The title of a category, for people; the profile has those of its own categories."""
    return category_words(category, _title_in(category, profile))


def category_words(category, title):
    """Like `category_title`, for a category with this title in its profile."""
    known = {
        "thin": translate("ThinPart", "Thin part"),
        "thin_features": translate("ThinPart", "Part with thin features"),
        NORMAL: translate("ThinPart", "Normal part"),
        UNKNOWN: translate("ThinPart", "Unknown"),
    }
    return known.get(category) or translated(title)


def category_word(category, profile):
    """A short title of one or two words, for narrow tables; see `category_title`."""
    return short_words(category, _title_in(category, profile))


def short_words(category, title):
    """Like `category_word`, for a category with this title in its profile."""
    known = {
        "thin": translate("ThinPart", "thin"),
        "thin_features": translate("ThinPart", "thin features"),
        NORMAL: translate("ThinPart", "normal"),
        UNKNOWN: translate("ThinPart", "unknown"),
    }
    return known.get(category) or translated(title)


def _title_in(category, profile):
    return next((known.title for known in profile.categories if known.name == category), category)


def headline_text(record, profile):
    """The verdict in a few words; where its probability leaves it open, the two categories between which it is."""
    return verdict_words(record["category"], between(record), profile)


def verdict_words(category, open_between, profile, title=category_title):
    """The same for a category, and the names of those two, none where the verdict is sure; `title` is how one is said."""
    if not open_between:
        return title(category, profile)
    return unsure_words(*(category_word(each, profile) for each in open_between))


def unsure_words(one, other):
    """An unsure verdict, between two short titles."""
    return translate("ThinPart", "Unsure: {} or {}").format(one, other)


def category_colour(category):
    """Red, green and blue of a category's swatch."""
    return _UNKNOWN_COLOUR if category == UNKNOWN else _COLOURS.get(category, _OTHER_COLOUR)


def reason_text(record, unit):
    """One sentence: the criteria that decided the category, with lengths in a unit."""
    found = why(record)
    if found.sentence or record["category"] == UNKNOWN:
        return translated(found.sentence, unit)
    if not found.criteria:
        return translate("ThinPart", "No criterion holds: its walls are thick all over.")
    return translate("ThinPart", "Why: {}").format(", ".join(
        translate("ThinPart", "{} (rule {})").format(_as_part_of_sentence(row["title"]), row["criterion"])
        for row in found.criteria))


def criterion_titles(profile):
    """What people call criteria, by their ids as texts; see `known_criteria`."""
    return {name: translated(title) for name, title in known_criteria(profile).items()}


def _as_part_of_sentence(title):
    known = translated(title)
    # Only English titles become lower-case: nouns of other languages may begin with a capital.
    return known if known != title else title[:1].lower() + title[1:]


def confidence_text(record, profile):
    """How sure the verdict is, and what else the part might be; empty where that is unknown."""
    sure = sureness(record)
    if sure is None:
        return ""
    other = category_title(sure.other, profile)
    if sure.margin is not None:
        margin = percent(sure.margin)
        if not sure.borderline:
            return translate("ThinPart", "Confidence: clear ({} from the limit)").format(margin)
        return translate("ThinPart", "Confidence: borderline, close to '{}' ({} from the limit)").format(other, margin)
    words = (category_title(record["category"], profile), percent(sure.probability), other, percent(sure.other_probability))
    if sure.borderline:
        return translate("ThinPart", "Unsure: '{}' ({}) or '{}' ({})").format(*words)
    return translate("ThinPart", "Probability: {}, next '{}' with {}").format(*words[1:])


def risk_text(record, unit):
    """The risk of the automatic mesh, and what raises it, with lengths in a unit; or why it is unknown."""
    return translated(mesh_risk(record), unit)


def paper_text(record, profile, unit):
    """What the paper would say, with lengths in a unit; empty where the verdict of the profile is the same."""
    return translated(paper_sentence(record, profile), unit)


def holds_text(holds):
    """A symbol and a word for whether a criterion holds; None is unknown."""
    if holds is None:
        return "? " + translate("ThinPart", "unknown")
    return "\u2713 " + translate("ThinPart", "yes") if holds else "\u2717 " + translate(
        "ThinPart", "no")


def marked_thinnest(text, kind, places=1):
    """A text of the thinnest wall, what that is, `kind` as of `thinnest_kind` or None, and how many places are so thin."""
    if (places or 1) > 1:
        words = {"taper": translate("ThinPart", "{} (taper, {}\u00d7)"),
                 "edge": translate("ThinPart", "{} (edge, {}\u00d7)")}
        return words.get(kind, translate("ThinPart", "{} ({}\u00d7)")).format(text, places)
    words = {"taper": translate("ThinPart", "{} (taper)"), "edge": translate("ThinPart", "{} (edge)")}
    return words.get(kind, "{}").format(text)


def thinnest_text(record, unit):
    """Where the part of a record is thinnest, and whether that is a wall, a taper or a sharp edge, as a sentence."""
    return translated(thinnest(record), unit)
