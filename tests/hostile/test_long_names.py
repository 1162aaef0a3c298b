# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names that are too long for an info file, and a disk that fails when a name is looked up."""

import errno
import os
import shutil

import pytest
from program import SAMPLES, failures, thinpart

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.storage.info.stored_records import info_file_of

LONGEST = "a" * 250 + ".step"
"""As long as a name may be: that of its info file would be longer."""


@pytest.fixture(scope="module")
def long_name(tmp_path_factory):
    file = tmp_path_factory.mktemp("long") / LONGEST
    shutil.copyfile(SAMPLES / "plate.step", file)
    return file


def test_it_is_measured_and_told_why_there_is_no_info_file(long_name):
    run = thinpart("classify", long_name, "--json")
    assert failures(run) == {LONGEST: "info_write"} and '"category": "thin"' in run.stdout
    assert "The name is too long for an info file" in run.stderr


def test_a_note_cannot_be_kept_with_it(long_name):
    run = thinpart("note", long_name, "--set", "text")
    assert run.returncode == 1 and len(run.stderr.splitlines()) == 1
    assert "cannot be read (File name too long)" in run.stderr


def test_it_is_measured_to_find_parts_like_it(long_name, classified):
    run = thinpart("similar", long_name, classified, "--json")
    assert run.returncode == 0 and len(run.stdout.splitlines()) == 1, run.stderr


def test_a_disk_that_fails_is_told(classified, monkeypatch):
    info, stat = classified / "plate.step.thinpart.json", os.stat

    def failing(path, *arguments, **options):
        if os.fspath(path) == os.fspath(info):
            raise OSError(errno.EIO, os.strerror(errno.EIO), os.fspath(path))
        return stat(path, *arguments, **options)

    monkeypatch.setattr(os, "stat", failing)
    with pytest.raises(ThinPartError, match="cannot be read .Input/output error."):
        info_file_of(classified / "plate.step")
