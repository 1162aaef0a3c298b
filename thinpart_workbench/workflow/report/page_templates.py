"""The templates of report pages; all values, such as labels, are escaped and shown as text."""

import unicodedata
from functools import cache
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.number_text import bound_text, number, percent

TEMPLATES = Path(__file__).resolve().parents[3] / "resources" / "report"


def fill_in(template, **values):
    """Render a template.

    Parameters
    ----------
    template : str
        Name of a file in ``resources/report``.

    Returns
    -------
    bytes
        UTF-8. Bytes of file names that are not valid text are shown as escapes.
    """
    return _environment().get_template(template).render(**values).encode("utf-8", "backslashreplace")


def check_templates():
    """Check before measuring that the templates can be rendered.

    Raises
    ------
    ThinPartError
        kind ``unsupported``.
    """
    try:
        _environment()
    except ImportError as error:
        raise ThinPartError(
            message("Reports need the Python package Jinja2 ({problem}): install it (Debian: 'apt-get install "
                    "python3-jinja2', elsewhere: 'python -m pip install Jinja2').",
                    problem=error), "unsupported") from None


@cache
def _environment():
    # Imported here: only reports need Jinja2, and FreeCAD does not include it.
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(loader=FileSystemLoader(TEMPLATES), autoescape=True, finalize=_printable,
                              undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    environment.filters.update(number=number, percent=percent, bound=bound_text, large=_large)
    return environment


def _large(value):
    """A number with separated thousands."""
    return number(value) if value is None or abs(value) < 1e4 else f"{value:,.0f}".replace(",", "\u202f")


def _printable(value):
    """Text with control characters, including those that change the writing direction, as escapes."""
    if type(value) is not str:
        return value
    return "".join(
        repr(character)[1:-1]
        if unicodedata.category(character) in ("Cc", "Cf") and character not in "\n\t" else character
        for character in value)
