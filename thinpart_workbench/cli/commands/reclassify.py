# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart reclassify``: judge stored parts by another profile, without geometry."""

import os
import sys
from collections import Counter
from contextlib import closing

from ...api.reclassification import reclassify
from ...core.analysis_settings import DEFAULT_PROFILE
from ...core.foreign_text import json_text, printable
from ...core.run_control import RunControl
from ..stop_signals import stop_signals
from ..terminal_table import CATEGORY_STYLES, OTHER_CATEGORY, TableColumn, print_table

MOST_ROWS = 200
"""Most changed parts in the printed table; --json lists all."""


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("paths", nargs="+", metavar="PATH",
                        help="folders with info files, documents that were classified, or info files")
    parser.add_argument("--profile", default=DEFAULT_PROFILE, metavar="NAME-or-FILE",
                        help="the thresholds to judge by (default: %(default)s)")
    parser.add_argument("--write", action="store_true",
                        help="update the info files; otherwise the changes are only listed")
    parser.add_argument("--json", action="store_true", help="print one JSON object per part")
    parser.add_argument("--jobs", type=int, metavar="N", default=os.cpu_count() or 1,
                        help="worker processes (default: one per processor)")


def run(options):
    """Judge again and return the exit status."""
    control = RunControl()
    run = reclassify(options.paths, options.profile, write=options.write, jobs=max(1, options.jobs), control=control)
    for sentence in run.problems:
        print(f"thinpart: {printable(sentence)}", file=sys.stderr)
    status = 1 if run.problems else 0
    changes, counts, changed, again = Counter(), Counter(), [], 0
    judged = iter(run)
    with stop_signals(control), closing(judged):
        for file in judged:
            if file.error:
                print(f"thinpart: {printable(file.info_file)}: {printable(file.error)}", file=sys.stderr)
                status = 1
            for part in file.parts:
                before, after = part.before["category"], part.after["category"]
                counts[after] += 1
                changes[before, after] += 1
                again += part.measure_again
                if options.json:
                    print(json_text(_line(file, part)))
                elif before != after and len(changed) < MOST_ROWS:
                    changed.append((file, part))
    if not options.json:
        _print_changes(changed, changes, counts, run.profile, options.write)
    if again:
        print(f"thinpart: an earlier version did not measure what decides on {again} of these parts: they are unknown until "
              "'thinpart classify' measures their documents again.", file=sys.stderr)
    return status


def _line(file, part):
    return {"file": file.document, "info_file": file.info_file, "name": part.name, "label": part.label,
            "before": part.before, **part.after, "changed": part.differs, "measure_again": part.measure_again}


def _print_changes(changed, changes, counts, profile, written):
    if changed:
        print_table(sys.stdout, _COLUMNS, lambda: changed)
    moved = {pair: count for pair, count in changes.items() if pair[0] != pair[1]}
    total = sum(moved.values())
    if total > len(changed):
        print(f"... and {total - len(changed)} more; --json lists all.")
    for (before, after), count in sorted(moved.items(), key=lambda item: (-item[1], item[0])):
        print(printable(f"{count} from {before} to {after}"))
    summary = ", ".join(f"{count} {name}" for name, count in sorted(counts.items()))
    print(printable(f"{sum(counts.values())} parts by the profile {profile.name}: {summary}; {total} changed."))
    if total and not written:
        print("Nothing was written: --write updates the info files.")


def _category(which):
    return lambda row: CATEGORY_STYLES.get(getattr(row[1], which)["category"], OTHER_CATEGORY)


_COLUMNS = (
    TableColumn("File", lambda row: row[0].document),
    TableColumn("Part", lambda row: row[1].label),
    TableColumn("Was", lambda row: row[1].before["category"], style=_category("before")),
    TableColumn("Is", lambda row: row[1].after["category"], style=_category("after")),
    TableColumn("Criteria", lambda row: ", ".join(map(str, row[1].after["criteria"])) or "none"),
)
