# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences for people that keep their template and fields, so that the window can translate them."""

import re
import string
from numbers import Integral, Real

from .figures import Figure, Length, figure_from, in_unit

MESSAGES_KEY = "messages"
"""Key of a JSON object under which the templates and fields of its sentences are, beside the sentences themselves."""

_MOST_FIELDS, _DEEPEST, _LONGEST = 20, 6, 200_000
"""Limits for messages from other processes: fields of a template, depth of messages within messages, characters."""

_FORMAT = re.compile(r",?(\.\d)?[dfg]?")
_PLAIN = (str, int, float, bool, type(None), Figure)
_UNIT_BEHIND = re.compile(r"\{([a-z]+)(:\.\dg)\} mm\b")
"""A length in a template as earlier versions stored them, with its unit behind the field."""


class Message(str):
    """A sentence in English, usable as a str, with its template and fields.

    Parameters
    ----------
    template : str
        English, with named fields in the syntax of `str.format`: "{name} is empty ({bytes} bytes)."
    fields : dict
        By name: JSON values other than lists and objects, figures, or messages.

    Attributes
    ----------
    template : str
    fields : dict
    """

    template: str
    fields: dict

    def __new__(cls, template, fields):
        self = super().__new__(cls, template.format_map(fields))
        self.template, self.fields = template, fields
        return self

    def __getnewargs__(self):
        return self.template, self.fields

    def __str__(self):
        # str() of an exception calls this, so that an error that becomes a row keeps its template and fields.
        return self


def message(template, /, **fields):
    """Make a sentence from a template and fields: Message. Raises KeyError if a field is missing.

    Parameters
    ----------
    template : str
        Must be a literal, since `resources/translations/texts_of_code.py` collects it from the source code.
    **fields
        Numbers, texts, paths, exceptions (as their text), messages, and lengths and shares as `figures` have them.
    """
    return Message(template, {name: _field(value) for name, value in fields.items()})


def joined(sentences):
    """Join sentences, with spaces between, into one text: str, or a Message where one of them is."""
    text = None
    for sentence in sentences:
        text = sentence if text is None else message("{first} {next}", first=text, next=sentence)
    return text or ""


def in_other_words(text, look_up, unit):
    """A sentence, reason, title or meaning in another language, with its lengths in a unit: str.

    Only fields that are numbers or figures are written differently. Texts such as names, and sentences that are no
    messages, stay as they are, whatever stands in them.

    Parameters
    ----------
    text : str
        For a Message, the template is looked up, and so are those of its fields that are messages themselves. Any
        other text, such as a title, is looked up as it is.
    look_up : callable
        Returns the translation of a text, or the text where there is none.
    unit : LengthUnit
        Its decimal mark is that of all numbers.
    """
    if not isinstance(text, Message):
        return look_up(text) if text else text
    return look_up(text.template).format_map({
        name: in_other_words(value, look_up, unit) if isinstance(value, Message) else in_unit(value, unit)
        for name, value in text.fields.items()})


def to_data(sentence):
    """Convert a Message to JSON data: dict.

    ``template``, and ``fields`` by name, with nested messages in the same form, and figures as `figures.Figure.data`.
    """
    return {"template": sentence.template, "fields": {name: _field_data(value) for name, value in sentence.fields.items()}}


def from_data(data):
    """Restore the Message from the result of `to_data`; None for anything else.

    Parameters
    ----------
    data : object
        Any JSON value: a process that reads an untrusted file may have been made to send anything.
    """
    said = _from_data(data, _DEEPEST)
    return None if said is None else _with_lengths(said)


def with_messages(content):
    """Add the templates and fields of its messages, at any depth, to a dict, for a line of JSON: dict.

    The same, with a list under `MESSAGES_KEY` if it contains messages. In JSON, messages are their text.
    """
    found: dict[Message, Message] = {}
    _collect(content, found)
    return {**content, MESSAGES_KEY: [to_data(item) for item in found.values()]} if found else content


def restored(content):
    """Undo `with_messages` on an object that was read from JSON: object.

    Parameters
    ----------
    content : object
        Texts that are listed under `MESSAGES_KEY` become messages again; everything else is unchanged.
    """
    if not isinstance(content, dict) or MESSAGES_KEY not in content:
        return content
    listed = content[MESSAGES_KEY] if isinstance(content[MESSAGES_KEY], list) else ()
    found = {said: _with_lengths(said) for said in (_from_data(each, _DEEPEST) for each in listed) if said is not None}
    return {key: _restored(value, found) for key, value in content.items() if key != MESSAGES_KEY}


def _field_data(value):
    if isinstance(value, Message):
        return to_data(value)
    return value.data() if isinstance(value, Figure) else value


def _field(value):
    if isinstance(value, _PLAIN):
        return value
    if isinstance(value, Integral):
        return int(value)  # numpy types, which JSON cannot write
    return float(value) if isinstance(value, Real) else str(value)


def _from_data(data, depth):
    try:
        template, fields = data["template"], data["fields"]
        if depth == 0 or not _is_template(template) or not isinstance(fields, dict):
            return None
        restored_fields = {}
        for name, value in fields.items():
            restored_fields[name] = figure_from(value) or _from_data(value, depth - 1) if isinstance(value, dict) else value
            if not isinstance(restored_fields[name], _PLAIN) or isinstance(value, dict) and restored_fields[name] is None:
                return None
        result = Message(template, restored_fields)
    except (AttributeError, KeyError, IndexError, TypeError, ValueError, OverflowError):
        return None
    return result if len(result) <= _LONGEST else None


def _with_lengths(sentence):
    """A message whose lengths are figures, also where an earlier version wrote it."""
    fields = {name: _with_lengths(value) if isinstance(value, Message) else value for name, value in sentence.fields.items()}

    def field(found):
        name, digits = found.groups()
        if not isinstance(fields[name], Length):
            if isinstance(fields[name], bool) or not isinstance(fields[name], Real):
                return found[0]
            fields[name] = Length(fields[name])
        return f"{{{name}}}" if digits == ":.3g" else f"{{{name}{digits}}}"

    return Message(_UNIT_BEHIND.sub(field, sentence.template), fields)


def _is_template(text):
    """Whether formatting a text is cheap and accesses nothing but its fields."""
    if not isinstance(text, str) or len(text) > _LONGEST:
        return False
    fields = [(name, form or "", conversion)
              for _, name, form, conversion in string.Formatter().parse(text) if name is not None]
    return len(fields) <= _MOST_FIELDS and all(
        name.isidentifier() and _FORMAT.fullmatch(form) and conversion in (None, "r")
        for name, form, conversion in fields)


def _collect(content, found):
    if isinstance(content, Message):
        found.setdefault(content, content)
    elif isinstance(content, dict):
        for value in content.values():
            _collect(value, found)
    elif isinstance(content, (list, tuple)):
        for item in content:
            _collect(item, found)


def _restored(content, found):
    if isinstance(content, str):
        return found.get(content, content)
    if isinstance(content, dict):
        return {key: _restored(value, found) for key, value in content.items()}
    if isinstance(content, list):
        return [_restored(item, found) for item in content]
    return content
