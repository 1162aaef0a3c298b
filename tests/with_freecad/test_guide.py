# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command of the guide runs, and its links and pictures are there."""

import re
import shlex
import shutil
from pathlib import Path

import pytest
from program import ROOT, SAMPLES, thinpart

PAGES = sorted((ROOT / "docs" / "guide").glob("*.md"))


def commands(page):
    return [line.strip() for line in page.read_text(encoding="utf-8").splitlines() if line.strip().startswith("./thinpart ")]


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    """Every page measures the same bytes: the first of them, for all."""
    return tmp_path_factory.mktemp("cache")


@pytest.fixture
def folder(tmp_path, monkeypatch, cache):
    """A folder with the samples, as the guide has it."""
    shutil.copytree(SAMPLES, tmp_path / "parts", ignore=shutil.ignore_patterns("*.py", "*.json", "sample_parts"))
    monkeypatch.setenv("THINPART_CACHE", str(cache))
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.timeout(180)  # the first page measures all samples
@pytest.mark.parametrize("page", [page for page in PAGES if commands(page)], ids=lambda page: page.stem)
def test_the_commands_of_a_page_do_what_they_say(page, folder):
    if "--fails" in page.read_text(encoding="utf-8"):
        assert thinpart("classify", "parts").returncode == 0  # the library that the page speaks of
    for command in commands(page):
        arguments = shlex.split(command)[1:]
        if {"--check", "--shell"} & set(arguments) and arguments[0] == "size" and shutil.which("gmsh") is None:
            continue
        run = thinpart(*arguments)
        assert run.returncode == 0, (command, run.stderr)
        assert run.stdout.strip() or "-o" in arguments, command


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_links_and_pictures_of_a_page_are_there(page):
    targets = re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    assert targets or page.stem == "glossary"
    for target in targets:
        assert target.startswith("https://") or (page.parent / target).exists(), target


def test_the_worked_examples_are_true(folder):
    bracket = thinpart("classify", "parts/bent_sheet_bracket.step", "--regions").stdout
    assert "thin" in bracket and "plate, 2 mm thick" in bracket and "100 % of the volume" in bracket
    assert "normal" in thinpart("classify", "parts/block.step").stdout
    paper = thinpart("classify", "parts/flange.step", "--profile", "paper", "--no-info").stdout
    assert "thin_features" in paper
    assert "normal" in thinpart("classify", "parts/flange.step", "--no-info").stdout
    assert "passes" in thinpart("classify", "parts/thin_walled_casting.step", "--check", "die_casting:zinc").stdout


def test_every_page_is_in_the_list():
    listed = set(re.findall(r"\]\(([a-z-]+\.md)\)", (ROOT / "docs" / "guide" / "README.md").read_text(encoding="utf-8")))
    assert listed == {page.name for page in PAGES} - {"README.md"}
    assert all(Path(name).suffix == ".md" for name in listed)
