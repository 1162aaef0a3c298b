# SPDX-License-Identifier: LGPL-2.1-or-later
"""Learn a profile from labelled parts, and say how good it is."""

import datetime
from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Optional

import numpy as np

from ...core.errors import ThinPartError
from ...core.judging.classification import classify
from ...core.judging.criteria import load_profile, profile_from
from ...core.judging.probability import ProbabilityModel
from ...core.judging.threshold_search import ThresholdSearch
from ...core.message import message
from .fit_probabilities import ProbabilityFit, check_scikit_learn
from .labels import SECOND_ANSWER, Disagreement, categories_of, disagreement
from .validation import Scores, folds, scores, share_of

LEAST_LABELS = 10
"""Parts of each category without which nothing is learned."""

FOLDERS, PARTS = "folders", "parts"
"""What is left out in turn in the validation."""


@dataclass(frozen=True)
class Change:
    """A condition of the start, and what became of it.

    Attributes
    ----------
    category : str
    criterion : str
    before : str
        Such as "K[0;0.12] > 0.7".
    after : str or None
        None where it was left out.
    """

    category: str
    criterion: str
    before: str
    after: Optional[str]


@dataclass(frozen=True)
class LearnedProfile:
    """A profile learned from labels, and how good it is.

    Attributes
    ----------
    content : dict
        Of the profile.
    start : str
        Name of the profile that it was learned from.
    people : tuple of str
    counts : dict of str to int
        Labelled parts by category.
    disagreement : Disagreement
    changes : tuple of Change
        Every condition of the start.
    before : Scores
        Of the start.
    after : Scores
        Of profiles that were learned in the same way without the parts that they judge.
    left_out : str
        What these parts are: ``folders``, or ``parts`` where all are in one folder.
    folds : int
        How many profiles these are.
    """

    content: Mapping
    start: str
    people: tuple
    counts: Mapping
    disagreement: Disagreement
    changes: tuple
    before: Scores
    after: Scores
    left_out: str
    folds: int

    @property
    def is_better(self):
        """bool: whether it agrees with labels on more of the parts left out than the start does."""
        return self.after.either.count > self.before.either.count

    def as_dict(self):
        """All as JSON values."""
        return asdict(self)


def learn_profile(parts, start, name, report=None):
    """Learn thresholds and probabilities: LearnedProfile.

    Raises ThinPartError, kind ``usage`` where labels are too few; ``unsupported`` without scikit-learn.

    Parameters
    ----------
    parts : list of LabelledPart
    start : Profile
        Its categories, criteria and quantities are taken.
    name : str
        Of the new profile.
    report : callable, optional
        Called with the number of profiles learned and to be learned; may raise to stop.
    """
    check_scikit_learn()
    categories = categories_of(start)
    counts = Counter(part.category for part in parts)
    _check_counts(counts, categories)
    groups, left_out = [part.group for part in parts], FOLDERS
    if len(set(groups)) < 2:
        groups, left_out = [f"{part.file} {part.part}" for part in parts], PARTS
    outs = folds(groups)
    report = report or (lambda done, total: None)
    report(0, 1 + len(outs))
    learner = _Learner(parts, start, categories)
    learned = learner.learned(np.ones(len(parts), bool))
    after = [None] * len(parts)
    for done, out in enumerate(outs, start=1):
        report(done, 1 + len(outs))
        profile = learner.learned(~out).profile
        for number in np.flatnonzero(out):
            after[number] = classify(parts[number].descriptors, profile)
    before = [classify(part.descriptors, start) for part in parts]
    people = tuple(sorted({person for part in parts for person in part.answers}))
    content = {**learned.profile.content, "name": name, "title": name, "source": _source(parts, people, start.name)}
    return LearnedProfile(
        profile_from(content).content, start.name, people, {each: counts[each] for each in categories}, disagreement(parts),
        tuple(_change(*each) for each in learned.conditions),
        scores(parts, before, categories), scores(parts, after, categories), left_out, len(outs))


class _Learner:
    """Learns from any of the parts; what is measured is measured once."""

    def __init__(self, parts, start, categories):
        descriptors = [part.descriptors for part in parts]
        worth = np.zeros((len(parts), len(categories)))
        for row, part in zip(worth, parts):
            row[categories.index(part.category)] = part.weight
            if part.second is not None:
                row[categories.index(part.second)] = SECOND_ANSWER * part.weight
        self._worth = worth
        self._weight = np.array([part.weight for part in parts])
        self._search = ThresholdSearch(start, descriptors)
        model = _model_to_fit(start)
        self._fit = None if model is None else ProbabilityFit(
            model, descriptors, worth / worth.sum(axis=1, keepdims=True) * self._weight[:, None], start.area_floor)

    def learned(self, chosen):
        """The `FoundProfile` of the chosen parts, ndarray of bool, with probabilities."""
        found = self._search.best(self._worth * chosen[:, None])
        if self._fit is None:
            return found
        return found._replace(profile=profile_from({**found.profile.content, "probability": self._fit.content(chosen)}))


def _model_to_fit(start) -> Optional[ProbabilityModel]:
    """The start's model, or that of the default profile where it is of the same categories."""
    if start.probability is not None:
        return start.probability
    default = load_profile()
    names = [[category.name for category in profile.categories] for profile in (start, default)]
    return default.probability if names[0] == names[1] else None


def _check_counts(counts, categories):
    none = [category for category in categories if not counts[category]]
    if none:
        raise ThinPartError(
            message("No part is labelled {categories}: label at least {needed} parts of every category.",
                    categories=", ".join(none), needed=LEAST_LABELS), "usage")
    few = [category for category in categories if counts[category] < LEAST_LABELS]
    if few:
        chance = share_of([True] * LEAST_LABELS).low
        raise ThinPartError(
            message("There are too few labels: {counts}. At least {needed} parts of every category are needed: even if the "
                    "verdicts on so few were all right, only {percent:.0f} % right could be claimed with confidence.",
                    counts=", ".join(f"{category} {counts[category]}" for category in few), needed=LEAST_LABELS,
                    percent=100 * chance), "usage")


def _change(criterion, before, after):
    return Change(criterion.category, str(criterion.id), before.text, None if after is None else after.text)


def _source(parts, people, start):
    return message("Learned on {date} from labels of {count} parts by {people}, starting at the profile {start}",
                   date=datetime.date.today().isoformat(), count=len(parts), people=", ".join(people), start=start)
