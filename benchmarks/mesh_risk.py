#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The risk of the automatic mesh: fits ``resources/mesh_risk.json`` to what the solver found, and says what it is worth.

    /usr/bin/python3 benchmarks/mesh_risk.py [--parts FOLDER] [--info-dir FOLDER] [--markdown] [--write]

What `solver_truth.py` kept is the truth: whether a part is in trouble. All is tried on repositories that the model was
not fitted to. Needs scikit-learn; nothing is meshed.
"""

import argparse
import json
import sys
import tempfile
from datetime import date
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.agreement import default_folder, labelled_parts
from benchmarks.places import ROOT
from benchmarks.solver_tables import solved_part
from benchmarks.solver_truth import DOCUMENT, solved, with_tables
from benchmarks.table_text import Table, markdown, plain, titled
from thinpart_workbench.core.categories import NORMAL
from thinpart_workbench.core.descriptors.descriptor_table import STATED_FLOOR, quantity_named
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.judging.foretelling import area_under_curve
from thinpart_workbench.core.judging.probability import logistic, weighted_quantity
from thinpart_workbench.core.risk.mesh_risk import SHIPPED
from thinpart_workbench.workflow.learning.fit_probabilities import check_scikit_learn, fitted_logistic
from thinpart_workbench.workflow.learning.validation import calibration_error, folds, reliability

TERMS = ({"quantity": "F[0;0.02]"}, {"quantity": "thin_x", "log_offset": 0.001},
         {"quantity": "short_edges", "log_offset": 1.0}, {"quantity": "flattened_share"})
"""Of the model, without weights."""

SINGLE = ("F[0;0.02]", "thin_x", "V/VBB", "K[0;0.08]", "L[0;0.08]", "T05", "plate_share", "short_edges", "narrow_faces",
          "faces", "tight_share", "flattened_share", "knife_edges", "min_nonparallel[10;55]")
"""Quantities that are tried alone."""

MARKS = ("<!-- mesh risk -->", "<!-- end of mesh risk -->")

PROFILE = "calibrated"


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--parts", type=Path, default=default_folder(), metavar="FOLDER")
    parser.add_argument("--info-dir", metavar="FOLDER", help="keeps what was measured there for the next run")
    parser.add_argument("--markdown", action="store_true", help="tables as in docs/method.md")
    parser.add_argument("--write", action="store_true",
                        help=f"write the model to {SHIPPED.name}, and the tables into {DOCUMENT}")
    options = parser.parse_args()
    if options.parts is None or not (options.parts / "manifest.csv").is_file():
        parser.error("There is no folder with a manifest.csv: name one with --parts.")
    check_scikit_learn()
    profile = load_profile(PROFILE)
    truth = solved(options.parts, None, 1, 0.0)
    with tempfile.TemporaryDirectory() as temporary:
        labelled = labelled_parts(options.parts, PROFILE, options.info_dir or temporary, truth)
    parts = [solved_part(part, truth[part.file], [profile]) for part in labelled]
    parts = [part for part in parts if part.trouble is not None]
    if len({part.trouble for part in parts}) < 2:
        parser.error("Too few results are kept: run benchmarks/solver_truth.py first.")
    left_out = Validation(parts)
    show = markdown if options.markdown else plain
    print("\n\n".join(titled(table, show) for table in tables(parts, left_out)))
    content = {**model(parts), "left_out": {"auc": round(left_out.auc, 3), "calibration_error": round(left_out.error, 3)}}
    text = json.dumps(content, indent=2) + "\n"
    print(f"\n{text}")
    if options.write:
        SHIPPED.write_text(text, encoding="utf-8")
        document = ROOT / DOCUMENT
        document.write_text(with_tables(document.read_text(encoding="utf-8"), tables(parts, left_out), MARKS),
                            encoding="utf-8")


class Validation:
    """Risks of parts, each by a model that was fitted without the part's repository.

    Attributes
    ----------
    risk : ndarray of shape (n,)
    """

    def __init__(self, parts, terms=TERMS):
        values, self._trouble = values_of(parts, terms), truth_of(parts)
        self._groups = np.array([part.part.group for part in parts])
        self.risk = np.zeros(len(parts))
        for out in folds(self._groups):
            intercept, weights = _fit(values[~out], self._trouble[~out])
            self.risk[out] = [logistic(intercept + row @ weights) for row in values[out]]

    @property
    def auc(self):
        """float: area under the curve of the risks."""
        return auc(self.risk, self._trouble)

    @property
    def interval(self):
        """Bounds, two floats, of 95 % of the areas under the curve of repositories drawn anew with replacement."""
        random, names = np.random.default_rng(1), np.unique(self._groups)
        rows = {name: np.flatnonzero(self._groups == name) for name in names}
        draws = (np.concatenate([rows[name] for name in random.choice(names, len(names))]) for _ in range(2000))
        found = [auc(self.risk[draw], self._trouble[draw]) for draw in draws if np.ptp(self._trouble[draw]) > 0.0]
        return tuple(map(float, np.percentile(found, (2.5, 97.5))))

    @property
    def error(self):
        """float: expected calibration error."""
        return calibration_error(self.risk, self._trouble)

    @property
    def least_error(self):
        """float: the calibration error to expect on so few parts if every risk were exactly right, by 1000 draws."""
        draws = np.random.default_rng(1).random((1000, len(self.risk)))
        return float(np.mean([calibration_error(self.risk, (draw < self.risk).astype(float)) for draw in draws]))

    @property
    def table(self):
        """Table: how often there is trouble, by the risk."""
        return Table("Trouble by stated risk, repositories left out", ["risk", "parts", "mean risk", "trouble"], [
            [f"{each.low:.1f} to {each.high:.1f}", each.count, f"{each.stated:.2f}", f"{each.right:.2f}"]
            for each in reliability(self.risk, self._trouble)])


def truth_of(parts):
    """1 for trouble, 0 for none: ndarray of shape (n,)."""
    return np.array([part.trouble for part in parts], dtype=float)


def values_of(parts, terms):
    """Values of the terms without weights: ndarray of shape (n, terms)."""
    quantities = [weighted_quantity({**term, "weight": 1.0}, "terms") for term in terms]
    return np.array([[quantity.value(part.part.descriptors, STATED_FLOOR) for quantity in quantities] for part in parts])


def _fit(values, trouble):
    intercept, weights = fitted_logistic(values, trouble, 1.0 - trouble)
    return intercept, np.array(weights)


def model(parts):
    """The content of ``mesh_risk.json``, fitted to all parts: dict."""
    values, trouble = values_of(parts, TERMS), truth_of(parts)
    intercept, weights = _fit(values, trouble)
    usual = values[trouble == 0.0].mean(axis=0) * weights
    return {
        "format": "thinpart-mesh-risk", "version": 1,
        "about": "Logistic regression: how probable it is that a mesh of second-order tetrahedra of a tenth of the "
                 "diagonal fails, is refused by the solver, or has one of the first six elastic frequencies over 4 % off.",
        "source": "benchmarks/solver_truth.py, benchmarks/mesh_risk.py: Gmsh and CalculiX on parts of public repositories",
        "date": date.today().isoformat(), "parts": len(parts), "repositories": len({part.part.group for part in parts}),
        "trouble": int(trouble.sum()), "intercept": _readable(intercept),
        "terms": [{**term, "weight": _readable(weight), "usual": _readable(of_good)}
                  for term, weight, of_good in zip(TERMS, weights, usual)],
    }


def _readable(value):
    return float(f"{value:.3g}")


def auc(score, trouble):
    """Area under the curve, float, of values, ndarray of shape (n,), by what `truth_of` returns."""
    return area_under_curve(score[trouble == 1.0], score[trouble == 0.0])


def tables(parts, left_out):
    """Yield all tables."""
    trouble = truth_of(parts)
    verdict = np.array([part.verdicts[0].category != NORMAL for part in parts], dtype=float)
    label = np.array([part.part.category != NORMAL for part in parts], dtype=float)
    stated = np.array([1.0 - (part.verdicts[0].probabilities or {NORMAL: 0.5})[NORMAL] for part in parts])
    rows = [[title, f"{found:.2f}"] for title, found in (
        ("the risk, repositories left out", left_out.auc), ("label by eye", auc(label, trouble)),
        ("verdict", auc(verdict, trouble)), ("probability that it is not normal", auc(stated, trouble)))]
    for symbol in SINGLE:
        found = auc(_ordered(parts, symbol), trouble)
        rows.append([f"{symbol} alone" + ("" if found >= 0.5 else ", the less the worse"), f"{max(found, 1.0 - found):.2f}"])
    groups = len({part.part.group for part in parts})
    low, high = left_out.interval
    yield Table(f"Trouble on {int(trouble.sum())} of {len(parts)} parts of {groups} repositories",
                ["by", "area under the curve"], rows,
                [f"The risk's own: {low:.2f} to {high:.2f} with a probability of 95 %, as repositories differ."])
    yield left_out.table
    yield Table("Expected calibration error, repositories left out", ["model", "error"], [
        ["the risk", f"{left_out.error:.3f}"],
        ["one whose risks are all right, on as many parts, on average", f"{left_out.least_error:.3f}"]])


def _ordered(parts, symbol):
    quantity = quantity_named(symbol)
    values = [quantity.evaluate(part.part.descriptors, STATED_FLOOR) for part in parts]
    return np.array([quantity.absent_means if value is None else value for value in values], dtype=float)


if __name__ == "__main__":
    main()
