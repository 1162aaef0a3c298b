"""Compile a definition into one Python function, fast enough for a library of a hundred thousand files.

The function is generated as source text and compiled, as dataclasses do it, because a function call for each of the
two thousand values of an info file would take longer than reading the file. It only returns whether a value is valid;
`Kind.fault` then explains what is wrong with an invalid one.
"""

from .value_kinds import LONGEST


class Source:
    """The source text of a generated function, and the objects that it refers to.

    Parameters
    ----------
    is_plain : bool
        See `checker`.
    """

    def __init__(self, is_plain):
        self.is_plain = is_plain
        self.lines, self.names = [], {}

    def line(self, depth, text):
        """Add a line at an indentation depth."""
        self.lines.append(f"{'    ' * depth}{text}")

    def variable(self):
        """str: the name of a new variable."""
        name = f"v{len(self.names)}"
        self.names[name] = None
        return name

    def name(self, used_object):
        """str: a name under which the function can use an object."""
        name = f"x{len(self.names)}"
        self.names[name] = used_object
        return name


_WRONG = (AttributeError, KeyError, OverflowError, TypeError, ValueError)
"""Exceptions that a condition raises for a value of another type."""


def is_plain(data):
    """Whether JSON data is at most `LONGEST` bytes of ASCII without escapes. Then every text in it can be written and is
    no longer than `LONGEST`, so that the texts need no check one by one.

    Parameters
    ----------
    data : bytes
    """
    return len(data) <= LONGEST and data.isascii() and b"\\" not in data


def checker(kind, is_plain=False):
    """Compile a fast function that returns whether a value is of a kind.

    Parameters
    ----------
    kind : Kind
    is_plain : bool
        Whether the values come from JSON data for which `is_plain` is true.

    Returns
    -------
    callable
    """
    source = Source(is_plain)
    wrong = source.name(_WRONG)
    source.line(0, "def holds(value):")
    source.line(1, "try:")
    kind.check("value", source, 2)
    source.line(1, f"except {wrong}: return False")
    source.line(1, "return True")
    exec("\n".join(source.lines), source.names)  # generated from definitions in this package only, never from data
    return source.names["holds"]
