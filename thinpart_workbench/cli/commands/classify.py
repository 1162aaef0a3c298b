# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart classify``: classify parts and folders into a table, JSON lines, CSV and info files."""

import errno
import os
import tempfile

from ...core.errors import ThinPartError
from ...core.judging.criteria import load_profile
from ...core.kinds.file_marks import TABLE
from ...core.message import message
from ...storage.common_folder import common_folder
from ...storage.info.info_file import info_path_getter
from ...system.file_paths import is_below
from ..check_options import PartChecks, add_check_options, checked_limits
from ..file_run import analyse_and_report, controlled_run
from ..output_options import add_output_option, replacing
from ..part_rows import PartRows
from ..run_options import (
    add_cluster_option,
    add_control_options,
    add_file_options,
    add_info_folder_options,
    add_limit_options,
    add_measurement_options,
    info_tree,
    limits_of,
    new_file_run,
    settings_of,
)
from ..run_report import standard_output

_LARGEST_LIST = 256 << 20
"""Bytes of a list of files: a million long paths."""


def add_arguments(parser):
    """Declare the options."""
    add_file_options(parser)
    add_output_option(parser, "--csv", mark=TABLE, metavar="FILE", help="write the table to a CSV file as well")
    parser.add_argument("--regions", action="store_true",
                        help="list the connected walls of each part below the table: kind, thickness, size, faces")
    parser.add_argument("--only", metavar="LIST",
                        help="classify only the files that LIST names (absolute paths, each ended by a "
                             "NUL byte); the PATHs then only say which tree --info-dir mirrors")
    parser.add_argument("--no-info", action="store_true", help="neither write nor read info files, in which notes and "
                        "limits of single faces are kept")
    add_info_folder_options(parser, "write the info files into this folder instead of beside the parts")
    parser.add_argument("--no-thumbnails", action="store_true",
                        help="store no pictures of the parts in the cache")
    parser.add_argument("--force", action="store_true",
                        help="measure again even files that have not changed")
    add_measurement_options(parser)
    add_check_options(parser)
    add_limit_options(parser)
    add_cluster_option(parser)
    add_control_options(parser)


def run(options):
    """Classify and return the exit status."""
    checks = PartChecks(checked_limits(options))
    profile = load_profile(options.profile)
    rows = PartRows(common_folder(options.paths), profile, table=not options.json, csv=bool(options.csv),
                    regions=options.regions, limits=checks.limits)
    try:
        with controlled_run(options) as (report, control, undisturbed):
            try:
                failed = _classify(options, profile.content, control, report, rows, checks)
            finally:
                # Also after Ctrl-C, so that finished results are saved.
                if options.csv and rows:
                    with undisturbed():
                        rows.write_csv(options.csv, **replacing(options))
    finally:
        if not options.json and rows:
            with standard_output() as stream:
                rows.print_table(stream)
    return checks.exit_status(1 if failed else 0)


def _classify(options, profile, control, report, rows, checks):
    """Find the documents and analyse them; returns the number of those that failed."""
    settings = settings_of(options)
    paths = None if options.only is None else _listed(options)
    file_run = new_file_run(options, control, report, paths)
    if options.info_dir is not None and not options.no_info:
        _check_info_folder(options.info_dir)
    return analyse_and_report(
        file_run, report, rows.add, checks=checks, cluster=options.dask, profile=profile, settings=settings,
        limits=limits_of(options), info_for=_info_file_for(options), force=options.force,
        thumbnails=not (options.no_info or options.no_thumbnails))


def _listed(options):
    """The files in the list after --only."""
    try:
        with open(options.only, "rb") as file:  # another program may write the list into a pipe
            content = file.read(_LARGEST_LIST + 1)
        if len(content) > _LARGEST_LIST:
            raise OSError(errno.EFBIG, message("it is larger than {megabytes} MB", megabytes=_LARGEST_LIST >> 20))
    except OSError as error:
        raise ThinPartError(
            message("The list {list} cannot be read ({problem}): give a file to --only that names the parts.",
                    list=options.only, problem=error.strerror), "usage",
        ) from None
    paths = [os.fsdecode(name) for name in content.split(b"\0") if name]
    top = info_tree(options)
    for path in paths:
        if not os.path.isabs(path):
            raise ThinPartError(
                message("The list {list} names {file!r}, which is not an absolute path: write absolute paths, each "
                        "ended by a NUL byte.", list=options.only, file=path), "usage")
        if options.info_dir is not None and not is_below(os.path.dirname(os.path.abspath(path)), top):
            # Its info file would lie outside the folder for info files.
            raise ThinPartError(
                message("The list {list} names {file}, which does not lie below {top}: name a PATH that holds it, "
                        "or leave out --info-dir.", list=options.only, file=path, top=top), "usage")
    return paths


def _info_file_for(options):
    if options.no_info:
        return None
    return info_path_getter(options.info_dir, info_tree(options))


def _check_info_folder(folder):
    """Reject an unusable folder for info files before 100,000 files are measured for it."""
    try:
        if os.path.lexists(folder) and not os.path.isdir(folder):
            raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR))
        os.makedirs(folder, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise ThinPartError(
            message("Info files cannot be written into {folder} ({problem}): give another folder to --info-dir.",
                    folder=folder, problem=error.strerror), "usage",
        ) from None
