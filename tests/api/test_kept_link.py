# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links of records: addresses of the web and files of the library, and nothing else."""

import os

import pytest

from thinpart_workbench.api.annotations import link_address
from thinpart_workbench.core.errors import ThinPartError


@pytest.fixture
def library(tmp_path):
    folder = tmp_path / "library" / "parts"
    folder.mkdir(parents=True)
    for name in ("drawing.pdf", "run.desktop", "Set up.EXE"):
        (folder / name).write_text("")
    (folder.parent / "norm.html").write_text("")
    (tmp_path / "secret.txt").write_text("")
    (folder / "out.txt").symlink_to(tmp_path / "secret.txt")
    (folder / "harmless.txt").symlink_to(folder / "run.desktop")
    return folder.parent


def address(text, library):
    return link_address(text, str(library), str(library / "parts" / "a.step.thinpart.json"))


@pytest.mark.parametrize("text", [
    "http://example.org", "https://example.org/job/7?a=b#c", "HTTPS://example.org", " https://example.org "])
def test_addresses_of_the_web(library, text):
    assert address(text, library) == text.strip()


@pytest.mark.parametrize("text, place", [
    ("drawing.pdf", "parts/drawing.pdf"), ("../norm.html", "norm.html"), (".", "parts"), ("..", "."),
    ("./drawing.pdf", "parts/drawing.pdf")])
def test_files_and_folders_of_the_library(library, text, place):
    assert address(text, library) == os.path.normpath(library / place)
    assert address(str(library / place), library) == os.path.normpath(library / place)


@pytest.mark.parametrize("text", [
    "javascript:alert(1)", "file:///etc/passwd", "FILE:drawing.pdf", "smb://host/share", "data:text/html,x", "ftp://a/b",
    "\\\\host\\share\\x", "//host/share/x", "mailto:a@b", "vscode://x", "ms-msdt:/id", "http://", "https://[",
    "/etc/passwd", "../../secret.txt", "out.txt", "http\u200b://example.org", "https://example.org/\u202efdp.exe",
    "a\nb", "x\0y"])
def test_anything_else_is_refused(library, text):
    with pytest.raises(ThinPartError, match="was not opened: a link may lead to http") as caught:
        address(text, library)
    assert caught.value.kind == "unsafe" and str(caught.value).isprintable()


@pytest.mark.parametrize("text", ["run.desktop", "Set up.EXE", "harmless.txt"])
def test_programs_are_refused(library, text):
    with pytest.raises(ThinPartError, match="is a program: it was not opened"):
        address(text, library)


@pytest.mark.parametrize("text", ["gone.pdf", "see the drawing"])
def test_what_is_not_there(library, text):
    with pytest.raises(ThinPartError, match="There is no file"):
        address(text, library)
