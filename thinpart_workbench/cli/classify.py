"""``thinpart classify``: parts and folders to a table, JSON lines, CSV and info files."""

import argparse
import errno
import os
import tempfile
from pathlib import Path

from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..storage.info_file import SUFFIX
from ..storage.part_table import FIRST_COLUMNS
from ..system.file_paths import is_below
from ..workflow.analyse_file import FileTask
from ..workflow.cluster import cluster_address
from ..workflow.find_documents import ENDINGS, common_folder
from ..workflow.run_control import RunControl
from ..workflow.run_plan import info_place, plan_run
from .control_input import listen
from .file_run import analyse_planned
from .part_rows import PartRows
from .run_options import (
    add_choice, add_conversation, add_info_place, add_limits, add_measuring, info_tree, limits_of,
    search_documents, settings_of,
)
from .run_report import new_report, standard_output
from .stop_signals import stop_signals


def add_arguments(parser):
    """Declare the options."""
    add_choice(parser)
    parser.add_argument("--csv", metavar="FILE", help="write the table to a CSV file as well")
    parser.add_argument("--only", metavar="LIST",
                        help="classify only the files that LIST names (absolute paths, each ended by a "
                             "NUL byte); the PATHs then only say which tree --info-dir mirrors")
    parser.add_argument("--no-info", action="store_true", help="write no info files")
    add_info_place(parser, "keep the info files in this folder instead of beside the parts")
    parser.add_argument("--no-thumbnails", action="store_true",
                        help="keep no pictures of the parts in the cache")
    parser.add_argument("--force", action="store_true",
                        help="measure again even what has not changed")
    add_measuring(parser)
    add_limits(parser)
    parser.add_argument("--dask", metavar="ADDRESS", type=_cluster,
                        help="have it done by the workers of a Dask cluster that see the same files, as "
                             "many at once as they have threads; tcp://HOST:PORT of its scheduler")
    add_conversation(parser)


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
    paths = None if options.only is None else _listed(options)
    documents, failures = search_documents(options, control, report, paths)
    if options.csv:
        _check_table(options.csv, documents)
    if options.info_dir is not None and not options.no_info:
        _check_info_folder(options.info_dir)
    planned = plan_run(documents, new_task, _info_place(options), options.jobs)
    return analyse_planned(planned, failures, limits_of(options), control, report, rows.add, options.dask)


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
    top = info_tree(options)
    for path in paths:
        if not os.path.isabs(path):
            raise ThinPartError(
                f"The list {options.only} names {path!r}, which is no absolute path: write whole "
                "paths, each ended by a NUL byte.", "usage")
        if options.info_dir is not None and not is_below(os.path.dirname(os.path.abspath(path)), top):
            # Its info file would lie outside of the folder that is meant for info files.
            raise ThinPartError(
                f"The list {options.only} names {path}, which does not lie below {top}: name a PATH "
                "that holds it, or leave out --info-dir.", "usage")
    return paths


def _new_task(options):
    settings = settings_of(options)
    profile = load_profile(options.profile).content
    thumbnails = not (options.no_info or options.no_thumbnails)
    return lambda file, info: FileTask(file, info, settings, profile, options.force, thumbnails)


def _info_place(options):
    if options.no_info:
        return lambda file: None
    return info_place(options.info_dir, info_tree(options))


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
