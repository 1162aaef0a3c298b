# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translates the sentences of the layers below the GUI into the user's language.

Those layers write English, which info files, tables and other programs store. Each of their sentences is a `Message`:
its template is looked up in the translations, then its fields are filled in: lengths in the unit of the document,
numbers with the decimal mark of FreeCAD.
"""

from ...core.message import Message, in_other_words
from .length_unit import length_unit
from .qt import translate

CONTEXT = "ThinPartCore"


def translated(text, unit=None):
    """A sentence, reason, title or meaning from the layers below, in the user's language.

    Parameters
    ----------
    text : str or ThinPartError
        For a Message, the template is looked up, and so are those of its fields that are messages themselves. Any
        other text, such as a title, is looked up as it is.
    unit : LengthUnit, optional
        By default, that of the active document.

    Returns
    -------
    str
        The text itself where there is no translation, for example for titles of the user's own profile.
    """
    text = str(text)
    if not isinstance(text, Message):
        return in_other_words(text, _looked_up, None)
    return in_other_words(text, _looked_up, unit or length_unit())


def _looked_up(text):
    return translate(CONTEXT, text) if _is_encodable(text) else text


def translated_list(text):
    """Like `translated`, for each item of a comma-separated list."""
    return ", ".join(map(translated, text.split(", ")))


def _is_encodable(text):
    """Whether Qt takes the text: it refuses file names whose bytes are not UTF-8, which are in no translation either."""
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True
