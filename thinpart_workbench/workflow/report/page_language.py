"""The languages that pages of reports are written in: texts, sentences of other layers, and the decimal mark.

The translations are those of the window. Where there is no Qt to read them, they are taken from the tables that
`resources/translations/update_translations.py` writes beside its own files.
"""

import json
from functools import cache
from pathlib import Path

from ...core import number_text
from ...core.message import in_other_words

FOLDER = Path(__file__).resolve().parents[3] / "resources" / "translations"

ENGLISH = "en"

LANGUAGES = (ENGLISH, *sorted(path.stem.rpartition("_")[2] for path in FOLDER.glob("sentences_*.json")))
"""Codes, as pages have them in ``lang``."""

_DECIMAL_COMMA = ("de", "fr")


class PageLanguage:
    """Texts and numbers of a page.

    Parameters
    ----------
    code : str
        One of `LANGUAGES`.

    Attributes
    ----------
    code : str
    """

    def __init__(self, code):
        self.code = code
        self._mark = "," if code in _DECIMAL_COMMA else "."
        path = FOLDER / f"sentences_{code}.json"
        self._texts = json.loads(path.read_text(encoding="utf-8")) if code != ENGLISH else {}

    def text(self, template):
        """A text of the page, with its fields by name: str."""
        return self._texts.get(template, template)

    def sentence(self, sentence):
        """A sentence, title or meaning of another layer: str. What has no translation stays as it is."""
        return number_text.with_decimal_mark(
            in_other_words(sentence, self.text), self._mark)

    def number(self, value):
        """See `number_text.number`."""
        return self._marked(number_text.number(value))

    def percent(self, share):
        """See `number_text.percent`."""
        return self._marked(number_text.percent(share))

    def bound(self, millimetres):
        """See `number_text.bound_text`."""
        return self._marked(number_text.bound_text(millimetres))

    def large(self, value):
        """A number with separated thousands: str."""
        if value is None or abs(value) < 1e4:
            return self.number(value)
        return f"{value:,.0f}".replace(",", "\u202f")

    def _marked(self, text):
        return number_text.with_decimal_mark(text, self._mark)


@cache
def page_language(code):
    """The language of a code, read once: PageLanguage."""
    return PageLanguage(code)
