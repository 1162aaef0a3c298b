# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of `solver_truth`: how often the automatic mesh is in trouble, by label and by verdict, and what foretells it."""

from collections import Counter
from dataclasses import asdict, dataclass

import numpy as np

from benchmarks.table_text import MISSING, Table, percent
from thinpart_workbench.core.categories import NORMAL
from thinpart_workbench.core.descriptors.descriptor_table import QUANTITIES, STATED_FLOOR, quantity_named
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.foretelling import area_interval, area_under_curve, foretellings
from thinpart_workbench.workflow.learning.labels import LabelledPart
from thinpart_workbench.workflow.learning.validation import share_of
from thinpart_workbench.workflow.solving.automatic_mesh import NO_MESH, NOT_SOLVED, SOLVED, AutomaticMesh
from thinpart_workbench.workflow.solving.mesh_trouble import ERROR, has_trouble, is_refused

CATEGORIES = ("thin", "thin_features", NORMAL)

SHARES = ("K[0;0.08]", "K[0;0.12]", "K[0;0.15]", "P[0;0.06]", "F[0;0.05]", "F[0;0.1]", "L[0;0.08]", "L[0;0.12]")
"""Quantities that are compared beside those of the table and of the profiles' conditions."""

ERRORS = (0.02, ERROR, 0.06, 0.1)
"""Errors of the frequencies that may be allowed."""

MOST_QUANTITIES = 12
"""Rows of the table of single quantities."""

@dataclass(frozen=True)
class SolvedPart:
    """A labelled part, what became of its automatic mesh, and what profiles call it.

    Attributes
    ----------
    part : LabelledPart
    truth : AutomaticMesh
    verdicts : tuple of Classification
        One for each profile.
    """

    part: LabelledPart
    truth: AutomaticMesh
    verdicts: tuple

    @property
    def trouble(self):
        """bool or None: whether there is no mesh that can be solved, or its frequencies are off; see `has_trouble`."""
        return has_trouble(self.truth)

    @property
    def strict_trouble(self):
        """bool or None: the same where a mesh that the solver refuses as it is made is in trouble too."""
        return True if is_refused(self.truth) else self.trouble

    def row(self, profiles):
        """All of it as JSON values, dict.

        Parameters
        ----------
        profiles : list of Profile
            Those of the verdicts.
        """
        return {
            "file": self.part.file, "repository": self.part.group, "label": self.part.category, "sure": self.part.is_sure,
            "second": self.part.second, "trouble": self.trouble, "strict_trouble": self.strict_trouble,
            "verdicts": {profile.name: {"category": verdict.category, "probabilities": verdict.probabilities}
                         for profile, verdict in zip(profiles, self.verdicts)},
            "quantities": {quantity.symbol: quantity.evaluate(self.part.descriptors, STATED_FLOOR)
                           for quantity in quantities(profiles)},
            "truth": asdict(self.truth)}


def solved_part(part, truth, profiles):
    """The SolvedPart of a LabelledPart and its AutomaticMesh, judged by profiles."""
    return SolvedPart(part, truth, tuple(classify(part.descriptors, profile) for profile in profiles))


def quantities(profiles):
    """The quantities that are compared, list of Quantity: of the table, `SHARES`, and those of the profiles' conditions."""
    named = [*(each for each in QUANTITIES if each.keys), *map(quantity_named, SHARES),
             *(condition.quantity for profile in profiles for criterion in profile.criteria
               for condition in criterion.conditions)]
    return list({each.symbol: each for each in named}.values())


def groupings(parts, profiles):
    """How parts are divided: list of (title, list of (group, list of SolvedPart)), groups in the order of `CATEGORIES`."""
    sure = [part for part in parts if part.part.is_sure]
    return [
        ("label, sure", _by(sure, lambda each: each.part.category)),
        ("label, all", _by(parts, lambda each: each.part.category)),
        *((f"verdict, {profile.name}", _by(parts, lambda each, number=number: each.verdicts[number].category))
          for number, profile in enumerate(profiles))]


def _by(parts, category_of):
    return [(category, [part for part in parts if category_of(part) == category]) for category in CATEGORIES]


def tables(parts, profiles):
    """Yield all tables.

    Parameters
    ----------
    parts : list of SolvedPart
    profiles : list of Profile
        Those of their verdicts.
    """
    known = [part for part in parts if part.trouble is not None]
    yield Table(f"What became of {len(parts)} automatic meshes, of {len({each.part.group for each in parts})} repositories",
                ["outcome", "parts"], _outcomes(parts))
    yield Table(
        f"Trouble with the automatic mesh, {len(known)} parts",
        ["", "group", "parts", "in trouble", "95 %", "median error", "in trouble or refused as made"],
        [[title if number == 0 else "", group.replace("_", " "), len(members), *_trouble(members)]
         for title, groups in groupings(known, profiles) for number, (group, members) in enumerate(groups)])
    yield Table(f"In trouble, by the error that is allowed; verdicts of {profiles[0].name}",
                ["error allowed", *(group.replace("_", " ") for group in CATEGORIES), "area under the curve"],
                [[percent(error, 0), *_by_error(parts, error)] for error in ERRORS])
    yield Table("How well trouble is foretold: area under the receiver operating characteristic, with its interval of 95 %",
                ["by", "trouble", "or refused as made"], _foretold(parts, profiles))


