# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exceptions of workers as data, so that the parent need not parse a traceback."""

import errno
import sys
import traceback

from ...core.errors import NO_MEMORY, ThinPartError
from ...core.message import message
from ...core.problem import problem_of
from ...system.exit_cause import is_out_of_memory


def reported_failure(error, subject=None):
    """An exception as data; the traceback of an unexpected one goes to standard error.

    Returns a dict: ``kind``, one of `KINDS`, and ``message``, a sentence.

    Parameters
    ----------
    error : Exception
    subject : str, optional
        Name of the file or part that was being processed.
    """
    if isinstance(error, ThinPartError):
        return {"kind": error.kind, "message": str(error)}
    if is_out_of_memory(error):
        return {"kind": "memory", "message": NO_MEMORY if subject is None else message(
            "{about} needs more memory than the limit allows.", about=subject)}
    if isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EDQUOT):
        return {"kind": "failed", "message": message(
            "Temporary files cannot be written ({problem}): free some disk space, or name another folder in TMPDIR.",
            problem=error.strerror)}
    traceback.print_exception(type(error), error, error.__traceback__, file=sys.stderr)
    problem = problem_of(error)
    return {"kind": "failed", "message": message("The worker process failed ({problem}).", problem=problem)
            if subject is None else message("{file} failed ({problem}).", file=subject, problem=problem)}
