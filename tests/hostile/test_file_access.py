# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is written about a part that others may not read, they may not read either."""

import os
import stat

import pytest
from program import thinpart

from thinpart_workbench.storage.atomic_file import OWNER_ONLY, FileAccess, write_atomically
from thinpart_workbench.storage.info.info_file import change_info, read_info, write_info


def mode(path):
    return stat.S_IMODE(os.stat(path).st_mode)


@pytest.fixture(autouse=True)
def usual_mask():
    before = os.umask(0o022)
    yield
    os.umask(before)


def test_info_file_index_and_picture_of_a_private_part_are_private(library, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    part, info = library / "plate.step", library / "plate.step.thinpart.json"
    info.unlink()
    part.chmod(0o600)
    for command in ("classify", "size", "find"):
        run = thinpart(command, library)
        assert run.returncode == 0, run.stderr
    cached = [path for path in (tmp_path / "cache").rglob("*") if path.is_file()]
    assert {path.relative_to(tmp_path / "cache").parts[0] for path in cached} == {"index", "measured", "sizes", "thumbnails"}
    assert {mode(path) for path in (info, *cached)} == {0o600}
    index, = (path for path in cached if path.suffix == ".sqlite")
    index.chmod(0o644)  # of an earlier version
    assert thinpart("find", library).returncode == 0 and mode(index) == 0o600


@pytest.mark.parametrize("of_part, of_info, then", [
    (0o600, None, 0o600), (0o640, None, 0o640), (0o444, None, 0o644), (0o400, None, 0o600), (0o644, None, 0o644),
    (0o666, None, 0o644), (0o644, 0o600, 0o600), (0o600, 0o644, 0o600), (0o644, 0o664, 0o644), (0o664, 0o664, 0o664)])
def test_an_info_file_has_the_permissions_of_its_part(library, of_part, of_info, then):
    part, info = library / "plate.step", library / "plate.step.thinpart.json"
    content = read_info(info)
    part.chmod(of_part)
    if of_info is None:
        info.unlink()
    else:
        info.chmod(of_info)
    write_info(info, content)
    assert mode(info) == then
    change_info(info, lambda content: True)
    assert mode(info) == then


def test_of_several_files_the_narrowest_counts(tmp_path):
    for name, bits in (("a", 0o640), ("b", 0o604), ("c", 0o644)):
        (tmp_path / name).write_text("")
        (tmp_path / name).chmod(bits)
    assert FileAccess.of([tmp_path / "a", tmp_path / "c"]).mode == 0o640
    assert FileAccess.of([tmp_path / "a", tmp_path / "b"]).mode == 0o600
    assert FileAccess.of([tmp_path / "a", tmp_path / "missing"]).mode == 0o640
    assert FileAccess.of([tmp_path / "missing"]) is None


@pytest.mark.skipif(os.geteuid() != 0, reason="only root gives files to another group")
def test_the_group_is_that_of_the_part_or_may_no_more_than_everybody(tmp_path):
    secret, other = tmp_path / "secret", tmp_path / "other"
    for path, group in ((secret, 4321), (other, 4322)):
        path.write_text("")
        os.chown(path, -1, group)
        path.chmod(0o640)
    write_atomically(tmp_path / "of one", b"", access=FileAccess.of([secret]))
    status = os.stat(tmp_path / "of one")
    assert (status.st_gid, stat.S_IMODE(status.st_mode)) == (4321, 0o640)
    write_atomically(tmp_path / "of both", b"", access=FileAccess.of([secret, other]))
    assert mode(tmp_path / "of both") == 0o600


def test_nothing_of_it_can_be_read_before_it_is_whole(tmp_path):
    def look(temporary, path):
        assert mode(temporary) == 0o600
        os.replace(temporary, path)

    write_atomically(tmp_path / "file", b"secret", access=OWNER_ONLY, place=look)
    assert mode(tmp_path / "file") == 0o600
