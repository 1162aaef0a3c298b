"""Texts about a part's verdict."""

from ...core.categories import NORMAL, UNKNOWN
from ...core.judging.criteria import PAPER, load_profile
from ...core.judging.verdict_reasons import deciding_criteria, nearest_other, reason_of
from ...core.judging.verdict_sentence import verdict_sentence
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
    """The title of a category, for people.

    Parameters
    ----------
    category : str
    profile : Profile
        Supplies the titles of its own categories.
    """
    titles = {known.name: known.title for known in profile.categories}
    return category_words(category, titles.get(category, category))


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


def reason_text(record, unit):
    """One sentence: the criteria that decided the category, with lengths in a unit."""
    if record["category"] == UNKNOWN:
        return translated(reason_of(record), unit)
    sentence = verdict_sentence(record)
    if sentence is not None:
        return translated(sentence, unit)
    deciding = deciding_criteria(record)
    if not deciding:
        return translate("ThinPart", "No criterion holds: its walls are thick all over.")
    return translate("ThinPart", "Why: {}").format(", ".join(
        translate("ThinPart", "{} (rule {})").format(_as_part_of_sentence(row["title"]), row["criterion"])
        for row in deciding))


def criterion_titles(profile):
    """What people call criteria, by their ids as texts: those of a profile, and of the ones that come with ThinPart.

    Results that were judged by another profile name its criteria.
    """
    return {str(criterion.id): translated(criterion.title)
            for known in (load_profile(PAPER), load_profile(), profile) for criterion in known.criteria}


def _as_part_of_sentence(title):
    known = translated(title)
    # Only English titles become lower-case: nouns of other languages may begin with a capital.
    return known if known != title else title[:1].lower() + title[1:]


def confidence_text(record, profile):
    """How sure the verdict is, and what else the part might be; empty where that is unknown."""
    if record["margin"] is None:
        return ""
    if "probabilities" in record:
        return _probability_text(record, profile)
    margin = percent(record["margin"])
    if not record["borderline"]:
        return translate("ThinPart", "Confidence: clear ({} from the limit)").format(margin)
    other = category_title(nearest_other(record), profile)
    return translate("ThinPart", "Confidence: borderline, close to '{}' ({} from the limit)").format(other, margin)


def _probability_text(record, profile):
    chances = {each["category"]: each["probability"] for each in record["probabilities"]}
    own = record["category"]
    other = max((each for each in chances if each != own), key=chances.get)
    words = (category_title(own, profile), percent(chances[own]), category_title(other, profile), percent(chances[other]))
    if record["borderline"]:
        return translate("ThinPart", "Unsure: '{}' ({}) or '{}' ({})").format(*words)
    return translate("ThinPart", "Probability: {}, next '{}' with {}").format(*words[1:])


def paper_text(record, profile):
    """The verdict by the paper's own thresholds; empty where the profile is the paper's."""
    if profile.name == PAPER:
        return ""
    paper = record["paper"]
    title = category_title(paper["category"], load_profile(PAPER))
    if not paper["criteria"]:
        return translate("ThinPart", "By the thresholds of the paper: {}").format(title)
    return translate("ThinPart", "By the thresholds of the paper: {} (criteria {})").format(
        title, ", ".join(map(str, paper["criteria"])))


def holds_text(holds):
    """A symbol and a word for whether a criterion holds; None is unknown."""
    if holds is None:
        return "? " + translate("ThinPart", "unknown")
    return "\u2713 " + translate("ThinPart", "yes") if holds else "\u2717 " + translate(
        "ThinPart", "no")
