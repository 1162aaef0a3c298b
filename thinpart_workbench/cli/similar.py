"""``thinpart similar``: parts with similar walls, fill and box, and why."""

import argparse
import json
import os
import sys

from ..core.errors import ThinPartError
from ..workflow.find_parts import read_records
from ..workflow.kept_notes import info_file_of, the_record
from ..workflow.similar_parts import similar_parts
from .library import libraries
from .stored_rows import print_stored
from .terminal_table import TableColumn


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("path", metavar="PART",
                        help="a document, or its info file; is measured where it is not stored")
    parser.add_argument("roots", nargs="+", metavar="ROOT", help="folders to look in, with all below them")
    parser.add_argument("--part", metavar="NAME",
                        help="name or label of the part, where the document has several")
    parser.add_argument("-n", type=_whole, default=10, metavar="N", help="how many (default: %(default)s)")
    parser.add_argument("--same-size", type=_factor, nargs="?", const=1.25, metavar="FACTOR",
                        help="only parts whose diagonal differs by no more than this factor (1.25)")
    parser.add_argument("--json", action="store_true",
                        help="print one JSON record per part, with score and reasons")


def run(options):
    """Find similar parts and return the exit status."""
    record, itself = _wanted(options)
    with libraries(options.roots) as opened:
        found = similar_parts(opened.indexes, record, options.n, options.same_size, itself)
        if options.json:
            for each, line in zip(found, read_records(each.part for each in found)):
                print(json.dumps({"score": round(each.score, 2), "reasons": each.reasons, **line},
                                 ensure_ascii=False))
        elif found:
            by_part = {each.part: each for each in found}
            print_stored([each.part for each in found], sys.stdout, opened.folder, (
                TableColumn("Score", lambda part: f"{by_part[part].score:.0f} %", True),
                TableColumn("Why", lambda part: by_part[part].reasons),
            ))
        else:
            print("There is no other part in these folders.", file=sys.stderr)
    return opened.status


def _wanted(options):
    """The record to compare with, and what it is called in a library."""
    try:
        info_file = info_file_of(options.path)
    except ThinPartError:
        return _measured(options), None
    record = the_record(info_file, options.part)
    return record, (os.path.realpath(info_file), record["name"])


def _measured(options):
    from ..workflow.analyse_file import FileTask
    from ..workflow.kept_notes import one_of
    from ..workflow.worker_pool import Limits, analyse_files

    outcome, = analyse_files([FileTask(options.path)], Limits())
    if "error" in outcome:
        raise ThinPartError(outcome["error"]["message"], outcome["error"]["kind"])
    return one_of(outcome["parts"], options.part, options.path)


def _whole(text):
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1 on")
    return int(text)


def _factor(text):
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 1.0 <= value < float("inf"):
        raise argparse.ArgumentTypeError(f"'{text}' is not a factor of 1 or more")
    return value
