# SPDX-License-Identifier: LGPL-2.1-or-later
"""A class is found by its name: no two of the product have the same."""

import ast
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def test_no_two_classes_of_the_product_have_one_name():
    places = {}
    for file in sorted((ROOT / "thinpart_workbench").rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                places.setdefault(node.name, []).append(f"{file.relative_to(ROOT)}:{node.lineno}")
    assert len(places) > 200
    assert {name: found for name, found in places.items() if len(found) > 1} == {}
