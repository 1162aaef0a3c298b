"""``thinpart classify``: parts and folders to a table, JSON lines, CSV and info files."""

import argparse
import errno
import os
import tempfile
from contextlib import closing
from dataclasses import fields
from pathlib import Path

from ..core.analysis_settings import BOXES, MEASURES, AnalysisSettings
from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..storage.info_file import SUFFIX
from ..storage.part_table import FIRST_COLUMNS
from ..workflow.analyse_file import FileTask
from ..workflow.cluster import analyse_files_on_cluster, cluster_address
from ..workflow.find_documents import ENDINGS, NameFilter, common_folder, find_documents
from ..workflow.run_control import RunControl
from ..workflow.run_plan import info_place, plan_run
from ..workflow.run_progress import RunProgress
from ..workflow.worker_pool import LEAST_MEGABYTES, Limits, analyse_files, failure
from .control_input import listen
from .part_rows import PartRows
from .run_report import new_report, standard_output
from .stop_signals import stop_signals


def add_arguments(parser):
    """Declare the options."""
    default = {each.name: each.default for each in fields(Limits)}
    parser.add_argument("paths", nargs="+", metavar="PATH", help="a part, or a folder of parts")
    parser.add_argument("--json", action="store_true",
                        help="print one JSON record per part or failure, progress on stderr")
    parser.add_argument("--csv", metavar="FILE", help="write the table to a CSV file as well")
    parser.add_argument("--include", metavar="GLOB", action="append", default=[],
                        help="of folders, take only files whose name it matches; with a slash in it, "
                             "whose path below the folder it matches; may be given several times")
    parser.add_argument("--exclude", metavar="GLOB", action="append", default=[],
                        help="of folders, leave out what it matches, in the same way")
    parser.add_argument("--only", metavar="LIST",
                        help="classify only the files that LIST names (absolute paths, each ended by a "
                             "NUL byte); the PATHs then only say which tree --info-dir mirrors")
    parser.add_argument("--control", action="store_true",
                        help="obey the lines pause, resume and stop on standard input; its end stops")
    parser.add_argument("--no-info", action="store_true", help="write no info files")
    parser.add_argument("--info-dir", metavar="DIR",
                        help="keep the info files in this folder instead of beside the parts")
    parser.add_argument("--info-tree", metavar="TOP",
                        help="the folder whose tree --info-dir mirrors (default: the folder that all "
                             "PATHs share)")
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
    for option, what in (("linear", "chord error of the surface mesh, as a share of the diagonal"),
                         ("angular", "degrees between its facets")):
        parser.add_argument(f"--{option}-deflection", metavar="X", type=float,
                            default=getattr(AnalysisSettings, f"{option}_deflection"),
                            help=f"{what} (default: %(default)g)")
    parser.add_argument("--jobs", metavar="N", default=os.cpu_count() or 1,
                        type=_number("--jobs", int, "a whole number", 1),
                        help="files at once (default: one per processor)")
    parser.add_argument("--dask", metavar="ADDRESS", type=_cluster,
                        help="have it done by the workers of a Dask cluster that see the same files, as "
                             "many at once as they have threads; tcp://HOST:PORT of its scheduler")
    parser.add_argument("--timeout", metavar="S", default=default["seconds"],
                        type=_number("--timeout", float, "a number of seconds", 0.001),
                        help="seconds that one file may take (default: %(default)g)")
    parser.add_argument("--memory", metavar="MB", default=default["megabytes"],
                        type=_number("--memory", int, "a whole number of megabytes", LEAST_MEGABYTES),
                        help="memory that one file may take (default: %(default)s)")


def run(options):
    """Classify and return the exit status."""
    report = new_report(options.json)
    control = RunControl(report.state)
    rows = PartRows(common_folder(options.paths), table=not options.json, csv=bool(options.csv))
    try:
        with stop_signals(control) as undisturbed, report:
            if options.control:
                listen(control)
            try:
                failed = _classify(options, control, report, rows)
            finally:
                # Also after Ctrl-C: what was done is kept.
                if options.csv and rows:
                    with undisturbed():
                        rows.write_csv(options.csv)
    finally:
        if not options.json and rows:
            with standard_output() as stream:
                rows.print_table(stream)
    return 1 if failed else 0


