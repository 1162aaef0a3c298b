# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts that a library has more than once, and its families, as sections of its page."""

from ...core.reuse.likeness import ALIKE, IDENTICAL, KINDS, MIRRORED, SCALED
from .html_elements import element
from .library_content import picture_address
from .table_elements import cell, heading, number_cell, number_heading, row, table

SHOWN_GROUPS = 20
"""Groups of a kind, and families, that are visible at first; the others are collapsed."""

OPEN_GROUPS, OPEN_PARTS = 5, 8
"""Groups whose parts are visible at first, and the greatest number of parts of such a group."""


def groups_section(words, content):
    """The section of groups, None where there are none."""
    _ = words.text
    if not content.groups:
        return None
    by_kind = {kind: [(number, group) for number, group in enumerate(content.groups, 1) if group.kind == kind]
               for kind in KINDS}
    kinds = []
    for kind, groups in by_kind.items():
        if groups:
            title, meaning = _kind(words, kind)
            shown = [_group(words, content, number, group, place < OPEN_GROUPS)
                     for place, (number, group) in enumerate(groups)]
            parts = sum(len(group.parts) - 1 for _number, group in groups)
            kinds += [element("h3", f"{title}: {words.language.large(parts)}", id=f"kind-{kind}"),
                      element("p", meaning, class_="small faint"), _folded(words, shown)]
    return element(
        "section", element("h2", _("More than once"), id="groups"),
        element("p", _("The first part of a group is the one to keep: geometry before triangles, the one used most, with "
                       "notes, in a document that FreeCAD can edit, with a name that somebody chose, the latest. The others "
                       "are compared with it, by what info files keep of their form. Nothing is deleted.")),
        element("p", _("{command} compares the documents themselves.", command="thinpart duplicates"), class_="small faint"),
        *kinds, aria_labelledby="groups")


def families_section(words, content):
    """The section of families, None where there are none."""
    _ = words.text
    if not content.families:
        return None
    shown = [_family(words, content, number, family, number <= OPEN_GROUPS)
             for number, family in enumerate(content.families, 1)]
    return element("section", element("h2", _("Families"), id="families"),
                   element("p", _("Parts whose faces are the same but for their sizes, with what varies, in {unit}.",
                                  unit=words.length.symbol)),
                   _folded(words, shown), aria_labelledby="families")


def _kind(words, kind):
    """Headline and meaning of a kind of likeness."""
    _ = words.text
    return {
        IDENTICAL: (_("Identical"), _("One form, wherever it lies, in whatever file, format or name.")),
        MIRRORED: (_("Mirrored"), _("Mirror images of the part to keep.")),
        SCALED: (_("Scaled"), _("The same form in another size.")),
        ALIKE: (_("Alike"), _("Most of the surface is the same, the rest is not: a hole more, another length.")),
    }[kind]


def _folded(words, shown):
    _ = words.text
    if len(shown) <= SHOWN_GROUPS:
        return shown
    more = element("summary", _("{count} more", count=words.language.large(len(shown) - SHOWN_GROUPS)))
    return [*shown[:SHOWN_GROUPS], element("details", more, *shown[SHOWN_GROUPS:], class_="more")]


def _group(words, content, number, group, may_be_open):
    _ = words.text
    title = _("Group {number}: {part}, {count} parts", number=number, part=content.parts[group.parts[0]].label,
              count=len(group.parts))
    rows = []
    for place, part in enumerate(group.parts):
        verdict = element("span", _("keep"), class_="badge keep") if place == 0 else words.sentence(group.said[place])
        rows.append(row(*_part(words, content.parts[part]), cell(verdict)))
    shown = table(title, [*_part_headings(words), heading(_("What shows it"))], rows, class_="group even")
    return _details(f"group-{number}", [title, _place(content, group)], shown, may_be_open and len(rows) <= OPEN_PARTS)


def _family(words, content, number, family, may_be_open):
    _ = words.text
    names = [_dimension(words, name) for name in family.varies]
    title = _("Family {number}: {part}, {count} parts", number=number, part=content.parts[family.parts[0]].label,
              count=len(family.parts))
    rows = [row(*_part(words, content.parts[part]),
                *(number_cell(words.length.number(values[place], 4)) for values in family.varies.values()))
            for place, part in enumerate(family.parts)]
    shown = table(title, [*_part_headings(words), *map(number_heading, names)], rows, class_="group")
    said = [title, _place(content, family), element("br"),
            element("span", _("varies: {names}", names=", ".join(names)), class_="small faint")]
    return _details(f"family-{number}", said, shown, may_be_open and len(rows) <= OPEN_PARTS)


def _place(content, several):
    """The document of the first part, beside its label, which may say nothing."""
    return [" ", element("span", content.parts[several.parts[0]].file, class_="small faint path")]


def _details(name, said, shown, is_open):
    return element("details", element("summary", said), element("div", shown, class_="wide"), id=name,
                   open="" if is_open else None)


def _part_headings(words):
    _ = words.text
    return [heading(element("span", _("Picture"), class_="small"), class_="small-picture"), heading(_("Part")),
            heading(_("Document"))]


def _part(words, part):
    _ = words.text
    picture = part.picture and element("img", src=picture_address(part.picture), alt=_("Picture of {part}", part=part.label),
                                       loading="lazy", width=80, height=60)
    return [cell(picture, class_="small-picture"), heading(part.label, scope="row"),
            cell(element("a", part.file, href=part.address) if part.address else part.file, class_="path")]


def _dimension(words, name):
    """A dimension in which the parts of a family differ, in words."""
    _ = words.text
    known = {"d1_mm": _("longest side"), "d2_mm": _("middle side"), "d3_mm": _("shortest side"),
             "thinnest_mm": _("thinnest wall")}
    if name in known:
        return known[name]
    return _("radius {number}", number=name.split("_")[1])
