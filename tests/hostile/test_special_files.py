# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pipes, devices and folders that are called like info files or parts: each is a row, and none is waited for."""

import csv
import os
import shutil
import socket

import pytest
from program import records, thinpart

from thinpart_workbench.core.foreign_text import csv_text
from thinpart_workbench.core.regular_file import open_regular


def _pipe(path):
    os.mkfifo(path)


def _zeros(path):
    path.symlink_to("/dev/zero")


def _socket(path):
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(os.fspath(path))


def _loop(path):
    path.symlink_to(path)


KINDS = [_pipe, _zeros, _socket, _loop]


@pytest.fixture(scope="module")
def others(classified, tmp_path_factory):
    """A library of one part beside whose info file there is one of every kind that is none."""
    folder = shutil.copytree(classified, tmp_path_factory.mktemp("others") / "library")
    for make in KINDS:
        make(folder / f"{make.__name__}.step.thinpart.json")
    return folder


@pytest.fixture(scope="module", params=[("find",), ("similar", "plate.step"), ("reclassify", "--profile", "paper")],
                ids=" ".join)
def told(others, request):
    """A command, and what it says of that library."""
    arguments = [others / each if each.endswith(".step") else each for each in request.param]
    return request.param[0], thinpart(*arguments, others, "--json")


@pytest.mark.parametrize("make", KINDS)
def test_what_is_called_like_an_info_file_holds_nothing_up(told, make):
    command, run = told
    assert "Traceback" not in run.stderr
    parts = [line for line in records(run) if "error" not in line]
    assert [each["name"] for each in parts] == ([] if command == "similar" else ["Solid1"]), run.stdout + run.stderr
    # A link that leads nowhere is no file at all.
    assert (f"{make.__name__}.step.thinpart.json" in run.stdout + run.stderr) == (make is not _loop)


@pytest.mark.parametrize("command", [("classify",), ("find",), ("reclassify", "--profile", "paper")])
def test_a_link_to_itself_does_not_hide_its_folder(library, command):
    for name in ("loop", "loop.step"):
        _loop(library / name)
    run = thinpart(*command, library, "--json")
    assert "Traceback" not in run.stderr
    assert "plate.step" in [os.path.basename(line["file"]) for line in records(run) if "error" not in line]


def test_what_is_called_like_a_part_holds_nothing_up(library):
    made = [library / f"{make.__name__}.step" for make in KINDS]
    for make, path in zip(KINDS, made):
        make(path)
    run = thinpart("classify", *made, library / "plate.step", "--json", "--timeout", "20")
    kinds = {os.path.basename(line["file"]): line.get("error", {}).get("kind") for line in records(run)}
    assert kinds == {"plate.step": None, "_loop.step": "missing",
                     **dict.fromkeys(("_pipe.step", "_zeros.step", "_socket.step"), "unreadable")}


def test_regular_files_are_read(tmp_path):
    (tmp_path / "a").write_bytes(b"text")
    with open_regular(tmp_path / "a") as file:
        assert file.read() == b"text"
    for wrong in (tmp_path, "/dev/zero"):
        with pytest.raises(OSError, match="not a regular file|directory"):
            open_regular(wrong)


@pytest.mark.parametrize("text", ["=1+1", "+cmd", "-2", "@SUM(A1)", "\t=1", "\r=1"])
def test_no_spreadsheet_computes_a_name(text):
    cell, number = next(csv.reader(csv_text([(text, -2.5)]).splitlines(keepends=True)))
    assert cell == "'" + text and number == "-2.5"
