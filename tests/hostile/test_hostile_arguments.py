# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every argument of every command, found from its parser, with what no program should be given: a sentence, no traceback."""

import argparse
import errno
import importlib
import os
import re

import pytest

from thinpart_workbench.cli import COMMANDS, main
from thinpart_workbench.cli.commands import note

NOT_ABOUT_FILES = {"demo", "gui", "install", "uninstall", "test"}
"""Commands that start FreeCAD or the tests."""

NEEDED = {"classify": ["--no-info"], "report": ["-o", "new"], "map": ["--png", "new.png"], "learn": ["--kept-labels"]}
"""What a command does not run without."""

FOREIGN = re.compile(r"Traceback|Errno|\w+Error\b|codec|exception", re.IGNORECASE)
"""Words of Python that no sentence for people has."""


WAITS = {("only", "pipe")}
"""Arguments that may be pipes, into which another program writes, and would be waited for."""


def arguments_of(command):
    """The actions of a command's parser that take a value of the user's choice."""
    parser = argparse.ArgumentParser()
    importlib.import_module(f"thinpart_workbench.cli.commands.{COMMANDS[command][0]}").add_arguments(parser)
    return [action for action in parser._get_positional_actions() + parser._get_optional_actions()
            if action.nargs != 0 and not action.choices]


def lines_of(command, values, library):
    """Command lines: one argument of each is hostile. Where parts would be measured, the folder is empty."""
    reads = command in ("find", "similar", "note", "reclassify", "learn")
    usual = {"path": [library / "plate.step"] if reads else ["none.step"], "roots": [library], "library": [library],
             "paths": [library] if reads else ["."]}
    arguments = arguments_of(command)
    places = [action for action in arguments if not action.option_strings]
    for chosen in arguments:
        if chosen.nargs == "+":  # a row or a sentence each, in one run
            given = [list(values.values())]
        else:
            count = chosen.nargs if isinstance(chosen.nargs, int) else 1
            given = [[value] * count for what, value in values.items() if (chosen.dest, what) not in WAITS]
        for each in given:
            line = [os.fspath(part) for action in places for part in (each if action is chosen else usual[action.dest])]
            needed = NEEDED.get(command, [])
            if chosen.option_strings:
                line += [chosen.option_strings[-1], *each]
                needed = [] if set(needed) & set(chosen.option_strings) else needed
            yield [command, *line, *needed]


@pytest.fixture
def values(tmp_path):
    """What is given in the place of every value, by what it is.

    No device is among them: a fault could replace it for the whole machine.
    """
    (tmp_path / "empty").touch()
    (tmp_path / "bytes").write_bytes(b"\xff\xfe\xfd")
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "loop").symlink_to("loop")
    (tmp_path / "broken").symlink_to("/proc/self/mem")  # a regular file whose reading fails
    names = ("missing", "empty", "bytes", "folder", "pipe", "loop", "broken", "empty/inside")
    return {**{name: os.fspath(tmp_path / name) for name in names}, "nothing": "",
            "suffix too long": os.fspath(tmp_path / ("a" * 250)), "name too long": "a" * 300, "path too long": "a/" * 3000,
            "not UTF-8": os.fsdecode(b"\xff\xfe"), "too many digits": "9" * 5000, "no number": "nan"}


@pytest.mark.parametrize("command", sorted(set(COMMANDS) - NOT_ABOUT_FILES))
def test_no_argument_ends_in_a_traceback(command, values, library, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path / "folder")
    for line in lines_of(command, values, library):
        try:
            status = main(line)
        except SystemExit as refused:  # by argparse
            status = refused.code
        told = capsys.readouterr().err
        assert status in (0, 1, 2), line
        assert not FOREIGN.search(told), (line, told[-500:])


@pytest.mark.parametrize("arguments", [
    ("find", "."), ("classify", "."), ("similar", "x", "."), ("learn", ".", "--kept-labels"), ("report", ".", "-o", "new"),
], ids=" ".join)
def test_a_current_folder_that_is_gone_is_told(arguments, tmp_path, monkeypatch, capsys):
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    assert main(list(arguments)) == 1
    assert capsys.readouterr().err == "thinpart: The current folder no longer exists: change to another one.\n"


def test_a_note_that_a_failing_disk_does_not_take_is_told(library, monkeypatch, capsys):
    def failing(handle):  # no disk fails on request
        raise OSError(errno.EIO, os.strerror(errno.EIO))

    monkeypatch.setattr(os, "fsync", failing)
    assert main(["note", os.fspath(library / "plate.step"), "--set", "text"]) == 1
    told = capsys.readouterr().err
    assert "could not be written (Input/output error)" in told and not FOREIGN.search(told)


def test_what_no_command_reports_itself_is_a_sentence(library, monkeypatch, capsys):
    def failing(options):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), "some/file")

    monkeypatch.setattr(note, "run", failing)
    assert main(["note", os.fspath(library / "plate.step")]) == 1
    assert capsys.readouterr().err.startswith("thinpart: some/file cannot be read or written (Permission denied): ")
