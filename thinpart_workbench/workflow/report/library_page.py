# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a library."""

import base64
import hashlib

from ... import __version__
from .html_elements import element, own_file, page_bytes
from .library_counts import counts_section
from .library_likeness import families_section, groups_section
from .library_map import map_section
from .library_rows import parts_section, rows_element
from .page_language import page_language
from .page_words import PageWords
from .table_elements import cell, heading, row, table

_STYLE, _SCRIPT = "library.css", "library.js"

SHOWN_FILES = 10
"""Documents without info files and failures that are visible at first; more are collapsed."""


def library_page(language, unit, content):
    """Create the page: bytes.

    Parameters
    ----------
    language : str
        One of `LANGUAGES`.
    unit : LengthUnit
        Of all lengths on the page.
    content : LibraryContent
    """
    words = PageWords(page_language(language, unit), content.titles)
    _ = words.text
    count = len(content.parts)
    title = _("Library of 1 part") if count == 1 else _("Library of {count} parts", count=words.language.large(count))
    script = own_file("script", _SCRIPT)
    head = words.head(title, element("meta", http_equiv="Content-Security-Policy", content=_policy(script.text)),
                      own_file("style", _STYLE))
    body = element(
        "body",
        element("header", element("div", element("h1", title), element("p", content.place, class_="faint path")),
                _contents(words, content)),
        element("main", _remarks(words, content), *(_sections(words, content) if content.parts else ()),
                _failures(words, content.failures) if content.failures else None),
        element("footer", element("p", _("Made of what info files keep; no document was read."),
                                  f" ThinPart {__version__}."), class_="faint small"),
        [rows_element(words, content), script] if content.parts else None)
    return page_bytes(element("html", head, body, lang=language))


def _policy(script):
    """The page loads its own pictures, and runs its own script; nothing else, whatever gets into it."""
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    return f"default-src 'none'; style-src 'unsafe-inline'; img-src 'self' file:; script-src 'sha256-{digest}'"


def _contents(words, content):
    _ = words.text
    links = [("counts", _("Counts"), True), ("map", _("Map"), True), ("groups", _("More than once"), content.groups),
             ("families", _("Families"), content.families), ("parts", _("Parts"), True)]
    shown = [[" \u00b7 " if number else None, element("a", text, href=f"#{name}")]
             for number, (name, text, is_there) in enumerate(each for each in links if each[2])]
    return element("nav", shown, class_="small noprint", aria_label=_("Contents")) if content.parts else None


def _sections(words, content):
    return [counts_section(words, content), map_section(words, content.parts), groups_section(words, content),
            families_section(words, content), parts_section(words, content)]


def _remarks(words, content):
    """What the page does not show, and why."""
    _, said = words.text, []
    if not content.parts:
        said.append(element("p", _("None of these folders has an info file of a part: 'thinpart classify' writes them.")))
    count = len(content.unclassified)
    if count:
        sentence = _("1 document has no info file and is not on this page: 'thinpart classify' measures it.") if count == 1 \
            else _("{count} documents have no info file and are not on this page: 'thinpart classify' measures them.",
                   count=count)
        said.append(element("details", element("summary", sentence), element(
            "ul", *(element("li", file, class_="path") for file in content.unclassified))))
    if content.without_form:
        said.append(element("p", _("{count} parts were measured by an earlier version and are not compared: 'thinpart "
                                   "classify' measures their documents again.", count=content.without_form)))
    said += [element("p", words.sentence(problem)) for problem in content.problems[:SHOWN_FILES]]
    if len(content.problems) > SHOWN_FILES:
        said.append(element("details", element("summary", _("{count} more", count=len(content.problems) - SHOWN_FILES)),
                            *(element("p", words.sentence(problem)) for problem in content.problems[SHOWN_FILES:])))
    return element("div", said, class_="remarks") if said else None


def _failures(words, failures):
    _ = words.text
    rows = [row(heading(each.file, scope="row", class_="path"), cell(each.label or ""),
                cell(words.sentence(each.message), " ", element("span", f"[{each.kind}]", class_="faint small")))
            for each in failures]
    shown = table(_("These are not among the parts above"),
                  [heading(_("Document")), heading(_("Part")), heading(_("Reason"))], rows)
    if len(failures) > SHOWN_FILES:
        shown = element("details", element("summary", _("Show all {count}", count=len(failures))), shown)
    return element("section", element("h2", _("Could not be measured")), element("div", shown, class_="wide"), id="failed")
