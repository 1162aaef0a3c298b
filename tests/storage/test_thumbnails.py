# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures in the cache: PNG files that other programs read, written whole or not at all."""

import resource
from pathlib import Path

import numpy as np
import pytest
from read_png import read_png

from thinpart_workbench.storage.cache_folder import cache_folder
from thinpart_workbench.storage.png import png_bytes
from thinpart_workbench.storage.thumbnails import thumbnail_path, write_thumbnail

SHA256 = "ab" * 32


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.mark.parametrize("shape", [(120, 160, 4), (1, 1, 4), (7, 3, 4)])
def test_another_program_reads_the_same_pixels(tmp_path, rng, shape):
    pixels = rng.integers(0, 256, shape, dtype=np.uint8)
    file = tmp_path / "picture.png"
    height, width, _ = shape
    file.write_bytes(png_bytes(pixels.tobytes(), width, height))
    assert (read_png(file) == pixels).all()


def test_the_cache_is_where_the_user_wants_it(cache, monkeypatch):
    assert cache_folder() == cache
    monkeypatch.delenv("THINPART_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", "/somewhere/else")
    assert cache_folder() == Path("/somewhere/else/thinpart")
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", "/home/of-someone")
    assert cache_folder() == Path("/home/of-someone/.cache/thinpart")


def test_one_picture_for_each_part_of_each_content(cache):
    names = ["Solid1", "Solid2", "a/b", "..", "", "\udcff", "Dübel" * 100]
    paths = {thumbnail_path(sha256, name) for sha256 in (SHA256, "cd" * 32) for name in names}
    assert len(paths) == 2 * len(names)
    assert {path.parent.parent for path in paths} == {cache / "thumbnails"}
    assert {path.parent.name for path in paths} == {"ab", "cd"}
    for path in paths:
        assert len(path.name) < 100 and path.name.isascii() and path.suffix == ".png"


@pytest.mark.parametrize("sha256", [
    "", None, 7, "../../../../etc/x", "/etc/shadow", "AB" * 32, "ab" * 31, "ab" * 32 + "\n", "\u0661" * 64,
    "ab" * 30 + "/../"])
def test_what_is_no_hash_becomes_no_path(sha256):
    assert thumbnail_path(sha256, "Solid1") is None


def test_written_and_written_again(cache):
    pixels = np.full((120, 160, 4), 200, np.uint8)
    for value in (200, 100):
        pixels[:] = value
        write_thumbnail(SHA256, "Solid1", pixels.tobytes())
        assert (read_png(thumbnail_path(SHA256, "Solid1")) == value).all()
    assert [path for path in cache.rglob("*") if path.is_file()] == [thumbnail_path(SHA256, "Solid1")]


def test_without_room_the_old_picture_stays_and_nothing_else(cache, rng):
    old, new = (rng.bytes(4 * 120 * 160) for _ in range(2))
    write_thumbnail(SHA256, "Solid1", old)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))  # no file may grow beyond that
    try:
        with pytest.raises(OSError):
            write_thumbnail(SHA256, "Solid1", new)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    path = thumbnail_path(SHA256, "Solid1")
    assert path.read_bytes() == png_bytes(old, 160, 120) and list(path.parent.iterdir()) == [path]


def test_without_a_home_no_folder_is_made_in_the_current_one(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", "~nobody-of-that-name/cache")
    monkeypatch.chdir(tmp_path)
    with pytest.raises((OSError, RuntimeError)):
        write_thumbnail(SHA256, "Solid1", np.zeros((120, 160, 4), np.uint8))
    assert list(tmp_path.iterdir()) == []
