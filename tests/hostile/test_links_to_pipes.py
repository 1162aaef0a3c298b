# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document that links to a pipe, a device or a socket: that is not opened, the rest is measured."""

import os
import socket

import pytest
from hostile_documents import changed
from program import failures, records, thinpart

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.freecad_adapter.reading.closed_links import check_links, special_links


@pytest.fixture(scope="module")
def saved(freecad, tmp_path_factory):
    """A document with a block of its own and a link to a block in target.FCStd, which is gone."""
    folder = tmp_path_factory.mktemp("linked")
    target, document = freecad.newDocument("Target"), freecad.newDocument("Linking")
    try:
        for each, name in ((target, "Linked"), (document, "Own")):
            each.addObject("Part::Box", name)
            each.recompute()
            each.saveAs(os.fspath(folder / f"{'target' if each is target else 'linking'}.FCStd"))
        document.addObject("App::Link", "Link").LinkedObject = target.Linked
        document.recompute()
        document.save()
    finally:
        freecad.closeDocument(document.Name)
        freecad.closeDocument(target.Name)
    return folder / "linking.FCStd"


def linking(saved, folder, target):
    """The same document, with a link to another file."""
    return changed(saved, folder / "linking.FCStd",
                   lambda text: text.replace('file="target.FCStd"', f'file="{target}"'))


def _pipe(path):
    os.mkfifo(path)


def _socket(path):
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(os.fspath(path))


def _device(path):
    path.symlink_to("/dev/zero")


@pytest.mark.parametrize("make", [_pipe, _socket, _device])
def test_what_is_no_file_is_not_opened(make, saved, tmp_path):
    make(tmp_path / "other.FCStd")
    document = linking(saved, tmp_path, "other.FCStd")
    run = thinpart("classify", document, "--json", "--timeout", "40")
    assert failures(run) == {"linking.FCStd": "missing"}
    part, = (line for line in records(run) if "error" not in line)
    assert part["label"] == "Own"
    assert [each for each in part["warnings"] if "other.FCStd, which is a pipe, a device or a socket" in each]


def test_the_window_refuses_it(saved, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    document = linking(saved, tmp_path, "pipe")
    assert special_links(document) == [tmp_path / "pipe"]
    with pytest.raises(ThinPartError, match="links to pipe, which is a pipe") as told:
        check_links(document)
    assert told.value.kind == "unsafe"


def test_other_links_are_not_special(saved, tmp_path):
    for target in ("target.FCStd", "a" * 5000, ".", "x/" * 3000):
        check_links(linking(saved, tmp_path, target))


def test_a_link_to_a_name_that_is_too_long_is_a_missing_file(saved, tmp_path):
    run = thinpart("classify", linking(saved, tmp_path, "a" * 5000), "--json")
    assert failures(run) == {"linking.FCStd": "missing"} and len(records(run)) == 2
    assert "cannot be found" in run.stderr and "Errno" not in run.stderr
