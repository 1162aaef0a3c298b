# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart similar``: find parts with similar walls, fill and box, and the reasons."""

import argparse
import sys

from ...api.libraries import reference_part
from ...core.foreign_text import json_text
from ..stored_rows import print_stored
from ..terminal_table import TableColumn
from .library import NOTHING_STORED, count_from_one, libraries


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("path", metavar="PART",
                        help="a document, or its info file; measured if it has no info file")
    parser.add_argument("roots", nargs="+", metavar="ROOT", help="folders to look in, with all below them")
    parser.add_argument("--part", metavar="NAME",
                        help="name or label of the part, where the document has several")
    parser.add_argument("-n", type=count_from_one, default=10, metavar="N", help="how many (default: %(default)s)")
    parser.add_argument("--same-size", type=_factor, nargs="?", const=1.25, metavar="FACTOR",
                        help="only parts whose diagonal differs by no more than this factor (1.25)")
    parser.add_argument("--json", action="store_true",
                        help="print one JSON record per part, with score and reasons")


def run(options):
    """Find similar parts and return the exit status."""
    record, own_key = reference_part(options.path, options.part)
    with libraries(options.roots) as (opened, status):
        found = opened.similar(record, options.n, options.same_size, own_key)
        if options.json:
            for match in found:
                line = match.line()
                if line is not None:
                    print(json_text({"score": round(match.score, 2), "reasons": match.reasons, **line}))
        elif found:
            by_part = {match.stored: match for match in found}
            print_stored(list(by_part), sys.stdout, opened.folder, (
                TableColumn("Score", lambda part: f"{by_part[part].score:.0f} %", True),
                TableColumn("Why", lambda part: by_part[part].reasons),
            ))
        elif not status:
            print("There is no other part in these folders." if opened.has_parts else NOTHING_STORED, file=sys.stderr)
    return status


def _factor(text):
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 1.0 <= value < float("inf"):
        raise argparse.ArgumentTypeError(f"'{text}' is not a factor of 1 or more")
    return value
