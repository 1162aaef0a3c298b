"""Exceptions of workers as data, so that the parent need not parse a traceback."""

import errno
import sys
import traceback

from ...core.errors import NO_MEMORY, ThinPartError
from ...core.message import message
from ...system.exit_cause import mentions_lack_of_memory


def reported_failure(error, subject=None):
    """An exception as data; the traceback of an unexpected one goes to standard error.

    Parameters
    ----------
    error : Exception
    subject : str, optional
        Name of the file or part that was being processed.

    Returns
    -------
    dict
        ``kind``, one of `KINDS`, and ``message``, a sentence.
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
    description = _description(error)
    sentence = (message("The worker process failed ({problem}).", problem=description) if subject is None
                else message("{file} failed ({problem}).", file=subject, problem=description))
    return {"kind": "failed", "message": sentence}


def is_out_of_memory(error):
    """Whether an exception was caused by lack of memory; FreeCAD and OCCT have their own exception classes for it."""
    return isinstance(error, MemoryError) or mentions_lack_of_memory(_description(error))


def _description(error):
    return f"{type(error).__name__}: {error}"
