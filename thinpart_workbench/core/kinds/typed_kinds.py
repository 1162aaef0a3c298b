# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of values that types stand for: a TypedDict is what editors know of a record, and its definition."""

from dataclasses import dataclass, replace
from functools import cache
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

from .compound_kinds import ListOf, Record
from .key_presence import NotRequired, Required, is_required
from .value_kinds import Either, Flag, Kind, Number, OrNull, Text, Whole

LATER = "later"
"""Mark, in ``Annotated``, of a key that is always written, and that files of earlier versions lack."""


@dataclass(frozen=True, init=False)
class Restricted:
    """What is special about the kind of a type, in ``Annotated``.

    Parameters
    ----------
    fields
        Attributes of the kind, such as ``least`` of a number or a list.
    """

    fields: tuple

    def __init__(self, **fields: Any):
        object.__setattr__(self, "fields", tuple(fields.items()))


def kind_of(given):
    """The kind of the values of a type: Kind. Raises TypeError for any other type.

    Parameters
    ----------
    given : type
        float, int, str or bool; ``dict[str, Any]``, for an object with any keys; a TypedDict; a list, ``Optional`` or
        ``Union`` of two of these; or ``Annotated`` with such a type and with `Restricted`, or another `Kind` in its place.
    """
    origin, arguments = get_origin(given), get_args(given)
    if origin is Annotated:
        kind: Any = next((mark for mark in arguments[1:] if isinstance(mark, Kind)), None) or kind_of(arguments[0])
        for limits in (mark for mark in arguments[1:] if isinstance(mark, Restricted)):
            kind = replace(kind, **dict(limits.fields))
        return kind
    if origin is Union:
        kinds = [kind_of(each) for each in arguments if each is not type(None)]
        kind = Either(*kinds) if len(kinds) > 1 else kinds[0]
        return OrNull(kind) if len(kinds) < len(arguments) else kind
    if origin is list:
        return ListOf(kind_of(arguments[0]))
    if hasattr(given, "__required_keys__"):  # a TypedDict
        return _record(given)
    if given in _SIMPLE:
        return _SIMPLE[given]
    raise TypeError(f"{given} has no kind")


_SIMPLE = {float: Number(), int: Whole(), str: Text(), bool: Flag(), dict[str, Any]: Record({}, is_open=True)}


@cache
def _record(given):
    groups: dict = {"required": {}, "optional": {}, "later": {}}
    for key, hint in get_type_hints(given, include_extras=True).items():
        if get_origin(hint) in (NotRequired, Required):
            hint, = get_args(hint)
        is_later = LATER in getattr(hint, "__metadata__", ())
        group = "required" if is_required(given, key, hint) else "later" if is_later else "optional"
        groups[group][key] = kind_of(hint)
    return Record(**groups)
