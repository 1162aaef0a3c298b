# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page with all parts of a report."""

from ... import __version__
from .html_elements import element, own_file, page_bytes
from .page_language import page_language
from .page_words import TIMES, PageWords
from .table_elements import cell, heading, number_cell, number_heading, row, table


def overview_page(language, unit, tree, profile, titles, categories, limits, parts, failures):
    """Create the page: bytes.

    Parameters
    ----------
    language : str
        One of `LANGUAGES`.
    unit : LengthUnit
        Of all lengths on the page.
    tree : str
        What is named as the place of the documents.
    profile : dict
    titles : dict
        Titles of the categories by their names.
    categories : list of (str, int)
        How many parts are of each category.
    limits : sequence of WallLimits
        What the walls were checked against.
    parts : list of PartSummary
    failures : list of FailureSummary
    """
    words = PageWords(page_language(language, unit), titles)
    _ = words.text
    title = _("Wall thickness of 1 part") if len(parts) == 1 else _("Wall thickness of {count} parts", count=len(parts))
    return page_bytes(element(
        "html", words.head(title), element(
            "body",
            element("header",
                    element("div", element("h1", title), element("p", tree, class_="faint path")),
                    element("p", _("Tables:"), " ", element("a", "parts.csv", href="parts.csv"), ", ",
                            element("a", "faces.csv", href="faces.csv"), class_="small")),
            element("main", _counts(words, categories, failures), _parts(words, limits, parts) if parts else None,
                    _failures(words, failures) if failures else None),
            element("footer", element("p", _("Judged by the profile “{profile}”.", profile=words.profile_title(profile)),
                                      f" ThinPart {__version__}."), class_="faint small"),
            own_file("script")),
        lang=language))


def _counts(words, categories, failures):
    _ = words.text
    shown = [[element("span", element("span", class_=f"dot {name}"), element("b", count), " ", words.category_word(name),
                     class_="count", data_category=name), " "] for name, count in categories]
    if failures:
        shown.append(element("span", element("span", class_="dot failed"), element("b", len(failures)), " ",
                             element("a", _("failed"), href="#failed"), class_="count"))
    return element("div", shown, class_="counts", id="counts")


def _parts(words, limits, parts):
    _ = words.text
    headings = [
        heading(element("span", _("Picture"), class_="small")), heading(_("Part"), data_sort="text"),
        heading(_("Document"), data_sort="text"), heading(_("Category"), data_sort="text"),
        number_heading(_("Thinnest"), data_sort="number"),
        *(heading(words.sentence(each.full_title), data_sort="text") for each in limits),
        number_heading(_("Thin share"), data_sort="number"), number_heading(_("Margin"), data_sort="number"),
        number_heading(_("Box"), data_sort="number")]
    caption = _("Thickness and box: {unit}. The margin is how far the deciding quantities lie from another category, "
                "relative to their thresholds.", unit=words.length.symbol)
    return element("div", table(caption, headings, [_part(words, part) for part in parts], class_="parts", id="parts"),
                   class_="wide")


def _part(words, part):
    _ = words.text
    warnings = None
    if part.warnings:
        warnings = [element("br"), element("span", _("1 warning") if part.warnings == 1 else
                                           _("{count} warnings", count=part.warnings), class_="small faint")]
    picture = element("img", src=part.picture, alt="", loading="lazy", width=120, height=80)
    return row(
        cell(element("a", picture, href=part.page, tabindex="-1", aria_hidden="true"), class_="picture"),
        heading(element("a", part.label, href=part.page),
                [" ", element("span", f"{TIMES}{part.instances}", class_="faint")] if part.instances > 1 else None,
                warnings, scope="row"),
        cell(part.file, class_="path"),
        cell(element("span", words.headline_word(part.category, part.between), class_=f"badge {part.category}"),
             data_value=part.category),
        number_cell(words.length.number(part.thinnest),
                    [element("br"), element("span", words.place(part.place), class_="small faint")] if part.place else None,
                    data_value=_sorted_by(part.thinnest)),
        *(cell(words.holds(check["passes"]), title=words.sentence(check["sentence"])) for check in part.checks),
        number_cell(words.percent(part.thin_share), data_value=part.thin_share),
        number_cell(words.percent(part.margin),
                    [element("br"), element("span", _("borderline"), class_="small")]
                    if part.borderline and not part.between else None,
                    data_value=_sorted_by(part.margin)),
        number_cell(words.box(part.box), data_value=part.diagonal),
        data_category=part.category)


def _sorted_by(value):
    return "" if value is None else value


def _failures(words, failures):
    _ = words.text
    rows = [row(heading(each.file, scope="row", class_="path"), cell(each.label or ""),
                cell(words.sentence(each.message), " ", element("span", f"[{each.kind}]", class_="faint small")))
            for each in failures]
    return element("section", element("h2", _("Could not be measured")),
                   table(_("These are not in the table above"),
                         [heading(_("Document")), heading(_("Part")), heading(_("Reason"))], rows),
                   id="failed")
