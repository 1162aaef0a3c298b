# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart duplicates``: parts that libraries have more than once, with what shows it."""

import argparse
import os
import sys

from ...api.libraries import duplicates, families
from ...core.analysis_settings import DEFAULT_PROFILE, AnalysisSettings
from ...core.foreign_text import json_text, printable
from ...core.judging.criteria import load_profile
from ...core.kinds.file_marks import TABLE
from ...storage.common_folder import common_folder
from ...storage.info.info_file import info_path
from ...storage.part_table import SUBJECT, TableForm, write_table
from ..file_run import analyse_and_report, controlled_run
from ..output_options import add_output_option, replacing
from ..run_options import add_cluster_option, add_limit_options, limits_of, new_file_run
from ..terminal_table import TableColumn, print_table

_MEASURES = ("compared", "greatest_mm", "same_share", "scale", "says")

_TABLE = TableForm((*SUBJECT, "group", "kind", *_MEASURES), lambda row: row)


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("paths", nargs="+", metavar="ROOT",
                        help="folders of parts, with all below them; what has no info file yet is classified first")
    parser.add_argument("--stored", action="store_true",
                        help="read no documents: only parts with info files, compared by what these keep")
    parser.add_argument("--families", action="store_true",
                        help="list families instead: parts whose faces are the same but for their sizes, with what varies")
    parser.add_argument("--json", action="store_true", help="print one JSON object per group")
    add_output_option(parser, "--csv", mark=TABLE, metavar="FILE", help="write a table of the groups to a CSV file as well")
    add_limit_options(parser)
    add_cluster_option(parser, "classify what has no info file yet, and compare documents,")
    parser.set_defaults(include=[], exclude=[])


def run(options):
    """Find duplicates and return the exit status."""
    # What fails is named on stderr: stdout is for the groups.
    with controlled_run(argparse.Namespace(json=False, control=False)) as (report, control, _):
        failed = 0 if options.stored else _classify_new(options, control, report)
        if options.families:
            found = families(options.paths)
            return _families(options, found) or (1 if failed else 0)
        limits = limits_of(options)
        found = duplicates(options.paths, reads_documents=not options.stored, jobs=limits.jobs, timeout=limits.seconds,
                           memory=limits.megabytes, control=control, report=_progress, cluster=options.dask)
    for problem in found.problems:
        print(f"thinpart: {printable(problem.message)}", file=sys.stderr)
    for failure in found.failures:
        said = printable(failure["error"]["message"])
        print(f"thinpart: {said} It is compared by what its info file keeps.", file=sys.stderr)
    lines = list(found.lines())
    if options.json:
        for line in lines:
            print(json_text(line))
    else:
        _print(lines, found, common_folder(options.paths))
    if options.csv:
        rows = [_row(line, part) for line in lines for part in line["parts"]]
        write_table(options.csv, _TABLE, [_TABLE.text(rows)], **replacing(options))
    if found.without_form:
        print(f"thinpart: {found.without_form} parts were measured by an earlier version and are not compared: 'thinpart "
              "classify' measures their documents again.", file=sys.stderr)
    return 1 if failed or found.failures or any(problem.kind == "folder" for problem in found.problems) else 0


def _families(options, found):
    for problem in found.problems:
        print(f"thinpart: {printable(problem.message)}", file=sys.stderr)
    folder = common_folder(options.paths)
    for line in found.lines():
        if options.json:
            print(json_text(line))
            continue
        columns = [TableColumn(name, lambda part, name=name: f"{part['evidence'][name]:.4g}", True)
                   for name in line["varies"]]
        print_table(sys.stdout, (
            TableColumn("Family", lambda part, number=line["group"]: str(number)),
            TableColumn("File", lambda part: os.path.relpath(part["file"], folder)),
            TableColumn("Part", lambda part: part["label"]), *columns), lambda parts=line["parts"]: parts)
    print(f"{len(found)} families.", file=sys.stderr)
    return 1 if any(problem.kind == "folder" for problem in found.problems) else 0


def _classify_new(options, control, report):
    """Classify the documents that have no info file; returns the number of those that failed."""
    everything = new_file_run(options, control, report)
    new = [document.path for document in everything.documents if not os.path.lexists(info_path(document.path))]
    if not new:
        return 0
    return analyse_and_report(
        new_file_run(options, control, report, new), report, lambda outcome: None,
        profile=load_profile(DEFAULT_PROFILE).content, settings=AnalysisSettings(), limits=limits_of(options),
        info_for=info_path, force=False, thumbnails=True, cluster=options.dask)


def _progress(done, total):
    if sys.stderr.isatty() and total:
        print(f"\rcomparing: {done} of {total}", end="\n" if done == total else "", file=sys.stderr)


def _print(lines, found, folder):
    if lines:
        rows = [(line, part) for line in lines for part in line["parts"]]
        print_table(sys.stdout, (
            TableColumn("Group", lambda row: str(row[0]["group"])),
            TableColumn("Kind", lambda row: "keep" if not row[1]["evidence"] else row[1]["kind"]),
            TableColumn("File", lambda row: os.path.relpath(row[1]["file"], folder)),
            TableColumn("Part", lambda row: row[1]["label"]),
            TableColumn("Evidence", lambda row: row[1]["evidence"].get("says", "")),
        ), lambda: rows)
    counts = {kind: sum(len(line["parts"]) - 1 for line in lines if line["kind"] == kind)
              for kind in dict.fromkeys(line["kind"] for line in lines)}
    said = ", ".join(f"{count} {kind}" for kind, count in counts.items()) or "none of them is there twice"
    parts = "1 part" if found.compared == 1 else f"{found.compared} parts"
    print(f"{parts} compared: {said}.", file=sys.stderr)


def _row(line, part):
    return (part["file"], part["name"], part["label"], line["group"], part["kind"],
            *(part["evidence"].get(key) for key in _MEASURES))
