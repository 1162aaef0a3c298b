# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elements of pages; whatever text is put into one is shown as text, whoever wrote it."""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

from ...core.foreign_text import html_text

FILES = Path(__file__).resolve().parents[3] / "resources" / "report"
"""Styles and scripts of pages."""

_RAW = {"style": "style.css", "script": "table.js"}
"""Elements whose content HTML does not escape, and the file of ours that each has: no text gets into them."""


def element(tag, *content, **attributes):
    """Make an element: xml.etree.ElementTree.Element.

    Parameters
    ----------
    tag : str
        Its name, but neither ``style`` nor ``script``: see `own_file`.
    *content
        Elements, texts and numbers, also in lists; None is left out.
    **attributes
        By their names, with ``_`` for ``-`` and ``class_`` for ``class``; None is left out.

    Raises
    ------
    ValueError
        For an element that takes no text.
    """
    if tag in _RAW:
        raise ValueError(f"The content of <{tag}> cannot be escaped: it comes from a file of ThinPart.")
    made = ElementTree.Element(tag, {name.rstrip("_").replace("_", "-"): html_text(str(value))
                                     for name, value in attributes.items() if value is not None})
    _fill(made, content)
    return made


def own_file(tag, name=None):
    """The element ``style`` or ``script`` with a file of ThinPart's own, by default the one of most pages."""
    made = ElementTree.Element(tag)
    made.text = (FILES / (name or _RAW[tag])).read_text(encoding="utf-8")
    return made


def page_bytes(root):
    """A whole page in HTML: bytes, UTF-8."""
    return b"<!DOCTYPE html>\n" + ElementTree.tostring(root, encoding="unicode", method="html").encode() + b"\n"


def _fill(made, content):
    for each in content:
        if isinstance(each, (list, tuple)):
            _fill(made, each)
        elif isinstance(each, ElementTree.Element):
            made.append(each)
        elif each is not None:
            text = html_text(str(each))
            if len(made):
                made[-1].tail = (made[-1].tail or "") + text
            else:
                made.text = (made.text or "") + text