def _outcomes(parts):
    counts = Counter(map(_outcome, parts))
    return [[outcome, counts[outcome]] for outcome in (*_OUTCOMES.values(), _OFF, _GOOD, _OPEN, _UNKNOWN) if counts[outcome]]


_OUTCOMES = {NO_MESH: "no mesh", NOT_SOLVED: "refused by the solver in any form"}
_OFF, _GOOD = f"off by more than {percent(ERROR, 0)}", f"within {percent(ERROR, 0)}"
_OPEN, _UNKNOWN = "left out: its reference is not converged", "left out: not known"


def _outcome(part):
    if part.trouble is None:
        return _OPEN if part.truth.outcome == SOLVED else _UNKNOWN
    return _OUTCOMES.get(part.truth.outcome) or (_OFF if part.trouble else _GOOD)


def _trouble(parts):
    share = share_of([part.trouble for part in parts])
    strict = share_of([part.strict_trouble for part in parts])
    errors = [part.truth.error for part in parts if part.truth.error is not None]
    if not parts:
        return [MISSING] * 4
    return [f"{share.count}, {percent(share.count / share.total, 0)}",
            f"{percent(share.low, 0)} to {percent(share.high, 0)}",
            percent(float(np.median(errors)) if errors else None), percent(strict.count / strict.total, 0)]


def _by_error(parts, error):
    """How many of each verdict are in trouble, by the first profile; and how well the verdict foretells it."""
    known = [(part.verdicts[0].category, flag) for part in parts
             for flag in (has_trouble(part.truth, error),) if flag is not None]
    for group in CATEGORIES:
        share = share_of([flag for category, flag in known if category == group])
        yield f"{share.count} of {share.total}, {percent(share.count / share.total, 0)}" if share.total else MISSING
    yield _area(*_split([float(category != NORMAL) for category, _ in known], [flag for _, flag in known]))


def _foretold(parts, profiles):
    readings = [[part for part in parts if part.trouble is not None],
                [part for part in parts if part.strict_trouble is not None]]
    flags = [[part.trouble for part in readings[0]], [part.strict_trouble for part in readings[1]]]
    sources = [
        ("label, sure parts only", lambda each: float(each.part.category != NORMAL) if each.part.is_sure else None),
        ("label", lambda each: float(each.part.category != NORMAL))]
    for number, profile in enumerate(profiles):
        sources.append((f"verdict, {profile.name}",
                        lambda each, number=number: float(each.verdicts[number].category != NORMAL)))
        if any(part.verdicts[number].probabilities for part in parts):
            sources.append((f"stated probability of not normal, {profile.name}",
                            lambda each, number=number: _not_normal(each.verdicts[number])))
    rows = [[title, *(_area(*_split(map(source, members), of)) for members, of in zip(readings, flags))]
            for title, source in sources]
    by_reading = [{each.symbol: each for each in foretellings([part.part.descriptors for part in members], of,
                                                              quantities(profiles))}
                  for members, of in zip(readings, flags)]
    units = {each.symbol: each.unit for each in quantities(profiles)}
    without_unit = [symbol for symbol in by_reading[0] if not units[symbol]
                    and not any(other.startswith(f"{symbol}[") for other in by_reading[0])]
    for symbol in without_unit[:MOST_QUANTITIES]:
        found = by_reading[0][symbol]
        strict = by_reading[1].get(symbol)
        rows.append([f"{symbol}, {'low' if found.is_low else 'high'}",
                     f"{found.area:.2f} ({found.low:.2f} to {found.high:.2f})",
                     MISSING if strict is None else
                     f"{strict.area if strict.is_low == found.is_low else 1.0 - strict.area:.2f}"])
    return rows


def _not_normal(verdict):
    return None if verdict.probabilities is None else 1.0 - verdict.probabilities[NORMAL]


def _split(values, flags):
    """Values of parts in trouble, and of others, two ndarrays; those that are not known are left out."""
    known = [(value, flag) for value, flag in zip(values, flags) if value is not None]
    return tuple(np.array([value for value, flag in known if flag == wanted]) for wanted in (True, False))


def _area(yes, no):
    if not len(yes) or not len(no):
        return MISSING
    area = area_under_curve(yes, no)
    low, high = area_interval(area, len(yes), len(no))
    return f"{area:.2f} ({low:.2f} to {high:.2f})"
