# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which page of the guide belongs to which command and panel."""

from pathlib import Path

FOLDER = Path(__file__).resolve().parents[3] / "docs" / "guide"

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
