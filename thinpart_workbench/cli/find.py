"""``thinpart find``: parts of whole libraries by category, thickness, size, words and conditions."""

import argparse
import json
import re
import sys
from datetime import datetime, timedelta, timezone

from ..core.conditions import search_conditions
from ..storage.index_columns import COLUMNS
from ..storage.part_query import PartQuery
from ..workflow.find_parts import find_parts, read_records
from .library import libraries
from .stored_rows import print_stored

_AGE = re.compile(r"^(\d+)\s*([hdwy])$")
_HOURS = {"h": 1, "d": 24, "w": 24 * 7, "y": 24 * 365}
SORTABLE = sorted(each.name for each in COLUMNS if each.type in ("REAL", "INTEGER")) + ["file", "label"]


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
                        help="over any quantity, as in 'D2/D3 > 6 and F[0;0.05] >= 0.5'; repeat for several")
    parser.add_argument("--text", default="", metavar="WORDS",
                        help="words that occur in path, name, label, notes, mesh settings or link")
    parser.add_argument("--notes", action=argparse.BooleanOptionalAction, default=None,
                        help="only parts with which something is kept, or nothing")
    parser.add_argument("--borderline", action=argparse.BooleanOptionalAction, default=None,
                        help="only parts near another category, or none of them")
    parser.add_argument("--failed", action="store_true", help="what could not be analysed, instead of parts")
    parser.add_argument("--changed-since", metavar="WHEN", type=_moment,
                        help="documents changed since a date (2026-03-31) or an age (12h, 7d, 4w, 1y)")
    parser.add_argument("--sort", choices=SORTABLE, metavar="QUANTITY", default="file",
                        help=f"one of {', '.join(SORTABLE)}")
    parser.add_argument("--reverse", action="store_true", help="largest first")
    parser.add_argument("-n", "--limit", type=_count, metavar="N", help="no more than N parts")
    parser.add_argument("--json", action="store_true", help="print one JSON record per part")


def run(options):
    """Find and return the exit status."""
    query = PartQuery(
        categories=_names(options.category), criteria=_names(options.criterion),
        least_thickness=options.min_thickness, most_thickness=options.max_thickness,
        least_size=options.min_size, most_size=options.max_size,
        conditions=tuple(each for text in options.where for each in search_conditions(text)),
        words=options.text, has_notes=options.notes, borderline=options.borderline, failed=options.failed,
        changed_since=options.changed_since,
    )
    with libraries(options.roots) as opened:
        found = [find_parts(index, query, _order(options)) for index in opened.indexes]
        parts = _distinct(part for each in found for part in each)
        if len(found) > 1:
            parts = sorted(parts, key=lambda part: _key(part, options), reverse=options.reverse)
        chosen = list(parts)[:options.limit]
        if options.json:
            for line in read_records(chosen):
                print(json.dumps(line, ensure_ascii=False))
        else:
            print_stored(chosen, sys.stdout, opened.folder)
            total = sum(map(len, found))
            if len(chosen) < total and options.limit == len(chosen):
                print(f"{len(chosen)} of {total} parts: raise --limit for more.", file=sys.stderr)
            elif not chosen:
                print("Nothing that is stored here fulfils all that.", file=sys.stderr)
    return opened.status


def _names(values):
    return tuple(name.strip() for value in values for name in value.split(",") if name.strip())


def _order(options):
    direction = " DESC" if options.reverse else ""
    if options.sort == "file":
        return f"files.path{direction}, parts.id"
    return f"{options.sort} IS NULL, {options.sort}{direction}, files.path, parts.id"


def _key(part, options):
    """As `_order`, for parts of several libraries; where there is no value, last either way."""
    value = getattr(part, options.sort)
    return (value is None) != options.reverse, value if value is not None else 0


def _distinct(parts):
    """Of libraries that lie in each other, each part once."""
    seen = set()
    for part in parts:
        key = part.info_file, part.name, part.error_message
        if key not in seen:
            seen.add(key)
            yield part


def _moment(text):
    age = _AGE.match(text.strip().lower())
    if age:
        return datetime.now(timezone.utc) - timedelta(hours=int(age[1]) * _HOURS[age[2]])
    try:
        return datetime.fromisoformat(text).astimezone(timezone.utc)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"'{text}' is no date such as 2026-03-31 and no age such as 12h, 7d, 4w or 1y") from None


def _count(text):
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1 on")
    return int(text)
