# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pipe, a device or a socket is never replaced by a file, whoever runs the program."""

import os
import socket
import stat

import pytest

from thinpart_workbench.storage.atomic_file import write_atomically


def _pipe(path):
    os.mkfifo(path)


def _socket(path):
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(os.fspath(path))


def _link_to_a_pipe(path):
    os.mkfifo(path.with_name("target"))
    path.symlink_to("target")


@pytest.mark.parametrize("make", [_pipe, _socket, _link_to_a_pipe])
def test_what_is_no_file_is_not_replaced(make, tmp_path):
    path = tmp_path / "out.csv"
    make(path)
    before = os.lstat(path)
    with pytest.raises(OSError, match="it is not a regular file"):
        write_atomically(path, b"table")
    after = os.lstat(path)
    assert (after.st_ino, stat.S_IFMT(after.st_mode)) == (before.st_ino, stat.S_IFMT(before.st_mode))
    assert not [name for name in os.listdir(tmp_path) if name.startswith(".thinpart-")]


def test_a_file_and_a_link_to_one_are_replaced(tmp_path):
    (tmp_path / "link").symlink_to("file")
    (tmp_path / "file").write_bytes(b"old")
    for name in ("file", "link", "new"):
        write_atomically(tmp_path / name, b"new")
        assert (tmp_path / name).read_bytes() == b"new"
