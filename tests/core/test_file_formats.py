# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of file formats is the only one, and what people read agrees with it."""

import ast
from pathlib import Path

import pytest

from thinpart_workbench.core import file_formats
from thinpart_workbench.core.file_formats import CHOICES, DOCUMENT, ENDINGS, FORMATS, MESH, format_of, is_document

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_format_is_known_by_each_of_its_endings(ending):
    for name in (f"part{ending}", f"part{ending.upper()}", f"a.stl/b.c{ending}", Path("part").with_suffix(ending)):
        assert ending in format_of(name).endings
        assert is_document(name) == (ending == ".fcstd")


@pytest.mark.parametrize("name", ["part", "part.txt", "part.FCStd1", "step", "part.step.thinpart.json", ""])
def test_other_names_have_no_format(name):
    assert format_of(name) is None and not is_document(name)


def test_every_ending_stands_once_and_in_one_choice():
    assert len(set(ENDINGS)) == len(ENDINGS) == sum(len(each.endings) for each in FORMATS)
    assert sorted(sum(CHOICES.values(), ())) == sorted(ENDINGS)
    # Kept in the user's preferences.
    assert list(CHOICES) == ["FreeCAD", "STEP", "IGES", "BREP", "Mesh"]
    assert [each.name for each in FORMATS if each.kind == DOCUMENT] == ["FreeCAD"]


def test_the_readme_names_every_format():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    section = readme[readme.index("IGES, BREP, and the meshes") - 200:][:400]
    assert all(each.name in section for each in FORMATS)
    assert MESH in section


def test_no_other_module_lists_endings():
    for path in (ROOT / "thinpart_workbench").rglob("*.py"):
        if path.name not in ("snapshot.py", "file_marks.py") and path != Path(file_formats.__file__):  # of what is written
            texts = {node.value.lower() for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
                     if isinstance(node, ast.Constant) and isinstance(node.value, str)}
            assert not texts & set(ENDINGS), path
