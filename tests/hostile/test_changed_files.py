# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file that changes while it is read is never shown as if it had not."""

import os
import shutil
import threading
from contextlib import contextmanager

import pytest
from program import SAMPLES, thinpart


@contextmanager
def changing(path):
    """Another program that saves a file again and again."""
    over = threading.Event()

    def touch():
        number = 0
        while not over.wait(0.002):
            number += 1
            os.utime(path, (number, number))

    thread = threading.Thread(target=touch)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


@pytest.mark.parametrize("arguments", [("size", "--force"), ("map", "--ply", "new.ply")], ids=" ".join)
def test_a_file_that_changes_while_it_is_read_is_told(arguments, tmp_path):
    file = tmp_path / "plate.step"
    shutil.copyfile(SAMPLES / "plate.step", file)
    command, *options = arguments
    with changing(file):
        run = thinpart(command, file, *options, cwd=tmp_path)
    assert run.returncode == 1 and "plate.step changed while it was read: measure it again." in run.stderr
    assert "wall" not in run.stdout and os.listdir(tmp_path) == ["plate.step"]


def test_a_size_of_a_file_that_changed_is_not_kept(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", os.fspath(tmp_path / "cache"))
    file = tmp_path / "plate.step"
    shutil.copyfile(SAMPLES / "plate.step", file)
    with changing(file):
        assert thinpart("size", file).returncode == 1
    assert not list((tmp_path / "cache").rglob("sizes/*.json"))
