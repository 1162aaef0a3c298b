"""``thinpart reclassify``: stored parts by another profile, without geometry."""

import json
import os
import sys
from collections import Counter

from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..storage.info_file import SUFFIX
from ..storage.info_tree import scan
from ..workflow.kept_notes import info_file_of
from ..workflow.reclassify import is_another, reclassify_files
from .terminal_table import CATEGORY_STYLES, OTHER_CATEGORY, TableColumn, print_table

MOST_ROWS = 200
"""Changed parts that are listed for people; --json has all."""


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("paths", nargs="+", metavar="PATH",
                        help="folders with info files, documents that were classified, or info files")
    parser.add_argument("--profile", default="paper", metavar="NAME-or-FILE",
                        help="the thresholds to judge by (default: paper)")
    parser.add_argument("--write", action="store_true", help="update the info files; otherwise it is only told")
    parser.add_argument("--json", action="store_true", help="print one JSON object per part")
    parser.add_argument("--jobs", type=int, metavar="N", default=os.cpu_count() or 1,
                        help="processes (default: one per processor)")


def run(options):
    """Judge again and return the exit status."""
    profile = load_profile(options.profile)
    info_files, status = _info_files(options.paths)
    changes, counts, changed = Counter(), Counter(), []
    for file in reclassify_files(info_files, profile.content, options.write, max(1, options.jobs)):
        if file.error:
            print(f"thinpart: {file.info_file}: {file.error}", file=sys.stderr)
            status = 1
        for part in file.parts:
            before, after = part.before["category"], part.after["category"]
            counts[after] += 1
            changes[before, after] += 1
            if options.json:
                print(json.dumps(_line(file, part), ensure_ascii=False))
            elif before != after and len(changed) < MOST_ROWS:
                changed.append((file, part))
    if not options.json:
        _print_changes(changed, changes, counts, profile, options.write)
    return status


def _info_files(paths):
    found, status = [], 0
    for path in paths:
        if not os.path.isdir(path):
            found.append(os.fspath(info_file_of(path)))
            continue
        below, unreachable = scan(path)
        found += [os.path.join(path, os.fsdecode(each)) for each in sorted(below)]
        for folder, error in unreachable.items():
            print(f"thinpart: The folder {os.path.join(path, os.fsdecode(folder))} cannot be listed "
                  f"({error.strerror}): what lies in it was left as it is.", file=sys.stderr)
            status = 1
    if not found:
        raise ThinPartError(f"There are no info files (*{SUFFIX}) in {', '.join(paths)}: classify the parts "
                            "first.", "empty")
    return list(dict.fromkeys(found)), status


def _line(file, part):
    return {"file": file.document, "info_file": file.info_file, "name": part.name, "label": part.label,
            "before": part.before, **part.after, "changed": is_another(part)}


def _print_changes(changed, changes, counts, profile, written):
    if changed:
        print_table(sys.stdout, _COLUMNS, lambda: changed)
    moved = {pair: count for pair, count in changes.items() if pair[0] != pair[1]}
    total = sum(moved.values())
    if total > len(changed):
        print(f"... and {total - len(changed)} more; --json lists all.")
    for (before, after), count in sorted(moved.items(), key=lambda each: (-each[1], each[0])):
        print(f"{count} from {before} to {after}")
    summary = ", ".join(f"{count} {name}" for name, count in sorted(counts.items()))
    print(f"{sum(counts.values())} parts by the profile {profile.name}: {summary}; {total} changed.")
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
