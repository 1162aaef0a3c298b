# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which page of the guide belongs to which command and panel, and where it is in a language."""

import re
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[3] / "docs" / "guide"

ENGLISH = "en"

CONTENTS = "README.md"

LIMITS = "ThinPart_Limits"
"""The page of the profile editor that has no command of its own."""

PAGE_OF = {
    "ThinPart_Classify": "judge-one-part.md",
    "ThinPart_ShowThickness": "read-the-map.md",
    "ThinPart_MeshSizes": "prepare-a-mesh.md",
    "ThinPart_ClassifyFolder": "a-folder-over-night.md",
    "ThinPart_Report": "judge-one-part.md#a-page-to-hand-on",
    "ThinPart_FindParts": "find-a-part-like-this.md",
    "ThinPart_EditProfile": "make-it-your-own.md",
    LIMITS: "limits-for-a-process.md",
    "ThinPart_LearnThresholds": "make-it-your-own.md",
    "ThinPart_ClearColours": "judge-one-part.md#colours",
    "ThinPart_Preferences": "make-it-your-own.md#preferences",
    "ThinPart_Guide": CONTENTS,
}
"""By the name that FreeCAD has for What's This: that of a command, also for its panel."""


def heading_anchor(heading):
    """The name by which links reach a heading, as on the pages of repositories: "A page" is "a-page"."""
    kept = "".join(each for each in heading.strip().lower() if each.isalnum() or each in " -_")
    return kept.replace(" ", "-")


def headings(text):
    """The headings of a page: list of str."""
    return re.findall(r"^#+ (.*)$", text, re.MULTILINE)


def languages():
    """Codes of the languages that the guide, or some of its pages, is in, English first: list of str."""
    return [ENGLISH, *sorted(each.name for each in FOLDER.iterdir() if each.is_dir())]


def page_in(language, page):
    """Where a page of the guide is in a language, or else in English.

    Parameters
    ----------
    language : str
        One of `languages`.
    page : str
        Name of a file of the guide, with ``#`` and the anchor of an English heading if it is to begin there.

    Returns
    -------
    file : Path
    anchor : str
        Of the heading in that file; empty for its beginning. Pages have the same headings in all languages.
    """
    name, _, anchor = page.partition("#")
    english, file = FOLDER / name, FOLDER / language / name
    if language == ENGLISH or not file.is_file():
        return english, anchor
    anchors = ([heading_anchor(each) for each in headings(path.read_text(encoding="utf-8"))] for path in (english, file))
    return file, dict(zip(*anchors)).get(anchor, "")
