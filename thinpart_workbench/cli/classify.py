"""``thinpart classify``: parts and folders to a table, JSON lines, CSV and info files."""

import argparse
import errno
import json
import os
import sys
from dataclasses import fields
from pathlib import Path

from ..core.analysis_settings import BOXES, MEASURES, AnalysisSettings
from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..storage.info_file import SUFFIX, info_path
from ..workflow.analyse_file import FileTask
from ..workflow.find_documents import ENDINGS, common_folder, find_documents
from ..workflow.worker_pool import LEAST_MEGABYTES, Limits, analyse_files
from .part_rows import FIRST_COLUMNS, print_table, write_csv


def add_arguments(parser):
    """Declare the options."""
    default = {each.name: each.default for each in fields(Limits)}
    parser.add_argument("paths", nargs="+", metavar="PATH", help="a part, or a folder of parts")
    parser.add_argument("--json", action="store_true",
                        help="print one JSON record per part or failure, progress on stderr")
    parser.add_argument("--csv", metavar="FILE", help="write the table to a CSV file as well")
    parser.add_argument("--no-info", action="store_true", help="write no info files")
    parser.add_argument("--info-dir", metavar="DIR",
                        help="keep the info files in this folder instead of beside the parts")
    parser.add_argument("--no-thumbnails", action="store_true",
                        help="keep no pictures of the parts in the cache")
    parser.add_argument("--force", action="store_true",
                        help="measure again even what has not changed")
    parser.add_argument("--profile", default="paper", metavar="NAME-or-FILE",
                        help="the thresholds to judge by (default: paper)")
    parser.add_argument("--measure", choices=MEASURES, default=MEASURES[0],
                        help="how thickness is measured: rays (default), or the paper's pair rule")
    parser.add_argument("--box", choices=BOXES, default=BOXES[0],
                        help="bounding box: minimal (default), or the paper's principal axes")
    parser.add_argument("--jobs", metavar="N", default=os.cpu_count() or 1,
                        type=_number("--jobs", int, "a whole number", 1),
                        help="files at once (default: one per processor)")
    parser.add_argument("--timeout", metavar="S", default=default["seconds"],
                        type=_number("--timeout", float, "a number of seconds", 0.001),
                        help="seconds that one file may take (default: %(default)g)")
    parser.add_argument("--memory", metavar="MB", default=default["megabytes"],
                        type=_number("--memory", int, "a whole number of megabytes", LEAST_MEGABYTES),
                        help="memory that one file may take (default: %(default)s)")


def run(options):
    """Classify and return the exit status."""
    documents = find_documents(options.paths)
    if not documents:
        raise ThinPartError(
            f"There are no parts in {', '.join(options.paths)}: name a CAD file or a folder "
            "that holds some.", "empty",
        )
    tree = common_folder(options.paths)
    tasks = [_task(document, tree, options) for document in documents]
    if options.csv:
        _check_table(options.csv, documents)
    limits = Limits(options.timeout, options.memory, options.jobs)
    outcomes = []
    try:
        for outcome in analyse_files(tasks, limits):
            outcomes.append(outcome)
            _report(outcome, len(outcomes), len(tasks), options.json)
    finally:
        # Also after Ctrl-C: what was done is shown and kept.
        outcomes.sort(key=lambda outcome: outcome["file"])
        if not options.json and outcomes:
            print_table(outcomes, sys.stdout, tree)
        if options.csv:
            write_csv(outcomes, options.csv, tree)
    return 1 if any("error" in each or each["failures"] for each in outcomes) else 0


def _task(document, tree, options):
    settings = AnalysisSettings(measure=options.measure, box=options.box)
    info = None
    if not options.no_info:
        info = os.fspath(info_path(document, options.info_dir, tree))
    return FileTask(os.fspath(document), info, settings,
                    load_profile(options.profile).content, options.force,
                    not (options.no_info or options.no_thumbnails))


def _report(outcome, done, total, as_json):
    """One file has ended: its failures to stderr, its records to stdout."""
    if "error" in outcome:
        _print_failure(outcome["file"], outcome["error"])
    for each in outcome.get("failures", ()):
        _print_failure(outcome["file"], each)
    if not as_json:
        if total > 1 and sys.stderr.isatty():
            print(f"{done} of {total}: {outcome['file']}", file=sys.stderr)
        return
    for line in json_lines(outcome):
        print(json.dumps(line, ensure_ascii=False), flush=True)
    print(json.dumps({"progress": {"done": done, "total": total, "file": outcome["file"]}}),
          file=sys.stderr, flush=True)


def json_lines(outcome):
    """The records that ``--json`` prints for one file: parts, then failures."""
    file = outcome["file"]
    if "error" in outcome:
        return [{"file": file, "error": outcome["error"]}]
    lines = [{"file": file, **part} for part in outcome["parts"]]
    for each in outcome["failures"]:
        error = {"kind": each["kind"], "message": each["message"]}
        lines.append({"file": file, "name": each["part"], "label": each.get("label"),
                      "error": error})
    return lines


_OPTION_FOR = {"info_write": "--info-dir", "timeout": "--timeout", "memory": "--memory"}


def _print_failure(file, error):
    option = f" See {_OPTION_FOR[error['kind']]}." if error["kind"] in _OPTION_FOR else ""
    print(f"thinpart: {file}: {error['message']}{option} [{error['kind']}]", file=sys.stderr,
          flush=True)


def _check_table(path, documents):
    """Refuse a place for the table that cannot be written or that holds something else."""
    path = Path(path)
    same = any(os.path.realpath(path) == os.path.realpath(each) for each in documents)
    if same or path.name.lower().endswith((*ENDINGS, SUFFIX)):
        raise ThinPartError(
            f"{path} is a part, not a table, and was left as it is: name a .csv file after --csv.",
            "usage",
        )
    try:
        if path.exists():
            with open(path, "rb") as file:
                start = file.read(len(FIRST_COLUMNS) + 3)
            if start.strip() and FIRST_COLUMNS not in start:
                raise ThinPartError(
                    f"{path} is there already and is no table of ThinPart: it was left as it is; "
                    "give another file to --csv.", "usage",
                )
        if path.is_dir() or not os.access(path if path.exists() else path.absolute().parent, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    except OSError as error:
        raise ThinPartError(
            f"The table {path} cannot be written ({error.strerror}): give another file to --csv.",
            "usage",
        ) from None


_MOST = 10 ** 9
"""No machine has so much of anything; what lies above could not be handed on as a number."""


def _number(option, kind, what, least):
    """A parser of an option's value; what it does not take it answers with a sentence."""
    def parse(text):
        try:
            value = kind(text)
        except ValueError:
            value = None
        if value is None or not least <= value <= _MOST:
            raise argparse.ArgumentTypeError(
                f"'{text}' is not allowed: {option} takes {what} from {least:g} to {_MOST}.")
        return value

    return parse
