# SPDX-License-Identifier: LGPL-2.1-or-later
"""Five hundred damaged files: a row each, and nothing else happens."""

import pytest
from fuzz import fuzz
from mutations import damaged


@pytest.mark.timeout(180)  # a hundred files, after many of which a new process has to load FreeCAD
@pytest.mark.parametrize("seed", range(1, 6))
def test_damaged_files_are_a_row_each(tmp_path, seed):
    became, _ = fuzz(tmp_path / "fuzz", 100, seed)
    assert sum(became.values()) == 100 and len(became) > 2


def test_the_same_seed_does_the_same_damage():
    content = b"ISO-10303-21;\n#1 = CARTESIAN_POINT('', (0.5, 1., 2.));\n" * 40
    assert damaged(content, "a.step", 7) == damaged(content, "a.step", 7) != damaged(content, "a.step", 8) != content
