#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How often ThinPart's verdict is an engineer's: on a folder of real parts with labels.

    /usr/bin/python3 benchmarks/agreement.py [--parts FOLDER] [--profile NAME] [--info-dir FOLDER] [--markdown]

The folder has `manifest.csv`, a row per part with the columns file, source_repo, expert_label, confidence ("sure" or not)
and alt_label (a second answer that is right too, or empty). By default it is $THINPART_TRAINING, or shared/training beside
the checkout. Nothing is written there.

What a profile reaches on the parts that its thresholds were chosen on says little. So the thresholds are also chosen anew,
and the probabilities fitted anew (scikit-learn), without the repository of the parts that they judge: for each repository
in turn, and for fifths of the repositories, divided in several ways.
"""

import argparse
import csv
import itertools
import os
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.ndimage import gaussian_filter

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, os.fspath(ROOT))

import thinpart_workbench as thinpart  # noqa: E402
from benchmarks.table_text import Table, markdown, plain, titled  # noqa: E402
from thinpart_workbench.core.categories import UNKNOWN  # noqa: E402
from thinpart_workbench.core.descriptors.descriptor_table import quantity_named  # noqa: E402
from thinpart_workbench.core.judging.classification import classify  # noqa: E402
from thinpart_workbench.core.judging.criteria import load_profile, profile_from  # noqa: E402
from thinpart_workbench.core.record.part_record import descriptors_of  # noqa: E402
from thinpart_workbench.workflow.learning.fit_probabilities import ProbabilityFit, check_scikit_learn  # noqa: E402
from thinpart_workbench.workflow.learning.labels import UNSURE, LabelledPart  # noqa: E402
from thinpart_workbench.workflow.learning.validation import reliability, scores, truth_of  # noqa: E402

CATEGORIES = ("thin", "thin_features", "normal")
LEFT_OUT = "chosen without the repository"
FIFTHS, DIVISIONS = 5, 4

WIDTHS = {"walls": (0.1, 0.12, 0.15), "places": (0.04, 0.05, 0.06, 0.08), "tapers": (0.06, 0.08, 0.1)}
"""Thicknesses by D2 up to which a wall counts, that are tried."""

LIMITS = {
    "walls": (0.6, 0.65, 0.7, 0.75, 0.8), "plates": (0.5, 0.55, 0.6),
    "places": (0.005, 0.01, 0.02, 0.03), "tapers": (0.05, 0.08, 0.1, 0.12, 0.15, 1.0),
}
"""Shares of the surface, and plate ratios, that are tried; a share of 1 leaves a condition out."""


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--parts", type=Path, default=default_folder(), metavar="FOLDER")
    parser.add_argument("--profile", default="calibrated", metavar="NAME-or-FILE")
    parser.add_argument("--info-dir", metavar="FOLDER", help="keeps what was measured there for the next run")
    parser.add_argument("--markdown", action="store_true", help="tables as in docs/method.md")
    options = parser.parse_args()
    if options.parts is None or not (options.parts / "manifest.csv").is_file():
        print("There is no folder with a manifest.csv: name one with --parts.", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as temporary:
        parts = labelled_parts(options.parts, options.profile, options.info_dir or temporary)
    show = markdown if options.markdown else plain
    print("\n\n".join(titled(table, show) for table in tables(parts, load_profile(options.profile))))
    return 0


def default_folder():
    """The folder of labelled parts that the environment names, or that lies beside the checkout: Path or None."""
    named = os.environ.get("THINPART_TRAINING")
    folder = Path(named) if named else ROOT.parent / "shared" / "training"
    return folder if folder.is_dir() else None


def manifest(folder):
    """The rows of the manifest of a folder by file, dict of dict."""
    with (folder / "manifest.csv").open(encoding="utf-8", newline="") as file:
        return {row["file"]: row for row in csv.DictReader(file)}


def labelled_parts(folder, profile, info_dir, files=None):
    """The labelled parts that could be measured: list of LabelledPart, with the repository as group.

    Parameters
    ----------
    folder : Path
    profile, info_dir : str
    files : iterable of str, optional
        Those of the manifest that are wanted; by default all.
    """
    labels, found = manifest(folder), []
    paths = [folder / name for name in (labels if files is None else files)]
    for number, parts in enumerate(thinpart.classify_files(paths, profile, write_info=info_dir), start=1):
        if sys.stderr.isatty():
            print(f"\r{number} of {len(paths)}", end="", file=sys.stderr, flush=True)
        for failure in parts.failures:
            print(f"{parts.file}: {failure}", file=sys.stderr)
        if len(parts):
            name = Path(parts.file).relative_to(folder).as_posix()
            row = labels[name]
            found.append(LabelledPart(
                name, parts[0].name, row["source_repo"], row["expert_label"], row["alt_label"] or None,
                row["confidence"] == "sure", {"engineer": row["expert_label"]}, descriptors_of(parts[0].record), ()))
    return found


def tables(parts, profile):
    """Yield all tables."""
    own = [classify(part.descriptors, profile) for part in parts]
    by_the_paper = [classify(part.descriptors, load_profile("paper")) for part in parts]
    judged = {"this profile": own, "the paper's thresholds": by_the_paper, **_judged_elsewhere(parts)}
    yield Table(
        f"Agreement, {len(parts)} parts of {len({part.group for part in parts})} repositories",
        ["verdict", "sure parts", "all parts, either answer", "sure thin parts found", "sure normal parts called thin"],
        [[title, *_agreement(parts, verdicts)] for title, verdicts in judged.items()])
    sure = [(part, verdict) for part, verdict in zip(parts, own) if part.is_sure]
    yield Table("Sure parts by label and verdict", ["label", *CATEGORIES, UNKNOWN], [
        [label, *row.values()] for label, row in scores(*zip(*sure), CATEGORIES).confusion.items()])
    for title in ("this profile", LEFT_OUT):
        if any(verdict.probabilities for verdict in judged.get(title, ())):
            yield from _trust(title, parts, judged[title])


def _agreement(parts, verdicts):
    score = scores(parts, verdicts, CATEGORIES)
    sure = [(part.category, verdict.category) for part, verdict in zip(parts, verdicts) if part.is_sure]

    def called_thin(label):
        found = [category == "thin" for given, category in sure if given == label]
        return f"{sum(found)} of {len(found)}"

    return [*(f"{100 * share.count / share.total:.1f} %" for share in (score.sure, score.either)),
            called_thin("thin"), called_thin("normal")]


def _trust(title, parts, verdicts):
    """Whether the stated probabilities hold, and how often what is not unsure is right."""
    stated = [(verdict.probabilities[verdict.category], truth_of(part, verdict.category))
              for part, verdict in zip(parts, verdicts) if verdict.probabilities]
    error = scores(parts, verdicts, CATEGORIES).calibration_error
    columns = ["stated", "parts", "mean stated", "right"]
    yield Table(f"Stated probability, {title}; expected calibration error {error:.3f}", columns, [
        [f"{each.low:.1f} to {each.high:.1f}", each.count, f"{each.stated:.2f}", f"{each.right:.2f}"]
        for each in reliability(*np.array(stated).T)])
    rows = []
    for name, chosen in (("sure", [part.is_sure for part in parts]), ("all, either answer", [True] * len(parts))):
        kept = [part.category == verdict.category or (not part.is_sure and part.second == verdict.category)
                for part, verdict, of in zip(parts, verdicts, chosen) if of and not verdict.borderline]
        rows.append([name, f"{100 * len(kept) / sum(chosen):.0f} %", f"{100 * np.mean(kept):.1f} %"])
    yield Table(f"Verdicts that are not unsure, {title}", ["parts", "share of them", "right"], rows)


def _judged_elsewhere(parts):
    """Verdicts of profiles that have not seen the part's repository, by how the repositories were left out."""
    try:
        check_scikit_learn()
    except thinpart.ThinPartError as error:
        print(error, file=sys.stderr)
        return {}
    chooser = _Chooser(parts)
    repositories = sorted({part.group for part in parts})
    ways = {LEFT_OUT: {name: number for number, name in enumerate(repositories)}}
    for seed in range(DIVISIONS):
        shuffled = np.random.default_rng(seed).permutation(repositories)
        ways[f"chosen without a fifth of them, {seed + 1}"] = dict(zip(shuffled, itertools.cycle(range(FIFTHS))))
    judged = {}
    for title, fold in ways.items():
        which = np.array([fold[part.group] for part in parts])
        verdicts = [None] * len(parts)
        for out in (which == number for number in np.unique(which)):
            if out.all():
                break
            profile = chooser.profile(~out)
            for number in np.flatnonzero(out):
                verdicts[number] = classify(parts[number].descriptors, profile)
        else:
            judged[title] = verdicts
    return judged


