# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON that others wrote: read with a limit, and a reason in words where that fails."""

import json

from ..message import message
from ..problem import problem_of
from ..regular_file import read_regular

LARGEST_WRITTEN = 16 << 20
"""Bytes above which no file is read that a person wrote, such as a profile."""


class UnreadableJson(Exception):
    """JSON cannot be read; its text is the reason, without a full stop."""


def read_json(path, most=LARGEST_WRITTEN):
    """The content of a JSON file: object. Raises FileNotFoundError or UnreadableJson.

    Parameters
    ----------
    path : str or Path
    most : int
        Greatest number of bytes.
    """
    try:
        return parsed_json(read_regular(path, most))
    except FileNotFoundError:
        raise
    except OSError as error:
        raise UnreadableJson(error.strerror) from None


def parsed_json(data):
    """The value that JSON text stands for, bytes in any of the encodings of Unicode: object; raises UnreadableJson."""
    try:
        return _DECODE(str(data, json.detect_encoding(data)))
    except UnicodeDecodeError as error:
        raise UnreadableJson(message("byte {place} is not text in Unicode", place=error.start + 1)) from None
    except (RecursionError, ValueError) as error:  # of Python itself where a number has thousands of digits
        raise UnreadableJson(problem_of(error, message("a number in it is too long"))) from None


def _refuse_constant(constant):
    """Refuse NaN and Infinity, which Python would accept."""
    raise ValueError(message("{constant} is not a JSON number", constant=constant))


_DECODE = json.JSONDecoder(parse_constant=_refuse_constant).decode
