"""What the layers below the window say, in the user's language.

They speak English, which info files, tables and other programs keep. A sentence is found again by the
text that it was made from, whose fields stand for names and numbers.
"""

import json
import re
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from .qt import translate

CONTEXT = "ThinPartCore"
TEXTS = Path(__file__).resolve().parents[2] / "resources" / "translations" / "texts_from_below.json"
_FIELD = re.compile(r"('\{\}'|\{\})")
_BETWEEN_SENTENCES = re.compile(r"(?<=\.) (?=[A-Z0-9'])")


def translated(text):
    """A sentence, reason, title or meaning from below in the user's language.

    Parameters
    ----------
    text : str or ThinPartError
        Several sentences may follow each other, and what they are about may stand before, with a colon.

    Returns
    -------
    str
        As it was where it is not known, as titles of the user's own profile are.
    """
    # What the first text is in the user's language stands for that language: the user may change it.
    return _translated(str(text), translate(CONTEXT, _texts()[0]))


def translated_list(text):
    """The same for what is separated by commas."""
    return ", ".join(map(translated, text.split(", ")))


@lru_cache(maxsize=2000)
def _translated(text, language):
    if language == _texts()[0] or not text:
        return text
    known = translate(CONTEXT, text)
    if known != text:
        return known
    # First piece by piece: a field at the start of a sentence would take in all sentences before it.
    pieces = [_sentence(each, language) for each in _BETWEEN_SENTENCES.split(text)]
    return " ".join(pieces) if None not in pieces else _sentence(text, language) or text


def _sentence(text, language):
    """One sentence or a part of one; None where it is not known."""
    if text in _texts():
        return translate(CONTEXT, text)
    for template in _templates(language):
        found = template.sign in text and template.pattern.fullmatch(text)
        if found:
            return template.filled(found.groups(), language)
    about, colon, rest = text.partition(": ")
    known = _sentence(rest, language) if colon else None
    return known and translate("ThinPart", "{}: {}").format(about, known)


@dataclass(frozen=True)
class _Template:
    """A text with fields.

    Attributes
    ----------
    pattern : re.Pattern
        With a group for each field.
    sign : str
        The longest piece between fields: what lacks it need not be compared.
    quoted : tuple of bool
        For each field, whether it stands in quotes, as names do that are never translated.
    text : str
        In the user's language.
    """

    pattern: object
    sign: str
    quoted: tuple
    text: str

    def filled(self, fields, language):
        """The text with its fields, which may hold sentences themselves."""
        return self.text.format(*(
            field if quoted else " " in field and _sentence(field, language) or field
            for field, quoted in zip(fields, self.quoted)))


@lru_cache(maxsize=1)
def _texts():
    return tuple(json.loads(TEXTS.read_text(encoding="utf-8")))


@lru_cache(maxsize=1)
def _templates(_language):
    """list of _Template: those that say most come first."""
    texts = sorted((each for each in _texts() if "{}" in each), key=len, reverse=True)
    return [_template(each) for each in texts]


def _template(text):
    # Texts before, between and behind fields at even places, the fields at odd ones.
    pieces = _FIELD.split(text)
    words = [each.format() for each in pieces[::2]]
    fields = ["'(.*?)'" if each != "{}" else "(.*?)" for each in pieces[1::2]]
    pattern = "".join(re.escape(word) + field for word, field in zip(words, [*fields, ""]))
    return _Template(re.compile(pattern, re.DOTALL), max(words, key=len),
                     tuple(each != "{}" for each in pieces[1::2]), translate(CONTEXT, text))
