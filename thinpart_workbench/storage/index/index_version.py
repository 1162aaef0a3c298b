# SPDX-License-Identifier: LGPL-2.1-or-later
"""The version of the index: a program only reads an index that it would have built in exactly the same way."""

import hashlib
import json
import re
from pathlib import Path

from ..info.info_definition import json_schema

PACKAGE = Path(__file__).resolve().parents[2]

VALUES = PACKAGE / "storage" / "index" / "index_columns.py"
"""The module that defines the values that an index stores for a part."""

_IMPORT = re.compile(rb"^ *from (\.+)([\w.]*) import", re.MULTILINE)


def index_version(statements):
    """A text that changes whenever the index would be built differently, by SQL statements that create its tables.

    Returns a str: twelve hexadecimal digits of a hash of the statements, of the source code that computes the values, and of
    the definition of an info file, which decides what counts as a part and what as a failure.

    Comments count too. Rebuilding an index once too often costs seconds; an index whose columns no longer mean what
    the program expects gives wrong results.
    """
    content = hashlib.sha256(json.dumps([*statements, json_schema()]).encode())
    for file in modules_below(VALUES):
        # Git converts line ends on Windows; they do not count.
        content.update(hashlib.sha256(file.read_bytes().replace(b"\r\n", b"\n")).digest())
    return content.hexdigest()[:12]


def modules_below(file):
    """A module and all modules of the package that it imports, directly or indirectly: sorted list of Path."""
    found, waiting = set(), [file]
    while waiting:
        file = waiting.pop()
        if file not in found:
            found.add(file)
            waiting += [file.parents[len(dots) - 1].joinpath(*name.decode().split(".")).with_suffix(".py")
                        for dots, name in _IMPORT.findall(file.read_bytes())]
    return sorted(found)
