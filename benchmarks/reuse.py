#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long it takes to find parts of one form among many, by what an index keeps of them.

    /usr/bin/python3 benchmarks/reuse.py LIBRARY [--parts 1000 10000 100000] [--processes N] [--markdown]

LIBRARY is a folder of classified parts. Their forms are varied until there are so many: most are stretched along each axis,
so that they are parts of their own, and three in ten are copies of others, one in three of these turned anywhere. What is
found is compared with that: a copy is found where it is in one group with its source. Parts of which one is nearly the other
by chance, such as boxes, are counted as more. The last column is how long it takes besides to find parts that are alike but
for something.
"""

import argparse
import json
import os
import sys
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, os.fspath(ROOT))

from benchmarks.machine import machine  # noqa: E402
from thinpart_workbench.api.libraries import Libraries  # noqa: E402
from thinpart_workbench.core.forms.form import Form  # noqa: E402
from thinpart_workbench.core.forms.moments import SurfaceMoments  # noqa: E402
from thinpart_workbench.core.forms.motion import turn_by  # noqa: E402
from thinpart_workbench.core.forms.recorded_form import packed_form, recorded_form, unpacked_numbers  # noqa: E402
from thinpart_workbench.core.run_control import RunControl  # noqa: E402
from thinpart_workbench.workflow.reuse.formed_parts import FormedParts, formed_parts  # noqa: E402
from thinpart_workbench.workflow.reuse.like_parts import LikeParts  # noqa: E402
from thinpart_workbench.workflow.reuse.like_processes import alike, of_one_form  # noqa: E402

COPIES, TURNED = 0.3, 1 / 3


class ManyParts(FormedParts):
    """Parts whose forms are made of others when they are asked for, as an index would read them."""

    def form(self, part):
        return self.more[part]()


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("library", metavar="LIBRARY")
    parser.add_argument("--parts", type=int, nargs="+", default=[1000, 10_000, 100_000], metavar="N")
    parser.add_argument("--processes", type=int, default=os.cpu_count(), metavar="N", help="default: one per core")
    parser.add_argument("--markdown", action="store_true", help="print a table in Markdown")
    options = parser.parse_args()
    with Libraries([options.library]) as libraries:
        known = formed_parts(libraries.indexes)
        bases = [form for form in map(known.form, range(len(known))) if form is not None]
    print(json.dumps(machine()), file=sys.stderr)
    line = "| {} | {} | {} | {} | {} | {} |" if options.markdown else "{:>9} {:>9} {:>8} {:>8} {:>8} {:>8}"
    print(line.format("parts", "seconds", "copies", "found", "more", "alike s"))
    if options.markdown:
        print("|---|---|---|---|---|---|")
    quiet = RunControl(), lambda done, total: None
    for count in options.parts:
        parts, copy_of = _many(bases, count)
        started = time.perf_counter()
        likes = LikeParts(parts)
        found = of_one_form(likes, parts, options.processes, *quiet)
        ended = time.perf_counter()
        alike(likes, parts, set(range(count)) - {each.part for each in found}, options.processes, *quiet)
        last = time.perf_counter()
        group = {each.part: each.reference for each in found}
        true = sum(group.get(copy, copy) == group.get(source, source) for copy, source in copy_of.items())
        print(line.format(count, f"{ended - started:.1f}", len(copy_of), true, len(found) - true, f"{last - ended:.1f}"),
              flush=True)


def _many(bases, count):
    """So many parts, and of which others some are copies: by their numbers."""
    rng = np.random.default_rng(7)
    recipes, copy_of = [], {}
    for number in range(count):
        if number and rng.random() < COPIES:
            source = int(rng.integers(number))
            copy_of[number] = source = copy_of.get(source, source)
            turn = turn_by(rng.normal(size=3) * 2.0) if rng.random() < TURNED else np.eye(3)
            recipes.append((recipes[source][0], recipes[source][1], turn))
        else:
            recipes.append((int(rng.integers(len(bases))), np.exp(rng.normal(size=3) * 0.3), np.eye(3)))
    numbers, sides = [], []
    for recipe in recipes:
        form = _made(bases, recipe)
        numbers.append(_numbers(form))
        sides.append(np.sort(np.ptp(form.outline.points @ form.axes, axis=0))[::-1])
    numbers = np.concatenate(numbers)
    none = np.zeros(count, dtype=np.int64)
    parts = ManyParts([], none, none, numbers, np.full(count, np.nan), np.array(sides), list(range(count, 0, -1)), 0,
                      tuple(lambda recipe=recipe: _made(bases, recipe) for recipe in recipes))
    return parts, copy_of


def _made(bases, recipe):
    """A form, stretched along the axes of its document and turned; its moments are those of its outline."""
    number, stretch, turn = recipe
    outline = bases[number].outline
    normals = outline.normals / stretch
    length = np.linalg.norm(normals, axis=1)
    area = outline.area * np.prod(stretch) * length
    points, normals = outline.points * stretch @ turn.T, normals / length[:, None] @ turn.T
    share = area / area.sum()
    points = points - share @ points
    weighted = (share[:, None] * points).T
    second = weighted @ points
    third = (weighted @ (points[:, :, None] * points[:, None, :]).reshape(-1, 9)).reshape(3, 3, 3)
    return Form(SurfaceMoments(float(area.sum()), np.zeros(3), second, third),
                outline._replace(points=points, normals=normals, area=area))


def _numbers(form):
    record = {"form": {**recorded_form(replace_outline(form))}, "descriptors": {"area_mm2": form.moments.area}}
    return unpacked_numbers([packed_form(record)[0]])


def replace_outline(form):
    """The form with one point of its outline: only its moments are packed."""
    return Form(form.moments, form.outline.chosen(slice(1)))


if __name__ == "__main__":
    main()
