"""The templates of report pages; all values, such as labels, are escaped and shown as text."""

from functools import cache, partial
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.foreign_text import head_text, html_text
from ...core.length_unit import MILLIMETRE
from ...core.message import message
from .page_language import ENGLISH, page_language

TEMPLATES = Path(__file__).resolve().parents[3] / "resources" / "report"


def fill_in(template, language=ENGLISH, unit=MILLIMETRE, **values):
    """Render a template, which finds the methods of `LengthUnit` in ``length``: bytes, UTF-8.

    Parameters
    ----------
    template : str
        Name of a file in ``resources/report``.
    language : str, optional
        One of `LANGUAGES`.
    unit : LengthUnit, optional
        Of all lengths, those in sentences included.
    """
    return _environment(language, unit).get_template(template).render(**values).encode()


def check_templates():
    """Check before measuring that the templates can be rendered; raises ThinPartError of kind ``unsupported``."""
    try:
        _environment(ENGLISH, MILLIMETRE)
    except ImportError as error:
        raise ThinPartError(
            message("Reports need the Python package Jinja2 ({problem}): install it (Debian: 'apt-get install "
                    "python3-jinja2', elsewhere: 'python -m pip install Jinja2').",
                    problem=error), "unsupported") from None


@cache
def _environment(code, unit):
    # Imported here: only reports need Jinja2, and FreeCAD does not include it.
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(loader=FileSystemLoader(TEMPLATES), autoescape=True, finalize=_printable,
                              undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    language = page_language(code, unit)
    environment.globals.update(_=partial(_text, language), language=code, length=language.length)
    environment.filters.update(head=head_text, sentence=language.sentence, number=language.number, percent=language.percent,
                               large=language.large)
    return environment


def _text(language, template, **fields):
    """A text of a page with its fields, which are escaped as everything else."""
    from jinja2.utils import markupsafe

    shown = {name: _printable(value) for name, value in fields.items()}
    return markupsafe.Markup(markupsafe.escape(language.text(template))).format(**shown)


def _printable(value):
    return html_text(value) if type(value) is str else value  # not what is marked up already
