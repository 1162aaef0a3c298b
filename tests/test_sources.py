# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every source names its licence in its first lines, as FreeCAD's index of add-ons asks for (docs/index-of-addons.md)."""

import fnmatch
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
LICENCE = "SPDX-License-Identifier: LGPL-2.1-or-later"

HEADS = {".py": f"# {LICENCE}", ".ini": f"# {LICENCE}", ".toml": f"# {LICENCE}", "": f"# {LICENCE}", ".js": f"// {LICENCE}",
         ".css": f"/* {LICENCE} */", ".svg": f"<!-- {LICENCE} -->", ".xml": f"<!-- {LICENCE} -->"}
"""The line by the ending of a file; those without one are scripts for the shell. It is the first, or stands below ``#!`` or
``<?xml``. JSON has no remarks; for it, texts, translations, pictures and CAD files, REUSE.toml names the licence."""

FOLDERS = (".ci", "benchmarks", "docs", "resources", "tests", "thinpart_workbench")


def sources():
    """Paths of all sources of the checkout."""
    found = [path for path in ROOT.iterdir() if path.is_file() and (path.suffix or path.name == "thinpart")]
    for folder in FOLDERS:
        found += [path for path in (ROOT / folder).rglob("*") if path.is_file()
                  and (path.suffix or path.parent.name == ".ci" or path.name == "on_debian")]
    return [path for path in sorted(found) if path.suffix in HEADS and "__pycache__" not in path.parts]


def test_every_source_names_its_licence():
    assert len(sources()) > 1000 and {path.suffix for path in sources()} == set(HEADS)
    lacking = []
    for path in sources():
        first, second = (path.read_text(encoding="utf-8").split("\n") + [""])[:2]
        if HEADS[path.suffix] != (second if first.startswith(("#!", "<?xml")) else first):
            lacking.append(path.relative_to(ROOT).as_posix())
    assert lacking == [], f"begin them with, for Python: {HEADS['.py']}"


def test_whatever_else_is_kept_has_its_licence_in_a_list():
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True)
    if listed.returncode or not listed.stdout:
        pytest.skip("no checkout")
    [patterns] = re.findall(r"^path = \[([^]]*)\]", (ROOT / "REUSE.toml").read_text(encoding="utf-8"), re.MULTILINE)
    patterns = [each.removeprefix("**/") for each in re.findall(r'"([^"]+)"', patterns)]
    heads = {path.relative_to(ROOT).as_posix() for path in sources()}
    others = [name for name in listed.stdout.split("\n") if name and name not in heads and name != "LICENSE"]
    assert [name for name in others if not any(fnmatch.fnmatch(Path(name).name, each) for each in patterns)] == []
