# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart find``: search libraries for parts by category, thickness, size, words and conditions."""

import argparse
import sys

from ...core.categories import NORMAL, UNKNOWN
from ...core.errors import ThinPartError
from ...core.foreign_text import json_text, printable
from ...core.judging.criteria import load_profile
from ...storage.index.part_query import FAILED
from ...storage.index.written_query import SORTABLE, moment, part_query
from ..check_options import PartChecks, add_check_options, check_columns, checked_limits, named_limits
from ..stored_rows import print_stored
from .library import NOTHING_STORED, count_from_one, libraries


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("roots", nargs="+", metavar="ROOT",
                        help="a folder with info files, searched with all below it")
    parser.add_argument("--category", action="append", default=[], metavar="NAME",
                        help="thin, thin_features, normal, unknown, or a profile's own; repeat for several")
    parser.add_argument("--criterion", action="append", default=[], metavar="ID",
                        help="parts for which this criterion holds; repeat for several")
    for name, what in (("thickness", "thinnest wall"), ("size", "longest side of the box")):
        parser.add_argument(f"--min-{name}", type=float, metavar="A", help=f"{what} of at least A mm")
        parser.add_argument(f"--max-{name}", type=float, metavar="A", help=f"{what} of at most A mm")
    parser.add_argument("--where", action="append", default=[], metavar="CONDITION",
                        help="condition on any quantity, as in 'D2/D3 > 6 and F[0;0.05] >= 0.5'; repeat for several")
    for option, what in (("passes", "within"), ("fails", "outside")):
        parser.add_argument(f"--{option}", action="append", default=[], metavar="PROCESS",
                            help=f"parts whose walls lie {what} the limits of a process, as after --check; several with "
                                 "commas between them")
    add_check_options(parser, has_status=False)
    parser.add_argument("--text", default="", metavar="WORDS",
                        help="words that occur in path, name, label, notes, mesh settings or link")
    parser.add_argument("--notes", action=argparse.BooleanOptionalAction, default=None,
                        help="only parts with notes, mesh settings or a link, or only parts without")
    parser.add_argument("--said", action="append", default=[], metavar="NAME",
                        help="parts that somebody has labelled so: thin, thin_features, normal; repeat for several")
    parser.add_argument("--labelled", action=argparse.BooleanOptionalAction, default=None,
                        help="only parts that somebody has labelled, or only the others")
    parser.add_argument("--disputed", action=argparse.BooleanOptionalAction, default=None,
                        help="only parts that somebody has labelled otherwise than the verdict, or only the others")
    parser.add_argument("--borderline", action=argparse.BooleanOptionalAction, default=None,
                        help="only parts near another category, or only the others")
    parser.add_argument("--failed", action="store_true", help="list failures instead of parts")
    parser.add_argument("--changed-since", metavar="WHEN", type=_moment,
                        help="documents changed since a date (2026-03-31) or an age (12h, 7d, 4w, 1y)")
    parser.add_argument("--sort", choices=SORTABLE, metavar="QUANTITY", default="file",
                        help=f"one of {', '.join(SORTABLE)}")
    parser.add_argument("--reverse", action="store_true", help="largest first")
    parser.add_argument("-n", "--limit", type=count_from_one, metavar="N", help="no more than N parts")
    parser.add_argument("--json", action="store_true", help="print one JSON record per part")


def run(options):
    """Find and return the exit status."""
    checks = PartChecks(checked_limits(options))
    query = part_query(
        passes=named_limits(options.passes, options.limits), fails=named_limits(options.fails, options.limits),
        categories=_names(options.category), criteria=_names(options.criterion),
        ranges={"thinnest_mm": (options.min_thickness, options.max_thickness),
                "d1_mm": (options.min_size, options.max_size)},
        conditions=options.where, words=options.text, has_notes=options.notes,
        said=_names(options.said), labelled=options.labelled, disputed=options.disputed, borderline=options.borderline,
        failed=options.failed, changed_since=options.changed_since,
    )
    with libraries(options.roots) as (opened, status):
        found = opened.find(query, options.sort, options.reverse, options.limit)
        if options.json:
            for line in found.records():
                if checks.limits and "error" not in line:
                    line = {**line, "checks": checks.of(line)}
                print(json_text(line))
        else:
            print_stored([part.stored for part in found], sys.stdout, opened.folder, _columns(found, checks))
            if len(found) < found.total and options.limit == len(found):
                print(f"{len(found)} of {found.total} parts: raise --limit for more.", file=sys.stderr)
            elif not found:
                print(_nothing(opened, query.categories), file=sys.stderr)
        for name, files in opened.judged_otherwise().items():
            print(f"thinpart: {files} info {'file was' if files == 1 else 'files were'} judged by another version of the "
                  f"profile {name}: 'thinpart reclassify FOLDER --profile {name}' shows what changes.", file=sys.stderr)
    return status


def _nothing(opened, categories):
    """Why nothing was found: str."""
    if not opened.has_parts:
        return NOTHING_STORED
    known = opened.categories()
    usual = {NORMAL, UNKNOWN, FAILED, *(category.name for category in load_profile().categories)}
    unknown = [name for name in categories if name not in usual.union(known)]
    if unknown:
        return printable(f"There is no category {', '.join(unknown)} in these folders: their parts are {', '.join(known)}.")
    return "No stored part fulfils all these conditions."


def _columns(found, checks):
    """Columns with the results of checks; they need the records, which are read for them alone."""
    if not checks.limits:
        return ()
    results = {(line["info_file"], line["name"]): checks.of(line) for line in found.records() if "error" not in line}
    return check_columns(checks.limits, lambda part: results.get((part.info_file, part.name)))


def _names(values):
    return tuple(name.strip() for value in values for name in value.split(",") if name.strip())


def _moment(text):
    try:
        return moment(text)
    except ThinPartError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
