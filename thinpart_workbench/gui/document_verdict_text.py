"""The verdicts on the parts of a document in words."""

from collections import Counter

from ..workflow.document_verdicts import category_changes, walls_newly_under
from .qt import translate
from .verdict_text import category_words, why

_MOST_REASONS = 12


def headline(verdicts):
    """The categories of a document's parts in a few words.

    Parameters
    ----------
    verdicts : dict
        From `document_verdicts`.
    """
    counts = Counter(_words(each) for each in verdicts.values())
    if len(verdicts) == 1:
        return next(iter(counts))
    return ", ".join(f"{count}\u00a0\u00d7\u00a0{words}" for words, count in counts.items())


def reasons(verdicts):
    """What decided on each part, a line each."""
    lines = [f"{each['label']}: {_words(each)}. {why(each)}" for each in verdicts.values()]
    if len(lines) > _MOST_REASONS:
        rest = len(lines) - _MOST_REASONS + 1
        lines[_MOST_REASONS - 1:] = [translate("ThinPart", "and {} more parts").format(rest)]
    return "\n".join(lines)


def warnings(document, before, now, of_category, limit, unit):
    """A sentence on each part of which something changed that the user wants to be warned of.

    Parameters
    ----------
    document : str
        What it is called.
    before, now : dict
        See `category_changes`.
    of_category : bool
        Whether to warn of another category.
    limit : float, mm
        Under which walls are warned of; 0 for none.
    unit : LengthUnit
        In which walls are told.

    Returns
    -------
    list of str
    """
    changed = {id(new): old for old, new in category_changes(before, now)} if of_category else {}
    under = {id(each) for each in walls_newly_under(before, now, limit)} if limit else set()
    return [_warning(document, changed.get(id(each)), each, limit if id(each) in under else None, unit)
            for each in now.values() if id(each) in changed or id(each) in under]


def _warning(document, old, new, limit, unit):
    if old is None:
        return translate(
            "ThinPart", "{}: '{}' ({}) has a wall of {}, under the limit of {}."
        ).format(document, new["label"], _words(new), *_apart(new["thickness"], limit, unit))
    names = document, new["label"], _words(old), _words(new)
    if limit is not None:
        return translate(
            "ThinPart", "{}: '{}' was '{}' and is '{}' now; its thinnest wall of {} is under the "
            "limit of {}.").format(*names, *_apart(new["thickness"], limit, unit))
    if new["thickness"] is None:
        return translate("ThinPart", "{}: '{}' was '{}' and is '{}' now; none of its walls could be "
                         "measured.").format(*names)
    return translate("ThinPart", "{}: '{}' was '{}' and is '{}' now; its thinnest wall is {}."
                     ).format(*names, unit.text(new["thickness"]))


def _apart(thickness, limit, unit):
    """Both in words that differ."""
    if unit.number(thickness) != unit.number(limit):
        return unit.text(thickness), unit.text(limit)
    return tuple(unit.with_symbol(f"{unit.value(each):.6g}") for each in (thickness, limit))


def _words(verdict):
    return category_words(verdict["category"], verdict["title"])
