"""The documents say what the program does."""

import re
from dataclasses import fields
from pathlib import Path

import pytest

from thinpart_workbench.cli import COMMANDS
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.criteria import load_profile
from thinpart_workbench.core.descriptors import QUANTITIES

ROOT = Path(__file__).resolve().parents[1]


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


def test_every_quantity_is_in_the_description_of_the_info_file():
    rows = set(re.findall(r"^\| `(\w+)` \| (\S+) \|", text("docs/info-file.md"), re.MULTILINE))
    assert rows == {(quantity.name, quantity.symbol) for quantity in QUANTITIES}


def test_every_setting_is_described():
    for field in fields(AnalysisSettings):
        assert f"`{field.name}`" in text("docs/info-file.md")


def test_the_readme_has_the_papers_thresholds():
    readme = text("README.md")
    for criterion in load_profile("paper").criteria:
        row = next(line for line in readme.splitlines() if line.startswith(f"| {criterion.id} |"))
        for condition in criterion.conditions:
            symbol = condition.quantity.symbol
            if symbol.startswith("min_nonparallel"):
                symbol, value = "10 to 55 degrees", "0.05 diagonals"
            else:
                value = f"{condition.comparison} {condition.value:g}"
            assert symbol in row and value in row, row


@pytest.mark.parametrize("document", ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md",
                                      "CHANGELOG.md", "docs/info-file.md", "docs/cluster.md", "docs/platforms.md"])
def test_what_documents_point_at_is_there(document):
    folder = (ROOT / document).parent
    for target in re.findall(r"\]\(([^)#]+)\)", text(document)):
        assert target.startswith("http") or (folder / target).exists(), target
    for path in re.findall(r"`((?:tests|resources|docs|core|storage|workflow|gui|cli|"
                           r"freecad_adapter)/[\w./-]+\.\w+)`", text(document)):
        assert (ROOT / path).exists() or (ROOT / "thinpart_workbench" / path).exists(), path


def test_every_module_of_the_core_is_in_the_architecture():
    named = set(re.findall(r"`(\w+)`", text("ARCHITECTURE.md")))
    modules = {path.stem for path in (ROOT / "thinpart_workbench" / "core").glob("*.py")}
    assert modules - {"__init__", "errors"} <= named


def test_every_command_of_the_readme_exists():
    used = set(re.findall(r"\./thinpart (\w+)", text("README.md") + text("CONTRIBUTING.md")))
    assert used <= set(COMMANDS)


def test_no_file_has_grown_beyond_one_subject():
    for path in (ROOT / "thinpart_workbench").rglob("*.py"):
        assert len(path.read_text(encoding="utf-8").splitlines()) <= 400, path
