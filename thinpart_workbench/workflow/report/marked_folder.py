# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a report, which a marker file identifies."""

import json
import os

from ... import __version__
from ...core.errors import ThinPartError
from ...core.kinds.file_marks import REPORT
from ...core.message import message
from ...storage.output_file import check_output, write_output

MARK = "thinpart-report.json"
"""File that marks the folder of a report; it is written before the first page."""


def prepare_folder(path, given_name, files, overwrite=False, inputs=()):
    """Create the folder of a report, or take that of an earlier one.

    Parameters
    ----------
    path : str
        Absolute.
    given_name : str
        What the user has named it.
    files : dict
        Names of the files that are written into the folder itself, besides `MARK`, with their marks.
    overwrite, inputs
        See `storage.output_file.check_output`: for each file. A folder that holds anything but a report is only taken with
        `overwrite`.

    Raises
    ------
    ThinPartError
        kind ``usage`` if the folder cannot be written, contains anything but a report, or a file that must not be
        replaced.
    """
    replacing = {"overwrite": overwrite, "inputs": inputs}
    try:
        os.makedirs(path, exist_ok=True)
        entries = os.listdir(path)
        if entries and MARK not in entries and not overwrite:
            raise ThinPartError(
                message("{folder} already exists and is not the folder of a report: it was not changed; give a new or "
                        "an empty folder.", folder=given_name), "usage")
        for name, mark in {MARK: REPORT, **files}.items():
            check_output(os.path.join(path, name), mark, **replacing)
        content = {"format": REPORT.format, "version": 1, "software": __version__}
        write_output(os.path.join(path, MARK), json.dumps(content).encode() + b"\n", REPORT, **replacing)
    except FileExistsError:
        raise _not_writable(given_name, message("it is a file")) from None
    except OSError as error:
        raise _not_writable(given_name, error.strerror) from None


def _not_writable(given_name, problem):
    return ThinPartError(message("No report can be written into {folder} ({problem}): give another folder.",
                                 folder=given_name, problem=problem), "usage")
