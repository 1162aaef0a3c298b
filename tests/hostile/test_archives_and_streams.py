# SPDX-License-Identifier: LGPL-2.1-or-later
"""Archives that cannot be unpacked, and outputs that take nothing more."""

import os
import re
import shutil
import struct
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from hostile_documents import harmless
from program import failures, thinpart

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def folder(freecad, tmp_path_factory):
    """Documents that are damaged in ways that Python's zipfile has exceptions of other kinds for."""
    folder = tmp_path_factory.mktemp("archives")
    content = harmless(freecad, folder / "whole.FCStd").read_bytes()
    with zipfile.ZipFile(folder / "whole.FCStd") as archive:
        entry = archive.getinfo("Document.xml")
        central = archive.start_dir
        packed = entry.header_offset + 30 + len("Document.xml")
    spoilt = bytearray(content)
    spoilt[packed:packed + 40] = bytes(255 - each for each in content[packed:packed + 40])
    (folder / "deflate.FCStd").write_bytes(spoilt)
    for name, offsets, value in (("encrypted", (6, 8), 1), ("method", (8, 10), 93)):
        changed = bytearray(content)
        struct.pack_into("<H", changed, entry.header_offset + offsets[0], value)
        struct.pack_into("<H", changed, central + offsets[1], value)
        (folder / f"{name}.FCStd").write_bytes(changed)
    shutil.copyfile(folder / "whole.FCStd", folder / "back\\slash.FCStd")
    return folder


def test_archives_that_cannot_be_unpacked_are_rows(folder):
    run = thinpart("classify", folder, "--json", "--no-info")
    assert failures(run) == {f"{name}.FCStd": "unreadable" for name in ("deflate", "encrypted", "method")}
    assert "Traceback" not in run.stderr
    assert run.stdout.count('"category"') >= 2  # the whole one, and the one with a backslash in its name


COMMANDS = [("find", "--json"), ("find",), ("reclassify", "--profile", "paper"), ("classify", "--json"),
            ("classify",)]


def _started(command, library, stdout):
    return subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench", command[0], os.fspath(library), *command[1:]],
        env=dict(os.environ, PYTHONPATH=os.fspath(ROOT)), stdin=subprocess.DEVNULL, stdout=stdout,
        stderr=subprocess.PIPE, text=True)


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_a_full_output_is_one_sentence(library, command):
    with open("/dev/full", "w") as full:
        run = _started(command, library, full)
        errors = run.communicate(timeout=60)[1]
    assert run.returncode == 1
    said = [line for line in errors.splitlines() if not line.startswith("{")]
    assert len(said) == 1 and re.fullmatch(
        r"thinpart: The output (could not|cannot) be written \(No space left on device\): make room.*\.", said[0]), errors


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_nobody_reads_the_output(library, command):
    reading, writing = os.pipe()
    os.close(reading)
    run = _started(command, library, writing)
    os.close(writing)
    errors = run.communicate(timeout=60)[1]
    assert "Traceback" not in errors and "Exception ignored" not in errors, errors


def test_no_name_and_no_note_commands_a_terminal(library):
    part = library / "red\x1b[31m.step"
    shutil.copyfile(library / "plate.step", part)
    (library / "bad\x1b[2J.step").write_text("x")
    runs = [thinpart("classify", library), thinpart("note", part, "--set", "one\x1b[5m\ntwo", "--link", "x\x1b]0;y\x07"),
            thinpart("note", part), thinpart("note", library / "no\x1b[2J.step"), thinpart("find", library),
            thinpart("similar", part, library), thinpart("reclassify", library, "--profile", "paper")]
    for run in runs:
        printed = run.stdout + run.stderr
        assert "\x1b" not in printed and "\x07" not in printed, run.args
    assert r"one\x1b[5m" in runs[2].stdout and "\n  two" in runs[2].stdout
