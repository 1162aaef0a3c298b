# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people read about an exception: words of ThinPart and of the operating system, never those of a program's inside."""

import json
import zipfile
import zlib

from .errors import NO_MEMORY, ThinPartError
from .message import Message, message

UNEXPECTED = message("an unexpected error in ThinPart: try again, and report it with the file if it happens again")
"""Said of an exception that nobody foresaw. Its traceback goes to the log or to standard error."""

NOT_READ_BY_FREECAD = message("FreeCAD cannot read it: open it in the program it came from, and export it again")
"""Said where FreeCAD raised an exception while it read a file."""

NOT_WRITTEN_BY_FREECAD = message("FreeCAD cannot write them")
"""Said where FreeCAD raised an exception while it wrote files."""


def problem_of(error, otherwise=UNEXPECTED):
    """Why something failed, in words for people: str.

    The end of a sentence, or what stands within parentheses: without a full stop, unless it is a sentence of its own.

    Parameters
    ----------
    error : Exception
    otherwise : str, optional
        Said of an exception that has no words for people: those of Python and FreeCAD have shapes of arrays, addresses, and
        names of classes and functions.
    """
    if isinstance(error, ThinPartError) or error.args and isinstance(error.args[0], Message):
        return error.args[0]  # such as ValueError(message("..."))
    if isinstance(error, OSError) and error.strerror:
        return error.strerror
    if isinstance(error, MemoryError):
        return NO_MEMORY
    if isinstance(error, RecursionError):
        return message("it is nested too deeply")
    if isinstance(error, json.JSONDecodeError):
        return message("it is not JSON: line {line} column {column}", line=error.lineno, column=error.colno)
    if isinstance(error, UnicodeError):
        return message("it is not UTF-8 text")
    if isinstance(error, (zipfile.BadZipFile, zlib.error, EOFError)):
        return message("it is damaged or incomplete")
    return otherwise