class _Chooser:
    """Chooses the thresholds of `calibrated` on some of the parts, and fits its probabilities to them."""

    def __init__(self, parts):
        self._start = load_profile("calibrated")
        descriptors = [part.descriptors for part in parts]
        shares = {symbol: np.array([each.value(symbol) for each in descriptors], dtype=float)
                  for symbol in ("plate_ratio", *map(_walls, {*WIDTHS["walls"], *WIDTHS["tapers"]}),
                                 *map(_places, WIDTHS["places"]))}
        # As the profile takes it: an open surface has walls of plates.
        shares["plate_ratio"] = np.nan_to_num(shares["plate_ratio"], nan=quantity_named("plate_ratio").absent_means)
        self._choices = list(itertools.product(*WIDTHS.values(), *LIMITS.values()))
        answers = np.array([_answers(shares, choice) for choice in self._choices])
        label, second = (np.array([CATEGORIES.index(name) if name else -1 for name in names])
                         for names in ([part.category for part in parts], [part.second for part in parts]))
        weight = np.array([1.0 if part.is_sure else UNSURE for part in parts])
        self._right = ((answers == label) | ((answers == second) & (weight < 1.0))) * weight
        truth = np.array([[truth_of(part, category) for category in CATEGORIES] for part in parts])
        self._fit = ProbabilityFit(self._start.probability, descriptors, truth, self._start.area_floor)

    def profile(self, chosen):
        """The profile for the chosen parts.

        The best choice of thresholds is often one of many that differ by a part or two. One is taken whose neighbours do
        well too: how many verdicts are right is smoothed over neighbouring limits (a Gaussian of one step).
        """
        right = self._right[:, chosen].sum(axis=1).reshape([len(each) for each in (*WIDTHS.values(), *LIMITS.values())])
        smooth = gaussian_filter(right, [0] * len(WIDTHS) + [1] * len(LIMITS), mode="nearest")
        walls, places, tapered, covered, plates, some, tapers = self._choices[int(smooth.argmax())]
        limits = {"thin_walls": {_walls(walls): covered, "plate_ratio": plates},
                  "thin_places": {_places(places): some}, "thin_tapers": {_walls(tapered): tapers}}
        content = self._start.content
        categories = [{**category, "criteria": [
            {**criterion, "conditions": [{"quantity": symbol, "comparison": ">", "value": value}
                                         for symbol, value in limits[criterion["id"]].items()]}
            if criterion["id"] in limits else criterion
            for criterion in category["criteria"]]} for category in content["categories"]]
        return profile_from({**content, "categories": categories, "probability": self._fit.content(chosen)})


def _walls(width):
    return f"K[0;{width:g}]"


def _places(width):
    return f"P[0;{width:g}]"


def _answers(shares, choice):
    walls, places, tapered, covered, plates, some, tapers = choice
    thin = (shares[_walls(walls)] > covered) & (shares["plate_ratio"] > plates)
    features = (shares[_places(places)] > some) | (shares[_walls(tapered)] > tapers)
    return np.where(thin, 0, np.where(features, 1, 2)).astype(np.int8)


if __name__ == "__main__":
    sys.exit(main())
