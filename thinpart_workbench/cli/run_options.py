# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of the commands that measure files: file selection, measurement, limits and control."""

import argparse
import os
from dataclasses import fields

from ..api.classification import cluster_address
from ..api.file_run import FileRun
from ..core.analysis_limits import LEAST_MEGABYTES, Limits
from ..core.analysis_settings import (
    ACCURACIES,
    BOXES,
    DEFAULT_PROFILE,
    LOCAL,
    MEASURES,
    RAY,
    SHOWN_MEASURES,
    SPHERE,
    STANDARD,
    AnalysisSettings,
)
from ..core.errors import ThinPartError
from ..core.message import message
from ..storage.common_folder import common_folder
from ..system.file_paths import is_below
from .output_options import check_with_documents

_MOST = 10 ** 9
"""Greatest value of a limit. More than any machine has; still greater numbers would overflow."""


_LIMITS = Limits()


def add_file_options(parser):
    """Declare the options that select files."""
    parser.add_argument("paths", nargs="+", metavar="PATH", help="a part, or a folder of parts")
    parser.add_argument("--include", metavar="GLOB", action="append", default=[],
                        help="in folders, take only files whose name matches GLOB; a GLOB with a slash is compared "
                             "with the path below the folder; may be given several times")
    parser.add_argument("--exclude", metavar="GLOB", action="append", default=[],
                        help="in folders, leave out files that match GLOB, in the same way")


def add_info_folder_options(parser, meaning):
    """Declare the options for the location of the info files."""
    parser.add_argument("--info-dir", metavar="DIR", help=meaning)
    parser.add_argument("--info-tree", metavar="TOP",
                        help="the folder whose tree --info-dir mirrors (default: the folder that all "
                             "PATHs share)")


def info_tree(options):
    """Top folder of the tree that the folder for info files mirrors, str.

    Raises a ThinPartError, kind ``usage``, if not all PATHs lie below it.
    """
    shared = common_folder(options.paths)
    if options.info_tree is None:
        return shared
    top = os.path.abspath(options.info_tree) if options.info_tree != os.sep else os.sep
    if not is_below(shared, top):
        raise ThinPartError(
            message("{folder} does not lie below {top}: name a folder after --info-tree that holds all PATHs.",
                    folder=shared, top=top),
            "usage")
    return top


def add_measurement_options(parser, has_pictures=False):
    """Declare the options for measuring and judging parts, and for what their pictures show if there are some."""
    parser.add_argument("--profile", default=DEFAULT_PROFILE, metavar="NAME-or-FILE",
                        help="the thresholds to judge by (default: %(default)s)")
    measures, meaning = MEASURES, "how thickness is measured: rays (default), or the paper's pair rule"
    if has_pictures:
        measures += (SPHERE, LOCAL)
        meaning += ("; sphere: the pictures show the largest ball inside that touches the surface, local: the largest that "
                    "reaches it; verdicts are by rays")
    parser.add_argument("--measure", choices=measures, default=MEASURES[0], help=meaning)
    parser.add_argument("--box", choices=BOXES, default=BOXES[0],
                        help="bounding box: minimal (default), or the paper's principal axes")
    parser.add_argument("--accuracy", choices=ACCURACIES, default=STANDARD,
                        help="how finely parts are measured at first: only as the verdict needs, standard (default), "
                             "or fine; where the error of a quantity could turn the verdict, a part is measured again, "
                             "more finely")
    for option, what in (("linear", "chord error of the surface mesh, as a share of the diagonal"),
                         ("angular", "greatest angle between neighbouring facets, in degrees")):
        parser.add_argument(f"--{option}-deflection", metavar="X", type=float,
                            help=f"{what} (default: that of the accuracy, "
                                 f"{getattr(AnalysisSettings, f'{option}_deflection'):g} at standard)")


def add_limit_options(parser, limits=_LIMITS, when=""):
    """Declare the options that limit processes, time and memory, with the defaults of `limits`; help begins with `when`."""
    default = {field.name: getattr(limits, field.name) for field in fields(Limits)}
    parser.add_argument("--jobs", metavar="N", default=os.cpu_count() or 1,
                        type=_number("--jobs", int, "a whole number", 1),
                        help=when + "files measured at the same time (default: one per processor)")
    parser.add_argument("--timeout", metavar="S", default=default["seconds"],
                        type=_number("--timeout", float, "a number of seconds", 0.001),
                        help=when + "time limit per file, in seconds (default: %(default)g)")
    parser.add_argument("--memory", metavar="MB", default=default["megabytes"],
                        type=_number("--memory", int, "a whole number of megabytes", LEAST_MEGABYTES),
                        help=when + "memory limit per file, in MB (default: %(default)s)")


def add_cluster_option(parser, what="measure"):
    """Declare the option that names a cluster, where it does `what`."""
    parser.add_argument("--dask", metavar="ADDRESS", type=_cluster,
                        help=what + " on the workers of a Dask cluster that see the same files, one file per "
                             "worker thread at a time; ADDRESS is its scheduler, tcp://HOST:PORT")


def _cluster(text):
    try:
        return cluster_address(text)
    except ThinPartError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def add_control_options(parser):
    """Declare the options for programs that run the command line."""
    parser.add_argument("--json", action="store_true",
                        help="print one JSON record per part or failure, progress on stderr")
    parser.add_argument("--control", action="store_true",
                        help="take the commands pause, resume and stop from standard input; its end stops the run")


def settings_of(options):
    """AnalysisSettings from the options of `add_measurement_options`."""
    given = {name: getattr(options, name) for name in ("linear_deflection", "angular_deflection")}
    return AnalysisSettings.at(
        options.accuracy, **{name: value for name, value in given.items() if value is not None},
        measure=options.measure if options.measure in MEASURES else MEASURES[0], box=options.box)


def shown_measure_of(options):
    """One of `SHOWN_MEASURES`, from the options of `add_measurement_options`."""
    return options.measure if options.measure in SHOWN_MEASURES else RAY


def limits_of(options):
    """Limits from the options of `add_limit_options`."""
    return Limits(options.timeout, options.memory, options.jobs)


def new_file_run(options, control, report, only=None):
    """Find the documents that the options of `add_file_options` select, and return their `FileRun`.

    `only` lists paths to use instead of the given ones. Raises as `FileRun` and `check_outputs`.
    """
    run = FileRun(options.paths, options.include, options.exclude, only, control, report.found)
    check_with_documents(options, (document.path for document in run.documents))
    return run


def _number(option, kind, what, least):
    """A parser for an option's value, which rejects invalid values with a sentence."""
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
