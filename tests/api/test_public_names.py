# SPDX-License-Identifier: LGPL-2.1-or-later
"""The names of the package: they cost nothing before they are used, and programs and the command line share them."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest
from program import ROOT, environment

import thinpart_workbench as thinpart

PACKAGE = Path(thinpart.__file__).parent

WORK = {"analyse_files", "analyse_files_on_cluster", "analyse_file", "analyse_part", "find_documents", "find_parts",
        "open_library", "similar_parts", "reclassify_files", "plan_run"}
"""Functions below that do what the library offers."""


@pytest.mark.parametrize("name", thinpart.__all__)
def test_every_name_is_there_and_documented(name):
    assert name in dir(thinpart)
    value = getattr(thinpart, name)
    if name != "__version__":
        assert value.__doc__ and value.__name__ == name
        assert f"`{name}" in (ROOT / "docs" / "python.md").read_text(encoding="utf-8")


def test_what_is_not_there_is_no_name():
    misspelt = "clasify"
    with pytest.raises(AttributeError, match="has no attribute 'clasify'"):
        getattr(thinpart, misspelt)


def test_importing_the_package_loads_nothing():
    program = "import sys, thinpart_workbench; print(*sorted(set(sys.modules) & {'numpy', 'scipy', 'FreeCAD', 'json'}))"
    ran = subprocess.run([sys.executable, "-c", program], env=environment(), capture_output=True, encoding="utf-8")
    assert (ran.stdout, ran.returncode) == ("\n", 0), ran.stderr


def test_the_command_line_does_its_work_by_the_library():
    called = set()
    for path in sorted((PACKAGE / "cli").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom):
                called |= {f"{path.name}: {each.name}" for each in node.names if each.name in WORK}
    assert called == set()
