#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the values and verdicts at each accuracy are from those of a much finer measurement.

    /usr/bin/python3 benchmarks/accuracy.py [--parts FOLDER] [--reference FOLDER] [--jobs N] [--markdown] [-o FILE]

The reference tessellates at 0.02 % of the diagonal and 2 degrees and casts 20 times as many rays. Its info files are kept
(--reference), so that a run which was stopped goes on where it was, and the next one measures all else only.
They are not measured again when the program changes: remove the folder if what is measured has changed.
"""

import argparse
import json
import math
import os
import sys
import time
from collections import namedtuple
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, os.fspath(ROOT))

import thinpart_workbench as thinpart  # noqa: E402
from benchmarks.machine import machine, product_version  # noqa: E402
from benchmarks.places import CACHE  # noqa: E402
from benchmarks.result_tables import accuracy_tables  # noqa: E402
from benchmarks.table_text import markdown, plain, titled  # noqa: E402
from thinpart_workbench.core.analysis_settings import ACCURACIES, AnalysisSettings  # noqa: E402
from thinpart_workbench.core.descriptors.descriptor_table import (  # noqa: E402
    QUANTITIES,
    REPORTED_SHARES,
    STATED_FLOOR,
    quantity_named,
)
from thinpart_workbench.core.judging.classification import classify  # noqa: E402
from thinpart_workbench.core.judging.criteria import load_profile  # noqa: E402
from thinpart_workbench.core.record.part_record import descriptors_of  # noqa: E402

SAMPLES = ROOT / "resources" / "samples"
QUICK = ("block.step", "plate.step", "tapered_plug.step")
"""The samples that are measured fast, also finely."""

REFERENCE = {"linear_deflection": 0.0002, "angular_deflection": 2.0,
             "minimum_samples": 20 * AnalysisSettings.minimum_samples}
"""In every other way it is the finest of `ACCURACIES`."""

MOST_JOBS = 2
"""A fine measurement takes gigabytes."""

SECONDS, MEGABYTES = 3600, 10240
"""Limits of one file."""

THINNEST = "thinnest wall"
"""Beside the quantities, with the greatest error that its record states."""

CLOSE = (0.005, 0.015)

PROFILES = ("calibrated", "paper")

Judged = namedtuple("Judged", "record descriptors verdicts")
"""A part: its record and the `Descriptors` in it; by profile, category and whether it is borderline."""


def main():
    """Measure, and print tables; the exit status: 1 where no part was measured both ways."""
    options = _options()
    results = {"machine": machine(), "versions": product_version(),
               "accuracy": measure_accuracy(options.parts, options.reference, options.jobs, options.quick, _say)}
    if options.output:
        options.output.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    text = markdown if options.markdown else plain
    for table in accuracy_tables(results):
        print(titled(table, text) + "\n")
    return 0 if any(each["parts"] for each in results["accuracy"]) else 1


def _options():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--parts", type=Path, metavar="FOLDER", help="a folder of real parts, beside the samples")
    parser.add_argument("--reference", type=Path, metavar="FOLDER", default=CACHE / "reference",
                        help="where the reference is kept (default: in the cache)")
    parser.add_argument("--jobs", type=int, default=MOST_JOBS, choices=range(1, MOST_JOBS + 1), metavar="N",
                        help=f"files measured at the same time, {MOST_JOBS} at most")
    parser.add_argument("--quick", action="store_true", help="three samples only")
    parser.add_argument("--markdown", action="store_true", help="print Markdown")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="also write the results as JSON")
    options = parser.parse_args()
    if options.parts is not None and not options.parts.is_dir():
        parser.error(f"{options.parts} is no folder")
    return options


def _say(text):
    print(text, file=sys.stderr)


def measure_accuracy(parts, reference, jobs, is_quick, say):
    """Compare every level of accuracy with the reference, on the samples and on a folder of real parts.

    Parameters
    ----------
    parts : Path or None
    reference : Path
        Folder of the reference's info files.
    jobs : int
    is_quick : bool
        Three samples only.
    say : callable
        Told what is going on, and which verdicts differ.

    Returns
    -------
    list of dict
        One per folder and level: what `compared` says, and ``folder``, ``level``, ``is_default``, ``settings``,
        ``reference`` (its settings), ``jobs``, ``seconds`` and ``reference_seconds``, None where some of it was kept, and
        ``only_one_measured``, parts.
    """
    found = []
    for name, folder in (("samples", SAMPLES), ("real parts", None if is_quick else parts)):
        if folder is None:
            continue
        include = QUICK if is_quick else ()
        # One folder each: info files lie in the tree of the folder that was measured.
        store = reference / f"{name.replace(' ', '_')}_{Path(folder).resolve().name}"
        fine, fine_seconds = _measured(
            f"{name}, reference", folder, AnalysisSettings.at(list(ACCURACIES)[-1], **REFERENCE), jobs, include, say, store)
        for level, settings in ((level, AnalysisSettings.at(level)) for level in ACCURACIES):
            own, seconds = _measured(f"{name}, {level}", folder, settings, jobs, include, say)
            both = [(key, own[key], fine[key]) for key in own if key in fine]
            for sentence in (*_differing(both), *_farthest(both)):
                say(f"{name}, {level}: {sentence}")
            found.append({
                "folder": name, "level": level, "is_default": settings == AnalysisSettings(),
                "settings": settings.content(), "reference": REFERENCE, "jobs": jobs,
                "seconds": seconds, "reference_seconds": fine_seconds,
                "only_one_measured": len(own.keys() ^ fine.keys()), **compared([pair for _, *pair in both]),
            })
    return found


def _measured(title, folder, settings, jobs, include, say, store=False):
    """The parts of a folder, dict of (file, part) to Judged; the seconds that they took, None if some were stored."""
    found, reused, started = {}, False, time.perf_counter()
    profiles = [load_profile(name) for name in PROFILES]

    def report(progress):
        nonlocal reused
        content = progress.content()
        reused = reused or bool(content["reused"])
        if sys.stderr.isatty():
            print(f"\r{title}: {content['done']} of {content['total']} ", end="", file=sys.stderr, flush=True)

    for parts in thinpart.classify_files(folder, PROFILES[0], settings, jobs=jobs, seconds=SECONDS, megabytes=MEGABYTES,
                                         write_info=store, force=not store, include=include, report=report):
        for failure in parts.failures:
            say(f"{title}: {Path(parts.file).name}: {failure}")
        for part in parts:
            descriptors = descriptors_of(part.record)
            verdicts = {}
            for profile in profiles:
                verdict = classify(descriptors, profile)
                verdicts[profile.name] = (verdict.category, verdict.borderline)
            found[Path(parts.file).relative_to(folder).as_posix(), part.name] = Judged(part.record, descriptors, verdicts)
    seconds = None if reused else time.perf_counter() - started
    say(f"{title}: {len(found)} parts")
    return found, seconds


def _differing(both):
    """A sentence for each verdict by the default profile that is not the reference's."""
    for (file, name), own, fine in both:
        (category, is_borderline), (right, was_borderline) = (each.verdicts[PROFILES[0]] for each in (own, fine))
        if category != right:
            border = ", borderline" if is_borderline or was_borderline else ""
            yield f"{file}, {name}: {category}, the reference says {right}{border}"


