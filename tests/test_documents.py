# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documents say what the program does."""

import re
from dataclasses import fields
from pathlib import Path

import pytest

from benchmarks.tables import DOCUMENTS, with_tables
from thinpart_workbench.cli import COMMANDS
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.descriptor_table import listing
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.storage.info.info_definition import json_schema

ROOT = Path(__file__).resolve().parents[1]


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


def test_every_quantity_is_in_the_description_of_the_info_file():
    # python3 -m thinpart_workbench.core.descriptors.descriptor_table
    assert f"|---|---|---|---|\n{listing()}\n" in text("docs/info-file.md") + "\n"


def keys_of(schema):
    """All keys of objects that a schema describes."""
    for key, value in schema.get("properties", {}).items():
        yield key
        yield from keys_of(value)
    for inner in (*filter(None, [schema.get("items")]), *schema.get("oneOf", ())):
        yield from keys_of(inner)


def test_every_key_of_the_info_file_is_described():
    section = text("docs/info-file.md").partition("## Quantities")[0]
    assert [key for key in keys_of(json_schema()) if not re.search(rf"[`\"]{re.escape(key)}[`\"]", section)] == []


def test_every_setting_is_described():
    for field in fields(AnalysisSettings):
        assert f"`{field.name}`" in text("docs/info-file.md")


def test_the_readme_has_the_papers_thresholds():
    readme = text("README.md")
    for criterion in load_profile("paper").criteria:
        row = next(line for line in readme.splitlines() if line.startswith(f"| {criterion.id} |"))
        for condition in criterion.conditions:
            symbol = condition.quantity.symbol
            if condition.quantity.is_wall_distance:
                symbol, value = "10 to 55 degrees", "0.05 diagonals"
            else:
                value = f"{condition.comparison} {condition.value:g}"
            assert symbol in row and value in row, row


@pytest.mark.parametrize("document", ["README.md", "docs/method.md"])
def test_the_conditions_of_the_default_profile_are_stated(document):
    for criterion in load_profile().criteria:
        row = next(line for line in text(document).splitlines() if line.startswith(f"| {criterion.id} |"))
        for condition in criterion.conditions:
            named = f"{condition.quantity.symbol} {condition.comparison} {condition.value:g}"
            assert named in row or named.replace("_ratio", " ratio") in row


def test_the_probabilities_are_as_the_method_says():
    method = text("docs/method.md")
    for step in load_profile().content["probability"]["steps"]:
        assert f"s({step['intercept']:.2f} " in method
        for term in step["terms"]:
            sign = "+" if term["weight"] > 0 else "-"
            assert f"{sign} {abs(term['weight']):g} " in method and term["quantity"] in method


@pytest.mark.parametrize("document", ["README.md", "docs/method.md", "docs/limits.md", "ARCHITECTURE.md", "CONTRIBUTING.md",
                                      "CHANGELOG.md", "docs/info-file.md", "docs/cluster.md", "docs/platforms.md",
                                      "docs/extending.md", "docs/learning.md", "docs/index-of-addons.md", "docs/security.md",
                                      "SECURITY.md"])
def test_what_documents_point_at_is_there(document):
    folder = (ROOT / document).parent
    for target in re.findall(r"\]\(([^)#]+)\)", text(document)):
        assert target.startswith("http") or (folder / target).exists(), target
    for path in re.findall(r"`((?:tests|resources|docs|core|storage|workflow|gui|cli|"
                           r"freecad_adapter)/[\w./-]+\.\w+)`", text(document)):
        assert (ROOT / path).exists() or (ROOT / "thinpart_workbench" / path).exists(), path


def test_every_package_is_in_the_architecture():
    named = set(re.findall(r"`([\w/]+)`", text("ARCHITECTURE.md")))
    packages = {path.parent.relative_to(ROOT / "thinpart_workbench").as_posix()
                for path in (ROOT / "thinpart_workbench").rglob("__init__.py")} - {"."}
    assert packages - named == set()


def test_every_command_of_the_readme_exists():
    used = set(re.findall(r"\./thinpart (\w+)", text("README.md") + text("CONTRIBUTING.md")))
    assert used <= set(COMMANDS)


def test_tables_of_the_benchmark_are_what_its_command_makes_of_the_results_files():
    # python3 benchmarks/tables.py --write
    for name in DOCUMENTS:
        document = text(name)
        assert "<!-- benchmark " in document
        assert with_tables(document) == document
