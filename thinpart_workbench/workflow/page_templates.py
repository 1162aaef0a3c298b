"""The templates of report pages, filled in so that whatever a label holds is shown as text."""

import unicodedata
from functools import lru_cache
from pathlib import Path

from ..core.errors import ThinPartError
from ..core.number_text import bound_text, number, percent

TEMPLATES = Path(__file__).resolve().parents[2] / "resources" / "report"


def fill_in(template, **values):
    """A page.

    Parameters
    ----------
    template : str
        Name of a file in ``resources/report``.

    Returns
    -------
    bytes
        UTF-8. Bytes of file names that are no text are shown as escapes.
    """
    return _environment().get_template(template).render(**values).encode("utf-8", "backslashreplace")


def check_templates():
    """Say so before anything is measured where pages cannot be filled in.

    Raises
    ------
    ThinPartError
        kind ``unsupported``.
    """
    try:
        _environment()
    except ImportError as error:
        raise ThinPartError(
            f"Reports need the Python package Jinja2 ({error}): install it (Debian: 'apt-get install "
            "python3-jinja2', elsewhere: 'python -m pip install Jinja2').", "unsupported") from None


@lru_cache(maxsize=None)
def _environment():
    # Only reports need it, and FreeCAD does not bring it.
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(loader=FileSystemLoader(TEMPLATES), autoescape=True, finalize=_printable,
                              undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    environment.filters.update(number=number, percent=percent, bound=bound_text, large=_large)
    return environment


def _large(value):
    """A number whose thousands are set apart."""
    return number(value) if value is None or abs(value) < 1e4 else f"{value:,.0f}".replace(",", "\u202f")


def _printable(value):
    """Text in which control characters, and those that turn the direction of what follows, are escapes."""
    if type(value) is not str:
        return value
    return "".join(
        repr(each)[1:-1] if unicodedata.category(each) in ("Cc", "Cf") and each not in "\n\t" else each
        for each in value)
