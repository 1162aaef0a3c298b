# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document on limits of the wall says what the shipped table has, and its example can be used."""

import re
from pathlib import Path

from thinpart_workbench.core.judging.wall_limits import read_limits, shipped_limits

TEXT = (Path(__file__).resolve().parents[1] / "docs" / "limits.md").read_text(encoding="utf-8")


def test_its_table_is_the_shipped_one():
    def number(text):
        return None if text == "any" else float(text)

    rows = re.findall(r"^\| `([\w:]+)` \|[^|]+\| ([\d.]+|any) \| ([\d.]+|any) \|", TEXT, re.MULTILINE)
    assert {name: (number(least), number(most)) for name, least, most in rows} == {
        name: (limits.min_mm, limits.max_mm) for name, limits in shipped_limits().items()}


def test_its_example_can_be_read(tmp_path):
    (tmp_path / "own.json").write_text(re.search(r"```json\n(.*?)```", TEXT, re.DOTALL)[1], encoding="utf-8")
    found = read_limits(tmp_path / "own.json").values()
    assert [(each.name, each.min_mm) for each in found] == [("FDM", 1.2), ("FDM:TPU", 1.6)]