def _classify(options, control, report, rows):
    """Find the documents and analyse them; the number of those that failed."""
    new_task = _new_task(options)
    documents, failures = _search(options, control, report)
    if options.csv:
        _check_table(options.csv, documents)
    if options.info_dir is not None and not options.no_info:
        _check_info_folder(options.info_dir)
    planned = plan_run(documents, new_task, _info_place(options), options.jobs)
    progress = RunProgress({each.task.file: (each.bytes, each.unchanged) for each in planned},
                           options.jobs)
    unkept = {each.task.file: each.problem for each in planned if each.problem is not None}
    control.enter("paused" if control.paused else "running")
    report.started(progress)
    for outcome in failures:
        rows.add(outcome)
        report.failures(outcome)
    tasks = [each.task for each in planned]
    with closing(_outcomes(tasks, options, control, progress)) as outcomes:
        for outcome in outcomes:
            if outcome["file"] in unkept and "error" not in outcome:
                error = unkept[outcome["file"]]
                outcome["failures"] = [*outcome["failures"], {
                    "part": None, "label": None, "kind": error.kind, "message": str(error)}]
            rows.add(outcome)
            progress.add(outcome)
            report.ended(outcome, progress)
    return progress.failed + len(failures)


def _outcomes(tasks, options, control, progress):
    """What analyses the files: worker processes of this machine, or a cluster."""
    limits = Limits(options.timeout, options.memory, options.jobs)
    if options.dask is None:
        return analyse_files(tasks, limits, control)

    def threads_seen(threads):
        progress.jobs = threads

    return analyse_files_on_cluster(options.dask, tasks, limits, control, threads_seen)


def _search(options, control, report):
    """The documents, and outcomes for what could not be searched."""
    def searched(count):
        control.check()
        report.found(count)

    control.enter("searching")
    names = NameFilter(tuple(options.include), tuple(options.exclude))
    paths = options.paths if options.only is None else _listed(options)
    found = find_documents(paths, names, searched)
    control.check()
    if not found.documents and not found.failures:
        raise ThinPartError(
            f"There are no parts in {', '.join(options.paths)}: name a CAD file or a folder "
            "that holds some.", "empty",
        )
    return found.documents, [failure(path, error.kind, str(error)) for path, error in found.failures]


def _listed(options):
    """The files that the list after --only names."""
    try:
        content = Path(options.only).read_bytes()
    except OSError as error:
        raise ThinPartError(
            f"The list {options.only} cannot be read ({error.strerror}): give a file to --only that "
            "names the parts.", "usage",
        ) from None
    paths = [os.fsdecode(each) for each in content.split(b"\0") if each]
    tree = os.path.join(_tree(options), "")
    for path in paths:
        if not os.path.isabs(path):
            raise ThinPartError(
                f"The list {options.only} names {path!r}, which is no absolute path: write whole "
                "paths, each ended by a NUL byte.", "usage")
        if options.info_dir is not None and not os.path.abspath(path).startswith(tree):
            # Its info file would lie outside of the folder that is meant for info files.
            raise ThinPartError(
                f"The list {options.only} names {path}, which does not lie below {tree}: name a PATH "
                "that holds it, or leave out --info-dir.", "usage")
    return paths


def _new_task(options):
    settings = AnalysisSettings(
        linear_deflection=options.linear_deflection, angular_deflection=options.angular_deflection,
        measure=options.measure, box=options.box)
    profile = load_profile(options.profile).content
    thumbnails = not (options.no_info or options.no_thumbnails)
    return lambda file, info: FileTask(file, info, settings, profile, options.force, thumbnails)


def _info_place(options):
    if options.no_info:
        return lambda file: None
    return info_place(options.info_dir, _tree(options))


def _tree(options):
    """Top of the tree that the folder for info files mirrors."""
    shared = common_folder(options.paths)
    if options.info_tree is None:
        return shared
    top = os.path.abspath(options.info_tree)
    if os.path.commonpath([top, shared]) != top:
        raise ThinPartError(
            f"{shared} does not lie below {top}: name a folder after --info-tree that holds all PATHs.",
            "usage")
    return top


def _check_info_folder(folder):
    """Refuse a folder for info files before 100,000 files were measured for it."""
    try:
        if os.path.lexists(folder) and not os.path.isdir(folder):
            raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR))
        os.makedirs(folder, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise ThinPartError(
            f"Info files cannot be written into {folder} ({error.strerror}): give another folder to "
            "--info-dir.", "usage",
        ) from None


def _check_table(path, documents):
    """Refuse a place for the table that cannot be written or that holds something else."""
    path, place = Path(path), os.path.realpath(path)
    names = (*ENDINGS, SUFFIX)
    same = any(place == os.path.realpath(each.path) for each in documents
               if not each.path.lower().endswith(names))
    if same or path.name.lower().endswith(names) or place.lower().endswith(names):
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


def _cluster(text):
    try:
        return cluster_address(text)
    except ThinPartError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


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
