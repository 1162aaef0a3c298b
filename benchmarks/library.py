#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast a library of many info files is indexed, searched, compared and judged again.

    /usr/bin/python3 benchmarks/library.py [--files 100000] [--folder DIR] [--markdown]

The bundled samples are classified, and their info files are varied until there are so many. One core does
all but judging again, which takes as many processes as there are processors.
"""

import argparse
import copy
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, os.fspath(ROOT))

from benchmarks.machine import machine  # noqa: E402
from thinpart_workbench.core.judging.conditions import search_conditions  # noqa: E402
from thinpart_workbench.core.judging.criteria import load_profile  # noqa: E402
from thinpart_workbench.storage.index.library_index import LibraryIndex  # noqa: E402
from thinpart_workbench.storage.info.info_file import SUFFIX, dumps  # noqa: E402
from thinpart_workbench.workflow.library.find_parts import PartQuery, find_parts  # noqa: E402
from thinpart_workbench.workflow.library.library_search import LibrarySearch  # noqa: E402
from thinpart_workbench.workflow.library.reclassify import reclassify_files  # noqa: E402
from thinpart_workbench.workflow.library.similar_parts import similar_parts  # noqa: E402

FILES_PER_FOLDER = 1000
REPEAT = 5


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--files", type=int, default=100_000, metavar="N", help="info files (default: 100000)")
    parser.add_argument("--folder", metavar="DIR", help="where the library is made and kept (default: a "
                        "temporary folder that is removed)")
    parser.add_argument("--markdown", action="store_true", help="print a table in Markdown")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="thinpart-library-") as temporary:
        library = Path(options.folder or temporary, "library")
        if not library.is_dir():
            print(f"making {options.files} info files", file=sys.stderr)
            _make(library, Path(temporary), options.files)
        rows = list(_measured(library, Path(temporary, "index")))
    print(json.dumps(machine()), file=sys.stderr)
    for what, value in rows:
        print(f"| {what} | {value} |" if options.markdown else f"{what:<58} {value:>16}")


def _make(library, temporary, files):
    info_folder = temporary / "info"
    subprocess.run(
        [sys.executable, "-m", "thinpart_workbench", "classify", ROOT / "resources" / "samples",
         "--info-dir", info_folder], env={**os.environ, "PYTHONPATH": os.fspath(ROOT)},
        stdout=subprocess.DEVNULL, check=True)
    contents = [json.loads(path.read_bytes()) for path in sorted(info_folder.rglob(f"*{SUFFIX}"))]
    chance = random.Random(20120507)
    for number in range(files):
        content = _varied(contents[number % len(contents)], number, chance)
        folder = library / f"{number // FILES_PER_FOLDER:04d}"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"part{number}.step{SUFFIX}").write_bytes(dumps(content))


def _varied(content, number, chance):
    """The same info file of another, somewhat different document."""
    content = copy.deepcopy(content)
    content["source"].update(file=f"part{number}.step", folder=".")
    for part in content["parts"]:
        part["label"] = f"Part {number}"
        measured = part["descriptors"]
        size, stretch = chance.uniform(0.2, 5.0), chance.uniform(0.7, 1.4)
        box = sorted((side * size * factor for side, factor in zip(measured["box_mm"], (stretch, 1.0, 1.0))),
                     reverse=True)
        thickness = measured["thickness_mm"]
        thickness.update({key: value * size for key, value in thickness.items() if value is not None})
        measured.update(box_mm=box, d1_d2=box[0] / box[1], d2_d3=box[1] / box[2],
                        diagonal_mm=sum(side ** 2 for side in box) ** 0.5)
        if measured["volume_ratio"] is not None:
            measured["volume_ratio"] = min(1.0, measured["volume_ratio"] * chance.uniform(0.8, 1.2))
    return content


def _measured(library, folder):
    with LibraryIndex(library, folder) as index:
        seconds, refreshed = _timed(index.refresh)
        yield "info files", f"{refreshed.files:,}"
        yield "parts", f"{len(find_parts(index)):,}"
        yield "index built, info files per second", f"{refreshed.changed / seconds:,.0f}"
        yield "index, MB", f"{os.path.getsize(index.path) / 1e6:,.0f}"
        yield "refreshed with nothing changed, s", f"{_best(index.refresh):.2f}"
        for what, query in _QUERIES:
            found = find_parts(index, query)
            milliseconds = 1000.0 * _best(lambda query=query: find_parts(index, query))
            yield f"{what}: {len(found):,} parts, all rows, ms", f"{milliseconds:.1f}"
        search = LibrarySearch([index])
        for what, query in _QUERIES:
            milliseconds = 1000.0 * _best(lambda query=query: _shown(search, query))
            yield f"{what}: counts of all choices and first 100 rows, ms", f"{milliseconds:.1f}"
        record = json.loads(Path(find_parts(index)[0].info_file).read_bytes())["parts"][0]
        yield "ten most similar parts, s", f"{_best(lambda: similar_parts([index], record, 10)):.2f}"
    info_files = sorted(map(str, library.rglob(f"*{SUFFIX}")))
    profile = load_profile("paper").content
    for jobs in sorted({1, os.cpu_count() or 1}):
        seconds, parts = _timed(lambda jobs=jobs: sum(
            len(file.parts) for file in reclassify_files(info_files, profile, jobs=jobs)))
        yield f"judged again with {jobs} jobs, parts per second", f"{parts / seconds:,.0f}"


_QUERIES = (
    ("category thin", PartQuery(categories=("thin",))),
    ("thinnest wall up to 2 mm and 'part 12' in a text", PartQuery(ranges=(("thinnest_mm", None, 2.0),), words="part 12")),
    ("D2/D3 > 6 and F[0;0.05] > 0.5", PartQuery(conditions=search_conditions("D2/D3 > 6 and F[0;0.05] > 0.5"))),
)


def _shown(search, query):
    return search.counts(query), search.find(query, "d1_mm").parts(0, 100)


def _timed(function):
    started = time.perf_counter()
    result = function()
    return time.perf_counter() - started, result


def _best(function):
    return min(_timed(function)[0] for _ in range(REPEAT))


if __name__ == "__main__":
    main()
