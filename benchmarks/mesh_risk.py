#!/usr/bin/env python3
"""The risk of the automatic mesh: fits ``resources/mesh_risk.json`` to what the solver found, and says what it is worth.

    /usr/bin/python3 benchmarks/mesh_risk.py [--parts FOLDER] [--info-dir FOLDER] [--markdown] [--write]

What `benchmarks/solver_truth.py` kept is the truth: a part is in trouble where its automatic mesh fails, the solver
refuses it, or one of the first six elastic frequencies is more than 4 % off. Parts whose reference is not certain enough
to tell are left out. Everything is tried on repositories that the model was not fitted to. Needs scikit-learn; nothing is
meshed.
"""

import argparse
import json
import sys
import tempfile
from datetime import date
from pathlib import Path
from typing import NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import thinpart_workbench as thinpart
from benchmarks.agreement import default_folder, manifest
from benchmarks.solver_truth import solved
from benchmarks.table_text import Table, markdown, plain, titled
from thinpart_workbench.core.categories import NORMAL
from thinpart_workbench.core.descriptors.descriptor_table import quantity_named
from thinpart_workbench.core.judging.probability import logistic, weighted_quantity
from thinpart_workbench.core.record.part_record import descriptors_of
from thinpart_workbench.core.risk.mesh_risk import SHIPPED
from thinpart_workbench.core.tolerances import TOLERANCES
from thinpart_workbench.workflow.learning.fit_probabilities import check_scikit_learn, fitted_logistic
from thinpart_workbench.workflow.learning.validation import calibration_error, folds, reliability
from thinpart_workbench.workflow.solving.mesh_trouble import has_trouble

TERMS = ({"quantity": "F[0;0.05]"}, {"quantity": "short_edges", "log_offset": 1.0}, {"quantity": "flattened_share"})
"""Of the model, without weights."""

SINGLE = ("F[0;0.05]", "V/VBB", "K[0;0.08]", "L[0;0.08]", "T05", "plate_share", "short_edges",
          "narrow_faces", "faces", "tight_share", "flattened_share", "knife_edges", "min_nonparallel[10;55]")
"""Quantities that are tried alone."""

class SolvedPart(NamedTuple):
    """A part of which the solver's answer is known."""

    group: str
    label: str
    record: dict
    descriptors: object
    is_trouble: bool


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--parts", type=Path, default=default_folder(), metavar="FOLDER")
    parser.add_argument("--info-dir", metavar="FOLDER", help="keeps what was measured there for the next run")
    parser.add_argument("--markdown", action="store_true", help="tables as in docs/method.md")
    parser.add_argument("--write", action="store_true", help=f"write the model to {SHIPPED.name}")
    options = parser.parse_args()
    if options.parts is None or not (options.parts / "manifest.csv").is_file():
        parser.error("There is no folder with a manifest.csv: name one with --parts.")
    check_scikit_learn()
    with tempfile.TemporaryDirectory() as temporary:
        parts = solved_parts(options.parts, options.info_dir or temporary)
    if len({part.is_trouble for part in parts}) < 2:
        parser.error("Too few results are kept: run benchmarks/solver_truth.py first.")
    show = markdown if options.markdown else plain
    left_out = Validation(parts)
    print("\n\n".join(titled(table, show) for table in tables(parts, left_out)))
    content = {**model(parts), "left_out": {"auc": round(left_out.auc, 3), "calibration_error": round(left_out.error, 3)}}
    text = json.dumps(content, indent=2) + "\n"
    if options.write:
        SHIPPED.write_text(text, encoding="utf-8")
    print(f"\n{text}")


def solved_parts(folder, info_dir):
    """The parts of a folder that were solved, measured: list of SolvedPart."""
    rows = manifest(folder)
    truth = {name: has_trouble(found) for name, found in solved(folder, None, 1, 0.0).items()}
    names = [name for name, trouble in truth.items() if trouble is not None]
    found = []
    for parts in thinpart.classify_files([folder / name for name in names], write_info=info_dir):
        for failure in parts.failures:
            print(f"{parts.file}: {failure}", file=sys.stderr)
        if len(parts):
            name = Path(parts.file).relative_to(folder).as_posix()
            record = parts[0].record
            found.append(SolvedPart(rows[name]["source_repo"], rows[name]["expert_label"], record, descriptors_of(record),
                                    truth[name]))
    return found


