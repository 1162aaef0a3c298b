"""The checks that a user prefers, of the walls of a part."""

from ...core.errors import ThinPartError
from ...core.judging.wall_check import check_sentence, check_walls
from ...freecad_adapter.preferences import preference
from ...storage.user_limits import limits_named
from ..application.sentences import translated

SYMBOLS = {True: "\u2713", False: "\u2717", None: "?"}
"""For whether a part passes; None where it cannot be told."""


def checks_text(record, unit):
    """A line for each process that the preferences name; empty where they name none.

    Parameters
    ----------
    record : dict
        Part record, which may lack its faces.
    unit : LengthUnit
    """
    try:
        limits = limits_named(preference("Checks").split(","))
    except ThinPartError as error:
        return "\u26a0 " + translated(error)
    return "\n".join(check_line(check_walls(record, each), unit) for each in limits)


def check_line(check, unit):
    """The result of a check in a line, with its symbol."""
    return f"{SYMBOLS[check.holds]} {translated(check_sentence(check), unit)}"
