# SPDX-License-Identifier: LGPL-2.1-or-later
"""The languages that pages of reports are written in: texts, sentences of other layers, numbers and lengths.

The translations are those of the window. Where there is no Qt to read them, they are taken from the tables that
`resources/translations/update_translations.py` writes beside its own files.
"""

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

from ...core import number_text
from ...core.length_unit import MILLIMETRE
from ...core.message import in_other_words

FOLDER = Path(__file__).resolve().parents[3] / "resources" / "translations"

ENGLISH = "en"

LANGUAGES = (ENGLISH, *sorted(path.stem.rpartition("_")[2] for path in FOLDER.glob("sentences_*.json")))
"""Codes, as pages have them in ``lang``."""

_DECIMAL_COMMA = ("de", "fr")


class PageLanguage:
    """Texts, numbers and lengths of a page.

    Parameters
    ----------
    code : str
        One of `LANGUAGES`.
    unit : LengthUnit
        Of all lengths; its decimal mark does not matter.

    Attributes
    ----------
    code : str
    length : LengthUnit
        The unit, with the decimal mark of the language.
    """

    def __init__(self, code, unit):
        self.code = code
        self.length = replace(unit, decimal_mark="," if code in _DECIMAL_COMMA else ".")
        path = FOLDER / f"sentences_{code}.json"
        self._texts = json.loads(path.read_text(encoding="utf-8")) if code != ENGLISH else {}

    def text(self, template, **fields):
        """A text of the page, with its fields filled in where they are given: str."""
        text = self._texts.get(template, template)
        return text.format(**fields) if fields else text

    def sentence(self, sentence):
        """A sentence, title or meaning of another layer, with its lengths in the unit: str.

        What has no translation stays in English.
        """
        return in_other_words(sentence, self.text, self.length)

    def number(self, value):
        """See `number_text.number`."""
        return self._marked(number_text.number(value))

    def percent(self, share):
        """See `number_text.percent`."""
        return self._marked(number_text.percent(share))

    def large(self, value):
        """A number with separated thousands: str."""
        if value is None or abs(value) < 1e4:
            return self.number(value)
        return f"{value:,.0f}".replace(",", "\u202f")

    def _marked(self, text):
        return number_text.with_decimal_mark(text, self.length.decimal_mark)


@cache
def page_language(code, unit=MILLIMETRE):
    """The language of a code with a unit of lengths, read once: PageLanguage."""
    return PageLanguage(code, unit)