class Validation:
    """Risks of parts, each by a model that was fitted without the part's repository.

    Attributes
    ----------
    risk : ndarray of shape (n,)
    """

    def __init__(self, parts, terms=TERMS):
        values, self._trouble = values_of(parts, terms), truth_of(parts)
        self._groups = np.array([part.group for part in parts])
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
    return np.array([part.is_trouble for part in parts], dtype=float)


def values_of(parts, terms):
    """Values of the terms without weights: ndarray of shape (n, terms)."""
    quantities = [weighted_quantity({**term, "weight": 1.0}, "terms") for term in terms]
    return np.array([[quantity.value(part.descriptors, TOLERANCES.floor) for quantity in quantities] for part in parts])


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
        "date": date.today().isoformat(), "parts": len(parts), "repositories": len({part.group for part in parts}),
        "trouble": int(trouble.sum()), "intercept": _readable(intercept),
        "terms": [{**term, "weight": _readable(weight), "usual": _readable(of_good)}
                  for term, weight, of_good in zip(TERMS, weights, usual)],
    }


def _readable(value):
    return float(f"{value:.3g}")


def auc(score, trouble):
    """Area under the receiver's curve, float: how often a part in trouble scores higher than one without, ties half."""
    yes, no = score[trouble == 1.0], score[trouble == 0.0]
    return float((yes[:, None] > no).mean() + 0.5 * (yes[:, None] == no).mean())


def tables(parts, left_out):
    """Yield all tables."""
    trouble = truth_of(parts)
    verdict = np.array([part.record["category"] != NORMAL for part in parts], dtype=float)
    label = np.array([part.label != NORMAL for part in parts], dtype=float)
    stated = np.array([1.0 - next((each["probability"] for each in part.record["probabilities"]
                                   if each["category"] == NORMAL), 0.5) for part in parts])
    rows = [[title, f"{found:.2f}"] for title, found in (
        ("the risk, repositories left out", left_out.auc), ("label by eye", auc(label, trouble)),
        ("verdict", auc(verdict, trouble)), ("probability that it is not normal", auc(stated, trouble)))]
    for symbol in SINGLE:
        found = auc(_ordered(parts, symbol), trouble)
        rows.append([f"{symbol} alone" + ("" if found >= 0.5 else ", the less the worse"), f"{max(found, 1.0 - found):.2f}"])
    groups = len({part.group for part in parts})
    low, high = left_out.interval
    yield Table(f"Trouble on {int(trouble.sum())} of {len(parts)} parts of {groups} repositories", ["by", "AUC"], rows,
                [f"The risk's own: {low:.2f} to {high:.2f} with a probability of 95 %, as repositories differ."])
    yield left_out.table
    yield Table("Expected calibration error, repositories left out", ["model", "error"], [
        ["the risk", f"{left_out.error:.3f}"],
        ["one whose risks are all right, on as many parts", f"{left_out.least_error:.3f}"],
        ["the mean of all parts for each", f"{_constant_error(parts):.3f}"]])
    yield Table("Trouble by verdict and by label", ["", "verdict", "label"], [
        [category, *(_share(trouble, chosen) for chosen in (
            [part.record["category"] == category for part in parts], [part.label == category for part in parts]))]
        for category in ("thin", "thin_features", NORMAL)])


def _ordered(parts, symbol):
    quantity = quantity_named(symbol)
    values = [quantity.evaluate(part.descriptors, TOLERANCES.floor) for part in parts]
    return np.array([quantity.absent_means if value is None else value for value in values], dtype=float)


def _constant_error(parts):
    trouble = truth_of(parts)
    return float(calibration_error(np.full(len(parts), trouble.mean()), trouble))


def _share(trouble, chosen):
    chosen = np.array(chosen)
    return f"{int(trouble[chosen].sum())} of {int(chosen.sum())}"


if __name__ == "__main__":
    main()
