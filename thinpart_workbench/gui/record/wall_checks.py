# SPDX-License-Identifier: LGPL-2.1-or-later
"""The checks that a user prefers, of the walls of a part."""

from ...api.window.limits import preferred_checks
from ...core.errors import ThinPartError
from ..application.sentences import translated

SYMBOLS = {True: "\u2713", False: "\u2717", None: "?"}
"""For whether a part passes; None where it cannot be told."""


def checks_text(record, unit):
    """A line for each process that the preferences name; empty where they name none. The record may lack its faces."""
    try:
        return "\n".join(check_line(check, unit) for check in preferred_checks(record))
    except ThinPartError as error:
        return "\u26a0 " + translated(error)


def check_line(check, unit):
    """The result of a check, a CheckedPart, in a line, with its symbol."""
    return f"{SYMBOLS[check.holds]} {translated(check.sentence, unit)}"
