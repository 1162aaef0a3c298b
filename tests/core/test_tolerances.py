# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whoever looks for a tolerance finds it, or the module that has it, in `core/tolerances.py`."""

import ast
from pathlib import Path

from thinpart_workbench.core.tolerances import ELSEWHERE

PACKAGE = Path(__file__).resolve().parents[2] / "thinpart_workbench"
FOLDERS = ["freecad_adapter", *(f"core/{name}" for name in (
    "descriptors", "forms", "judging", "maps", "mesh", "rays", "record", "reuse", "risk", "shells", "sizing", "thickness",
    "walls"))]
NO_LIMITS = {"core.descriptors.descriptor_table", "freecad_adapter.preferences"}
"""Modules whose tables have numbers of other kinds."""


def has_limits(file):
    """Whether a module has public constants with fractions."""
    for node in ast.parse(file.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign):
            names = [each.id for target in node.targets for each in ast.walk(target) if isinstance(each, ast.Name)]
            values = [each.value for each in ast.walk(node.value) if isinstance(each, ast.Constant)]
            if any(isinstance(value, float) for value in values) and not all(name.startswith("_") for name in names):
                return True
    return False


def test_every_module_with_limits_is_named():
    found = {".".join(file.relative_to(PACKAGE).with_suffix("").parts)
             for folder in FOLDERS for file in (PACKAGE / folder).rglob("*.py") if has_limits(file)}
    assert len(found) > 40
    assert found - NO_LIMITS | {"freecad_adapter.shapes.tolerances"} == set(ELSEWHERE)