def _farthest(both):
    """A sentence for each quantity that is far off on some part: on which one."""
    for name, value in _quantities().items():
        differences = [(_difference(value(own), value(fine)) or 0.0, file, part) for (file, part), own, fine in both]
        difference, file, part = max(differences, default=(0.0, "", ""))
        if difference > CLOSE[-1]:
            yield f"{file}, {part}: {name} is off by {difference:.3g}"


def compared(pairs):
    """Statistics of how parts differ from their reference.

    Parameters
    ----------
    pairs : list of (Judged, Judged)
        As measured, and the reference.

    Returns
    -------
    dict
        ``parts``; ``verdicts``, by profile how many ``differ``, and how many of these are ``borderline`` in either; and
        ``quantities``, a list of dict with ``name``, ``parts``, ``median``, ``most`` (97 %) and ``greatest`` of the
        absolute differences, ``close``, the shares of parts within `CLOSE`, ``only_one``, the parts of which only one of
        the two has a value, and ``stated``: parts with a stated error, the share of them whose difference it covers, and
        its median.
    """
    verdicts = {}
    for name in PROFILES:
        differing = [(own.verdicts[name], fine.verdicts[name]) for own, fine in pairs
                     if own.verdicts[name][0] != fine.verdicts[name][0]]
        verdicts[name] = {"differ": len(differing), "borderline": sum(own[1] or fine[1] for own, fine in differing)}
    quantities = [_statistics(name, value, pairs) for name, value in _quantities().items()]
    return {"parts": len(pairs), "verdicts": verdicts, "quantities": [each for each in quantities if each]}


def _quantities():
    """By name, what is compared: a function from a part to the value, its stated error and what both are relative to."""
    symbols = [f"F[{low:g};{high:g}]" for low, high in REPORTED_SHARES]
    for name in PROFILES:
        symbols += [condition.quantity.symbol for criterion in load_profile(name).criteria
                    for condition in criterion.conditions if condition.quantity.symbol[:2] in ("K[", "P[")]
    symbols += [quantity.symbol + ("[{:g};{:g}]".format(*quantity.bounds) if quantity.bounds else "")
                for quantity in QUANTITIES if quantity.has_error and quantity.keys]
    named = {symbol: lambda part, symbol=symbol: _value(part, symbol) for symbol in symbols}
    return {**named, THINNEST: _thinnest}


def _value(part, symbol):
    """Value of a quantity, its stated error, and what both are relative to; None where there is none."""
    quantity = quantity_named(symbol)
    value = part.descriptors.value(symbol)
    return value, quantity.error(part.descriptors, STATED_FLOOR), value if quantity.unit else 1.0


def _thinnest(part):
    """The same of the thinnest wall, mm, in shares of itself."""
    thickness = part.record["descriptors"]["thickness_mm"]
    return thickness["min"], thickness["error_bound"], thickness["min"]


def _difference(own, fine):
    """The absolute difference of two values, in what the reference is relative to; None where one is missing."""
    (found, *_), (right, _, scale) = own, fine
    if found is None or right is None:
        return None
    return 0.0 if found == right else abs(found - right) / (scale or 1.0)


def _statistics(name, value, pairs):
    difference, covered, stated, only_one = [], [], [], 0
    for own, fine in ((value(own), value(fine)) for own, fine in pairs):
        off = _difference(own, fine)
        if off is None:
            only_one += (own[0] is None) != (fine[0] is None)
            continue
        difference.append(off)
        if own[1] is not None:
            stated.append(own[1] / (fine[2] or 1.0))
            covered.append(off <= stated[-1])
    if not difference:
        return None
    difference = np.array(difference)
    return {
        "name": name, "parts": len(difference), "median": _number(np.median(difference)),
        "most": _number(np.percentile(difference, 97)), "greatest": _number(difference.max()),
        "close": [float(np.mean(difference <= limit)) for limit in CLOSE], "only_one": only_one,
        "stated": {"parts": len(stated), "covers": float(np.mean(covered)), "median": _number(np.median(stated))}
        if stated else None,
    }


def _number(value):
    """A number for JSON, which has no infinity: a least distance may be infinite on one side."""
    return float(value) if math.isfinite(value) else None


if __name__ == "__main__":
    sys.exit(main())
