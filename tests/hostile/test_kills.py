# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that are killed at random moments: no note lost, no info file broken, nobody left running."""

import pytest
from kills import COMMANDS, Library, kill_commands


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """A library of twelve documents with notes."""
    return Library(tmp_path_factory.mktemp("kills") / "library", copies=2)


@pytest.mark.timeout(180)  # eight kills, each followed by a look at the whole library
@pytest.mark.parametrize("command", COMMANDS)
def test_nothing_is_lost_when_it_is_killed(library, command):
    kills = 3 if command in ("classify", "report", "size") else 8
    assert kill_commands(library, kills, COMMANDS.index(command) + 1, (command,)) == {command: kills}


@pytest.mark.timeout(180)  # all of them, over the whole library
def test_afterwards_every_command_does_all_of_its_work_and_nothing_is_left(library):
    library.finish()
