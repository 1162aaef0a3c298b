"""Options of the commands that measure files: which files, how, and what each may cost."""

import argparse
import os
from dataclasses import fields

from ..core.analysis_settings import BOXES, MEASURES, AnalysisSettings
from ..core.errors import ThinPartError
from ..system.file_paths import is_below
from ..workflow.find_documents import NameFilter, common_folder, find_documents
from ..workflow.worker_pool import LEAST_MEGABYTES, Limits, failure

_MOST = 10 ** 9
"""No machine has so much of anything; what lies above could not be handed on as a number."""


def add_choice(parser):
    """Declare the options that say which files are taken."""
    parser.add_argument("paths", nargs="+", metavar="PATH", help="a part, or a folder of parts")
    parser.add_argument("--include", metavar="GLOB", action="append", default=[],
                        help="of folders, take only files whose name it matches; with a slash in it, "
                             "whose path below the folder it matches; may be given several times")
    parser.add_argument("--exclude", metavar="GLOB", action="append", default=[],
                        help="of folders, leave out what it matches, in the same way")


def add_info_place(parser, meaning):
    """Declare the options that say where the info files lie."""
    parser.add_argument("--info-dir", metavar="DIR", help=meaning)
    parser.add_argument("--info-tree", metavar="TOP",
                        help="the folder whose tree --info-dir mirrors (default: the folder that all "
                             "PATHs share)")


def info_tree(options):
    """Top of the tree that the folder for info files mirrors, str.

    Raises
    ------
    ThinPartError
        kind ``usage`` where not all PATHs lie below it.
    """
    shared = common_folder(options.paths)
    if options.info_tree is None:
        return shared
    top = os.path.abspath(options.info_tree) if options.info_tree != os.sep else os.sep
    if not is_below(shared, top):
        raise ThinPartError(
            f"{shared} does not lie below {top}: name a folder after --info-tree that holds all PATHs.",
            "usage")
    return top


def add_measuring(parser):
    """Declare the options that say how parts are measured and judged."""
    parser.add_argument("--profile", default="paper", metavar="NAME-or-FILE",
                        help="the thresholds to judge by (default: paper)")
    parser.add_argument("--measure", choices=MEASURES, default=MEASURES[0],
                        help="how thickness is measured: rays (default), or the paper's pair rule")
    parser.add_argument("--box", choices=BOXES, default=BOXES[0],
                        help="bounding box: minimal (default), or the paper's principal axes")
    for option, what in (("linear", "chord error of the surface mesh, as a share of the diagonal"),
                         ("angular", "degrees between its facets")):
        parser.add_argument(f"--{option}-deflection", metavar="X", type=float,
                            default=getattr(AnalysisSettings, f"{option}_deflection"),
                            help=f"{what} (default: %(default)g)")


def add_limits(parser):
    """Declare the options that say what a file may cost."""
    default = {each.name: each.default for each in fields(Limits)}
    parser.add_argument("--jobs", metavar="N", default=os.cpu_count() or 1,
                        type=_number("--jobs", int, "a whole number", 1),
                        help="files at once (default: one per processor)")
    parser.add_argument("--timeout", metavar="S", default=default["seconds"],
                        type=_number("--timeout", float, "a number of seconds", 0.001),
                        help="seconds that one file may take (default: %(default)g)")
    parser.add_argument("--memory", metavar="MB", default=default["megabytes"],
                        type=_number("--memory", int, "a whole number of megabytes", LEAST_MEGABYTES),
                        help="memory that one file may take (default: %(default)s)")


def add_conversation(parser):
    """Declare the options for programs that start this one."""
    parser.add_argument("--json", action="store_true",
                        help="print one JSON record per part or failure, progress on stderr")
    parser.add_argument("--control", action="store_true",
                        help="obey the lines pause, resume and stop on standard input; its end stops")


def settings_of(options):
    """AnalysisSettings of `add_measuring`."""
    return AnalysisSettings(
        linear_deflection=options.linear_deflection, angular_deflection=options.angular_deflection,
        measure=options.measure, box=options.box)


def limits_of(options):
    """Limits of `add_limits`."""
    return Limits(options.timeout, options.memory, options.jobs)


def search_documents(options, control, report, paths=None):
    """The documents of `add_choice`, and outcomes for what could not be searched.

    Parameters
    ----------
    options : Namespace
    control : RunControl
    report : Report
    paths : list of str, optional
        Taken in place of those that were given.

    Raises
    ------
    ThinPartError
        kind ``empty`` where there are none.
    """
    def searched(count):
        control.check()
        report.found(count)

    control.enter("searching")
    names = NameFilter(tuple(options.include), tuple(options.exclude))
    found = find_documents(options.paths if paths is None else paths, names, searched)
    control.check()
    if not found.documents and not found.failures:
        raise ThinPartError(
            f"There are no parts in {', '.join(options.paths)}: name a CAD file or a folder "
            "that holds some.", "empty",
        )
    return found.documents, [failure(path, error.kind, str(error)) for path, error in found.failures]


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
