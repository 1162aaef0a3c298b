# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compile a definition into one Python function, fast enough for a library of a hundred thousand files.

The function is generated as source text and compiled, as dataclasses do it, because a function call for each of the
two thousand values of an info file would take longer than reading the file. It only returns whether a value is valid;
`Kind.fault` then explains what is wrong with an invalid one.
"""


class Source:
    """The source text of a generated function, and the objects that it refers to.

    Parameters
    ----------
    is_plain : bool
        Whether every text of the values can be written and is no longer than `value_kinds.LONGEST`.
    """

    def __init__(self, is_plain=False):
        self.is_plain = is_plain
        self._lines, self._names = [], {}

    def line(self, depth, text):
        """Add a line at an indentation depth."""
        self._lines.append(f"{'    ' * depth}{text}")

    def require(self, depth, condition):
        """Add a line that returns False unless an expression is true."""
        self.line(depth, f"if not ({condition}): return False")

    def variable(self):
        """str: the name of a new variable."""
        return self.name(None)

    def name(self, used_object):
        """str: a name under which the function can use an object."""
        name = f"x{len(self._names)}"
        self._names[name] = used_object
        return name


_WRONG = (AttributeError, KeyError, OverflowError, TypeError, ValueError)
"""Exceptions that a condition raises for a value of another type."""


def compiled(write, source):
    """Compile a function that returns whether a value is valid: callable.

    Parameters
    ----------
    write : callable
        Writes the lines that return False if it is not. Called with the name of the variable, `source` and the depth of the
        lines.
    source : Source
    """
    wrong = source.name(_WRONG)
    source.line(0, "def holds(value):")
    source.line(1, "try:")
    write("value", source, 2)
    source.line(1, f"except {wrong}: return False")
    source.line(1, "return True")
    exec("\n".join(source._lines), source._names)  # generated from definitions in this package only, never from data
    return source._names["holds"]
