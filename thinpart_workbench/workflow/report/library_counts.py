# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many parts of a library are of each category, risk, format and folder."""

import os
from collections import Counter

from ...core.categories import NORMAL
from ...core.file_formats import format_of
from ...core.judging.criteria import UNKNOWN
from .html_elements import element
from .table_elements import cell, heading, number_cell, number_heading, row, table

SHOWN_FOLDERS = 12
"""Folders that are visible at first; the others are collapsed."""

RISKS = (0.1, 0.25, 0.5)
"""Where the bands of risk end."""

_FIRST, _LAST = ("thin", "thin_features"), (NORMAL, UNKNOWN)


def categories_of(parts):
    """Names of the categories that parts have, in the order in which they are listed: list of str."""
    count = Counter(part.category for part in parts)
    others = sorted(set(count) - {*_FIRST, *_LAST})
    return [name for name in (*_FIRST, *others, *_LAST) if count[name]]


def counts_section(words, content):
    """The section with the counts, of which those of the categories choose what the map and the table show."""
    _ = words.text
    parts, names = content.parts, categories_of(content.parts)
    count = Counter(part.category for part in parts)
    shown = [[element("span", element("span", class_=f"dot {name}"), element("b", words.language.large(count[name])), " ",
                      words.category_word(name), class_="count", data_category=name,
                      data_word=words.category_word(name)), " "] for name in names]
    unsure = sum(part.borderline for part in parts)
    if content.failures:
        shown.append(element("span", element("span", class_="dot failed"), element("b", len(content.failures)), " ",
                             element("a", _("failed"), href="#failed"), class_="count"))
    return element(
        "section", element("h2", _("Counts"), id="counts-title"),
        element("div", shown, class_="counts", id="counts"),
        element("p", _("{count} of them are unsure: close to another category.", count=unsure), class_="small faint")
        if unsure else None,
        element("div", _by_risk(words, parts, names), _by_format(words, parts, names), _by_folder(words, parts, names),
                class_="tables"),
        id="section-counts", aria_labelledby="counts-title")


def _by_risk(words, parts, names):
    _ = words.text
    bounds = (0.0, *RISKS)
    titles = [_("below {share}", share=words.percent(RISKS[0])),
              *(_("{low} to {high}", low=words.percent(low), high=words.percent(high))
                for low, high in zip(RISKS, RISKS[1:])),
              _("{share} and more", share=words.percent(RISKS[-1])), _("unknown")]

    def band(part):
        return len(bounds) if part.risk is None else max(number for number, bound in enumerate(bounds) if part.risk >= bound)

    groups = _grouped(parts, band)
    return _table(words, _("Risk of the automatic mesh"), names,
                  [(titles[number], groups[number]) for number in sorted(groups)])


def _by_format(words, parts, names):
    _ = words.text

    def name(part):
        found = format_of(part.file)
        return found.name if found else _("other")

    groups = _grouped(parts, name)
    return _table(words, _("Format"), names, sorted(groups.items(), key=lambda group: -len(group[1])))


def _by_folder(words, parts, names):
    _ = words.text
    folder_of = top_folders([part.file for part in parts])
    groups = _grouped(parts, lambda part: folder_of[part.file])
    rows = sorted(groups.items(), key=lambda group: (-len(group[1]), group[0]))
    rows = [(folder or _("(in no folder of its own)"), group) for folder, group in rows]
    first = _table(words, _("Folder"), names, rows[:SHOWN_FOLDERS])
    if len(rows) <= SHOWN_FOLDERS:
        return first
    rest = _table(words, _("Folder"), names, rows[SHOWN_FOLDERS:])
    return element("div", first, element("details", element(
        "summary", _("{count} more folders", count=len(rows) - SHOWN_FOLDERS)), rest))


def top_folders(files):
    """By path: the folder by which it is counted, the first one below what all have in common; "" for none.

    Parameters
    ----------
    files : list of str
        With ``/`` between folders.
    """
    folders = {file: file.split("/")[:-1] for file in files}
    shared = len(os.path.commonprefix(list(folders.values()))) if folders else 0
    return {file: "/".join(folder[:shared + 1]) for file, folder in folders.items()}


def _grouped(parts, key):
    groups: dict = {}
    for part in parts:
        groups.setdefault(key(part), []).append(part)
    return groups


def _table(words, title, names, groups):
    _ = words.text
    most = max(len(group) for _name, group in groups)
    rows = [row(heading(name, scope="row", class_="path"), number_cell(words.language.large(len(group))),
                cell(_bar(words, group, names, most), class_="bars")) for name, group in groups]
    return table(title, [heading(title), number_heading(_("Parts")), heading(_("By category"))], rows, class_="few")


def _bar(words, group, names, most):
    """A bar as long as the group is large, in the colours of its categories."""
    count = Counter(part.category for part in group)
    said = ", ".join(f"{count[name]} {words.category_word(name)}" for name in names if count[name])
    return element("span", *(element("span", class_=f"piece {name}", style=f"width: {100.0 * count[name] / most:.4g}%")
                             for name in names if count[name]), class_="bar", role="img", aria_label=said, title=said)
