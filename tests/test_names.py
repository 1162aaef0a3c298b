"""Every name that the code uses is defined, also on the paths that only a rare failure takes."""

import ast
from pathlib import Path

import pytest
from pyflakes import api, messages, reporter

ROOT = Path(__file__).resolve().parents[1]
FOLDERS = ("thinpart_workbench", "tests", "benchmarks", "resources")
FILES = [ROOT / "InitGui.py", *(file for folder in FOLDERS for file in sorted((ROOT / folder).rglob("*.py")))]
WRONG = (messages.UndefinedName, messages.UndefinedLocal, messages.UndefinedExport, messages.DuplicateArgument)


class _Wrong(reporter.Reporter):
    def __init__(self):
        super().__init__(None, None)
        self.found = []

    def flake(self, message):
        if isinstance(message, WRONG):
            self.found.append(str(message))

    def unexpectedError(self, filename, message):
        self.found.append(f"{filename}: {message}")

    def syntaxError(self, filename, message, lineno, offset, text):
        self.found.append(f"{filename}:{lineno}: {message}")


@pytest.mark.parametrize("file", FILES, ids=lambda file: str(file.relative_to(ROOT)))
def test_names_are_defined(file):
    wrong = _Wrong()
    api.checkPath(str(file), wrong)
    assert wrong.found == []


def test_what_is_not_defined_is_found():
    wrong = _Wrong()
    api.check("def f():\n    raise ThinPartError('x')\n", "made_up.py", wrong)
    assert len(wrong.found) == 1 and "ThinPartError" in wrong.found[0]


def test_no_two_classes_of_the_product_have_one_name():
    places = {}
    for file in sorted((ROOT / "thinpart_workbench").rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                places.setdefault(node.name, []).append(f"{file.relative_to(ROOT)}:{node.lineno}")
    assert len(places) > 200
    assert {name: found for name, found in places.items() if len(found) > 1} == {}
