# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts about the verdicts on a document's parts, and about their changes."""

from collections import Counter

from ...api.document_verdicts import category_changes, walls_newly_under
from ..application.numbers import marked
from ..application.qt import translate
from ..record.verdict_text import category_words, reason_text, short_words, unsure_words

_MOST_REASONS = 12


def headline(verdicts):
    """A short summary of the categories of a document's parts, from `document_verdicts`."""
    counts = Counter(_category_text(verdict) for verdict in verdicts.values())
    if len(verdicts) == 1:
        return next(iter(counts))
    return ", ".join(f"{count}\u00a0\u00d7\u00a0{category}" for category, count in counts.items())


def reasons(verdicts, unit):
    """The reason for each part's verdict, one line per part, with lengths in a unit."""
    lines = [f"{verdict['label']}: {_category_text(verdict)}. {reason_text(verdict, unit)}"
             for verdict in verdicts.values()]
    if len(lines) > _MOST_REASONS:
        rest = len(lines) - _MOST_REASONS + 1
        lines[_MOST_REASONS - 1:] = [translate("ThinPart", "and {} more parts").format(rest)]
    return "\n".join(lines)


def warnings(document, before, now, of_category, limit_mm, unit):
    """One warning for each part with a change that the user wants to be warned about: list of str.

    Parameters
    ----------
    before, now : dict
        See `category_changes`.
    of_category : bool
        Whether to warn about a changed category.
    limit_mm : float, mm
        Warn about walls thinner than this; 0 for never.
    """
    changed = {id(new): old for old, new in category_changes(before, now)} if of_category else {}
    under = {id(verdict) for verdict in walls_newly_under(before, now, limit_mm)} if limit_mm else set()
    return [_warning(document, changed.get(id(verdict)), verdict, limit_mm if id(verdict) in under else None, unit)
            for verdict in now.values() if id(verdict) in changed or id(verdict) in under]


def _warning(document, old, new, limit_mm, unit):
    if old is None:
        return translate(
            "ThinPart", "{}: '{}' ({}) has a wall of {}, below the limit of {}."
        ).format(document, new["label"], _category_text(new), *_distinct_texts(new["thickness"], limit_mm, unit))
    names = document, new["label"], _category_text(old), _category_text(new)
    if limit_mm is not None:
        return translate(
            "ThinPart", "{}: '{}' was '{}' and is '{}' now; its thinnest wall of {} is below the limit of {}.").format(
                *names, *_distinct_texts(new["thickness"], limit_mm, unit))
    if new["thickness"] is None:
        return translate("ThinPart", "{}: '{}' was '{}' and is '{}' now; none of its walls could be "
                         "measured.").format(*names)
    return translate("ThinPart", "{}: '{}' was '{}' and is '{}' now; its thinnest wall is {}."
                     ).format(*names, unit.text(new["thickness"]))


def _distinct_texts(thickness, limit_mm, unit):
    """Texts of a thickness and a limit, with as many digits as it takes to tell them apart."""
    if unit.number(thickness) != unit.number(limit_mm):
        return unit.text(thickness), unit.text(limit_mm)
    return tuple(unit.with_symbol(marked(f"{unit.value(length):.6g}")) for length in (thickness, limit_mm))


def _category_text(verdict):
    if verdict["between"]:
        return unsure_words(*(short_words(*each) for each in verdict["between"]))
    return category_words(verdict["category"], verdict["title"])
