# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ThinPart needs: the table is about the commands and options that there are."""

import pytest

from thinpart_workbench import requirements
from thinpart_workbench.cli import COMMANDS, main

ASKED = {each for row in requirements.TABLE for each in row.commands}


def test_every_command_of_the_table_is_one_and_every_command_is_in_it():
    assert {each.partition(" ")[0] for each in ASKED} == set(COMMANDS)


@pytest.mark.parametrize("command, option", [each.split() for each in sorted(ASKED) if " " in each])
def test_every_option_of_the_table_is_one(command, option, capsys):
    with pytest.raises(SystemExit):
        main([command, "--help"])
    assert f"{option} " in capsys.readouterr().out
    bare, asked = requirements.required(command), requirements.required(command, [option])
    assert len(asked) > len(bare)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_does_arithmetic_and_help_needs_nothing(command):
    assert "python3-numpy" in {row.package for row in requirements.required(command)}
    assert requirements.required(command, ["--help"]) == []


@pytest.mark.parametrize("suite, has_it", [("bookworm", True), ("trixie", False), ("forky", True)])
def test_what_a_debian_lacks_is_not_asked_of_it(suite, has_it, capsys):
    requirements.main(["--all", "test", suite])
    packages = {line.partition("\t")[0] for line in capsys.readouterr().out.splitlines()}
    assert ("calculix-ccx" in packages) == has_it and {"gmsh", "freecad"} <= packages
