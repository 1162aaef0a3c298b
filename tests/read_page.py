# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages of reports, read as a browser reads them."""

import os
import re
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote_to_bytes

VOID = {"meta", "link", "br", "img", "input", "hr", "image", "rect", "line", "circle", "stop"}


class Page(HTMLParser):
    """A page that was read: every tag is closed, and what it refers to is known."""

    def __init__(self, path):
        super().__init__(convert_charrefs=True)
        self.open, self.tags, self.references, self.words = [], [], [], []
        self.path = path
        self.feed(path.read_bytes().decode("utf-8"))
        self.close()
        assert self.open == [], path

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        self.references += [value for name, value in attributes if name in ("href", "src", "action", "data")]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        if tag not in VOID:
            assert self.open.pop() == tag, self.path

    def handle_data(self, data):
        if self.open and self.open[-1] not in ("style", "script"):
            self.words.append(data)

    @property
    def text(self):
        return " ".join(" ".join(self.words).split())

    def count(self, tag):
        return sum(each == tag for each, _ in self.tags)

    def targets(self):
        """Files beside the page that it refers to, by their bytes."""
        for reference in self.references:
            if not reference.startswith(("data:", "#")):
                yield Path(os.fsdecode(os.path.join(
                    os.fsencode(self.path.parent), unquote_to_bytes(reference))))


def pages(folder):
    """Every page of a report by its name, each checked on its own."""
    found = {}
    for path in folder.rglob("*.html"):
        page = found[path.relative_to(folder).as_posix()] = Page(path)
        assert page.count("h1") == 1
        assert not [each for each in page.references if re.match(r"(?!data:)\w+:|//", each)], path
        assert all(target.exists() for target in page.targets()), path
        assert not re.search(rb"url\((?!#)|@import", path.read_bytes())
        assert all(attributes.get("alt") is not None for tag, attributes in page.tags if tag == "img")
        drawn = [attributes for tag, attributes in page.tags if tag == "svg"]
        assert all(attributes["role"] == "img" and attributes["aria-label"] for attributes in drawn)
        headings = [attributes for tag, attributes in page.tags if tag == "th"]
        assert headings and all("scope" in attributes for attributes in headings)
    return found
