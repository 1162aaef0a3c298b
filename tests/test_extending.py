# SPDX-License-Identifier: LGPL-2.1-or-later
"""What docs/extending.md shows works: each example is put into a copy of the program, which then has what is new.

The descriptor is in tests/storage/test_new_quantity.py; the file format and the panel, which need FreeCAD, are in
tests/with_freecad/test_extending_freecad.py.
"""

import json
import re

import pytest
from copied_program import answer, copied_program, printed
from worked_examples import DOCUMENT, examples, follow_example

ROOT = DOCUMENT.parents[1]

JUDGE = """
import json
import made_library
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.record.part_record import descriptors_of

profile = load_profile("strips")
records = {shape: made_library.record_of(shape) for shape in ("long_plate", "plate", "cube")}
judged = {shape: classify(descriptors_of(record), profile) for shape, record in records.items()}
print(json.dumps({shape: [verdict.category, verdict.criteria] for shape, verdict in judged.items()}))
"""

STORE = """
from pathlib import Path
import made_library

plate, leaf = made_library.record_of("plate"), made_library.record_of("cube", label="leaf")
leaf["descriptors"]["thickness_mm"].update(min=None, median=None, max=None)
made_library.store(Path("library"), "two.step", [plate, {**leaf, "name": "Solid2"}])
"""


@pytest.fixture
def package(tmp_path):
    return copied_program(tmp_path)


def test_there_is_an_example_of_each_and_all_of_its_code_is_followed():
    assert list(examples()) == ["A criterion", "A descriptor", "A file format", "A command", "A panel"]
    assert all(examples().values())
    written = re.findall(r"^```\w", DOCUMENT.read_text(encoding="utf-8"), re.MULTILINE)
    assert sum(map(len, examples().values())) == len(written)


def test_code_goes_into_files_that_are_there_and_new_files_are_new():
    for blocks in examples().values():
        for block in blocks:
            assert (ROOT / block.file).is_file() == bool(block.place), block.file


def test_the_documents_lead_to_it():
    for name in ("ARCHITECTURE.md", "CONTRIBUTING.md"):
        assert "](docs/extending.md)" in (ROOT / name).read_text(encoding="utf-8")


def test_a_profile_with_a_new_criterion_judges(package):
    follow_example("A criterion", package)
    assert json.loads(answer(package, JUDGE)) == {
        "long_plate": ["strip", ["long and flat"]], "plate": ["normal", []], "cube": ["normal", []]}


def test_a_new_command_is_listed_and_runs(package):
    follow_example("A command", package)
    assert re.search(r"^ +thinnest +print the thinnest wall of stored parts$",
                     printed(package, "-m", "thinpart_workbench", "--help"), re.MULTILINE)
    answer(package, STORE)
    said = printed(package, "-m", "thinpart_workbench", "thinnest", "library/two.step")
    assert said.splitlines() == ["plate: 2 mm", "leaf: no wall"]
    needs = printed(package, str(package / "requirements.py"), "--all", "thinnest")
    assert needs == printed(package, str(package / "requirements.py"), "--all", "note") != ""
