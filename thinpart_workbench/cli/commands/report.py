# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart report``: write a page with pictures per part, and an overview; or one page about a library."""

import argparse
import sys
from contextlib import closing

from ...api.report.library_report import library_report
from ...api.report.report_folder import LANGUAGES, ReportFolder
from ...core.errors import ThinPartError
from ...core.foreign_text import printable
from ...core.judging.criteria import load_profile
from ...core.length_unit import MILLIMETRE, UNITS
from ...core.message import message
from ...storage.common_folder import common_folder
from ...storage.info.info_file import info_path_getter
from ..check_options import PartChecks, add_check_options, checked_limits
from ..file_run import analyse_and_report, controlled_run
from ..output_options import FOLDER, add_output_option, replacing
from ..run_options import (
    add_control_options,
    add_file_options,
    add_info_folder_options,
    add_limit_options,
    add_measurement_options,
    info_tree,
    limits_of,
    new_file_run,
    settings_of,
    shown_measure_of,
)
from ..run_report import standard_output

_OF_DOCUMENTS = ("include", "exclude", "info_dir", "info_tree", "profile", "measure", "box", "accuracy", "linear_deflection",
                 "angular_deflection", "check", "limits", "jobs", "timeout", "memory", "json", "control")
"""Options that mean nothing where no document is measured."""


def add_arguments(parser):
    """Declare the options."""
    add_file_options(parser)
    parser.add_argument("--library", action="store_true",
                        help="write one page about folders of classified parts instead: counts, a map by thickness and "
                             "fill, what there is more than once, families, and a table to search; reads info files only")
    add_output_option(parser, "-o", "--output", mark=FOLDER, metavar="DIR", required=True,
                      help="folder of the report: a new or an empty one, or that of an earlier report, "
                           "whose pages are replaced")
    parser.add_argument("--language", choices=LANGUAGES, default=LANGUAGES[0],
                        help="of the pages (default: %(default)s); the tables are the same in all")
    parser.add_argument("--unit", choices=tuple(UNITS), default=MILLIMETRE.symbol,
                        help="of all lengths on the pages (default: %(default)s); the tables are in mm")
    add_info_folder_options(parser, "take notes that are kept with the parts from the info files in this folder "
                           "instead of those beside the parts")
    add_measurement_options(parser, has_pictures=True)
    add_check_options(parser)
    add_limit_options(parser)
    add_control_options(parser)
    parser.set_defaults(of_documents={name: parser.get_default(name) for name in _OF_DOCUMENTS})


def run(options):
    """Make the report and return the exit status."""
    if options.library:
        return _library(options)
    profile = load_profile(options.profile).content
    checks = PartChecks(checked_limits(options))
    with controlled_run(options) as (report, control, undisturbed):
        file_run = new_file_run(options, control, report)
        tree = common_folder(options.paths)
        folder = ReportFolder(options.output, tree, profile, info_path_getter(options.info_dir, info_tree(options)),
                              checks.limits, shown_measure_of(options), language=options.language, unit=UNITS[options.unit],
                              **replacing(options))
        with closing(folder):
            failed = analyse_and_report(file_run, report, folder.add, checks=checks, profile=profile,
                                        settings=settings_of(options), limits=limits_of(options),
                                        pages_for=folder.pages_for)
            with undisturbed():
                folder.finish()
    if not options.json:
        with standard_output() as stream:
            stream.write(f"{printable(folder.overview)}\n")
    return checks.exit_status(1 if failed else 0)


def _library(options):
    """Write the page about a library and return the exit status."""
    for name, default in options.of_documents.items():
        if getattr(options, name) != default:
            raise ThinPartError(
                message("--library reads info files only, and takes no {option}: leave it out.",
                        option=f"--{name.replace('_', '-')}"), "usage")
    with controlled_run(argparse.Namespace(json=False, control=False)) as (_, control, _undisturbed):
        written = library_report(options.paths, options.output, language=options.language, unit=options.unit,
                                 control=control, report=_progress, **replacing(options))
    for problem in written.problems:
        print(f"thinpart: {printable(problem.message)}", file=sys.stderr)
    if written.unclassified:
        which = "1 document has no info file and is" if written.unclassified == 1 else \
            f"{written.unclassified} documents have no info file and are"
        print(f"thinpart: {which} not on the page: classify first what is to be on it.", file=sys.stderr)
    with standard_output() as stream:
        stream.write(f"{printable(written.page)}\n")
    return 1 if any(problem.kind == "folder" for problem in written.problems) else 0


def _progress(done, total):
    if sys.stderr.isatty() and total:
        print(f"\rcomparing: {done} of {total}", end="\n" if done == total else "", file=sys.stderr)
