# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finding the documents of large, broken and half-reachable trees."""

import errno
import os

import pytest

from thinpart_workbench.workflow.analysis.find_documents import Document, NameFilter, find_documents


def make(folder, *places):
    for place in places:
        file = folder / place
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(b"part")


def names(found, top):
    return [os.path.relpath(document.path, top) for document in found.documents]


def failures(found, top):
    return {os.path.relpath(path, top): (error.kind, str(error)) for path, error in found.failures}


def test_fifty_thousand_files_in_one_folder_cost_one_listing(tmp_path, monkeypatch):
    for number in range(50_000):
        os.close(os.open(tmp_path / f"{number:05}.step", os.O_CREAT | os.O_WRONLY))
    calls = {"realpath": 0, "scandir": 0, "listdir": 0}
    for module, name in ((os.path, "realpath"), (os, "scandir"), (os, "listdir")):
        real = getattr(module, name)

        def counted(*arguments, name=name, real=real, **options):
            calls[name] += 1
            return real(*arguments, **options)

        monkeypatch.setattr(module, name, counted)
    told = []
    found = find_documents([tmp_path], report=told.append)
    assert calls == {"realpath": 1, "scandir": 1, "listdir": 0}
    assert names(found, tmp_path) == [f"{number:05}.step" for number in range(50_000)]
    assert len(told) == 50 and told == sorted(told) and told[-1] == 49_000


def test_size_and_time_are_those_of_the_file(tmp_path):
    make(tmp_path, "real/a.step")
    (tmp_path / "real" / "a.step").write_bytes(b"12345")
    os.utime(tmp_path / "real" / "a.step", (7, 7))
    (tmp_path / "link.step").symlink_to("real/a.step")
    file = tmp_path / "real" / "a.step"
    assert find_documents([tmp_path]).documents == [Document(str(file), 5, 7.0)]
    assert find_documents([tmp_path / "link.step"]).documents == [
        Document(str(tmp_path / "link.step"), 5, 7.0)]


def test_info_files_and_hidden_files_are_no_documents(tmp_path):
    make(tmp_path, "a.step", "a.step.thinpart.json", ".thinpart-x.tmp", ".git/b.step", ".c.step", "notes.txt")
    assert names(find_documents([tmp_path]), tmp_path) == ["a.step"]
    everything = sorted(each for each in tmp_path.iterdir() if each.is_file())
    assert names(find_documents(everything), tmp_path) == [
        ".c.step", ".thinpart-x.tmp", "a.step", "notes.txt"]


def test_a_way_without_links_is_preferred(tmp_path):
    make(tmp_path, "real/a.step")
    (tmp_path / "also").symlink_to("real")
    (tmp_path / "real" / "loop").symlink_to(tmp_path)
    (tmp_path / "b.step").symlink_to("real/a.step")
    assert names(find_documents([tmp_path]), tmp_path) == ["real/a.step"]
    assert names(find_documents([tmp_path / "also", tmp_path]), tmp_path) == ["real/a.step"]
    assert names(find_documents([tmp_path / "also"]), tmp_path) == ["also/a.step"]


def test_links_that_lead_nowhere_are_named(tmp_path):
    make(tmp_path, "a.step")
    (tmp_path / "gone.step").symlink_to("nothing")
    (tmp_path / "self.step").symlink_to("self.step")
    (tmp_path / "folder").symlink_to("folder")
    (tmp_path / "text").symlink_to("nothing")
    found = find_documents([tmp_path])
    told = failures(found, tmp_path)
    assert names(found, tmp_path) == ["a.step"] and set(told) == {"gone.step", "self.step"}
    assert told["gone.step"][0] == "missing" and "leads nowhere" in told["gone.step"][1]
    assert "back to itself" in told["self.step"][1]
    assert set(failures(find_documents([tmp_path / "gone.step"]), tmp_path)) == {"gone.step"}


def test_a_name_that_is_not_there_is_left_to_the_reader(tmp_path):
    found = find_documents([tmp_path / "no.step"])
    assert found.documents == [Document(str(tmp_path / "no.step"), 0, 0.0)] and not found.failures


class Listing:
    """A listing of a folder on a share that goes away after some entries."""

    def __init__(self, listing, entries, error):
        self.listing, self.entries, self.error = listing, entries, error

    def __enter__(self):
        return self

    def __exit__(self, *reason):
        self.listing.close()

    def __iter__(self):
        for number, entry in enumerate(sorted(self.listing, key=lambda entry: entry.name)):
            if number == self.entries:
                raise OSError(self.error, os.strerror(self.error))
            yield entry


@pytest.mark.parametrize("error", [errno.EIO, errno.ESTALE, errno.ETIMEDOUT, errno.ENOTCONN])
@pytest.mark.parametrize("entries", [0, 1])
def test_a_share_that_goes_away_is_named_and_the_rest_goes_on(tmp_path, monkeypatch, error, entries):
    make(tmp_path, "a/1.step", "share/2.step", "share/3.step", "z/4.step")
    real = os.scandir

    def scandir(folder):
        listing = real(folder)
        return Listing(listing, entries, error) if os.path.basename(folder) == "share" else listing

    monkeypatch.setattr(os, "scandir", scandir)
    found = find_documents([tmp_path])
    assert names(found, tmp_path) == ["a/1.step", *["share/2.step"][:entries], "z/4.step"]
    kind, message = failures(found, tmp_path)["share"]
    assert kind == "unreadable" and os.strerror(error) in message and "folder share" in message


def test_a_folder_that_is_removed_meanwhile_is_no_failure(tmp_path, monkeypatch):
    make(tmp_path, "a/1.step", "b/2.step")
    real = os.stat

    def stat(path, *arguments, **options):
        if os.path.basename(path) == "b":
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
        return real(path, *arguments, **options)

    monkeypatch.setattr(os, "stat", stat)
    found = find_documents([tmp_path])
    assert names(found, tmp_path) == ["a/1.step"] and not found.failures


def test_what_the_report_raises_ends_the_search(tmp_path):
    make(tmp_path, "a.step")

    def report(count):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        find_documents([tmp_path], report=report)


@pytest.mark.parametrize("include, exclude, expected", [
    ((), (), ["Old/a.STEP", "Old/deep/c.step", "a.step", "b.stl", "new/d.step"]),
    (("*.step",), (), ["Old/a.STEP", "Old/deep/c.step", "a.step", "new/d.step"]),
    (("A.*", "b*"), (), ["Old/a.STEP", "a.step", "b.stl"]),
    (("old/*",), (), ["Old/a.STEP", "Old/deep/c.step"]),
    (("./NEW/*",), (), ["new/d.step"]),
    ((), ("old/*",), ["a.step", "b.stl", "new/d.step"]),
    ((), ("*/deep/*", "*.stl"), ["Old/a.STEP", "a.step", "new/d.step"]),
    (("*.step",), ("[ac].*",), ["new/d.step"]),
    (("nothing*",), (), []),
])
def test_globs_choose_files_of_folders(tmp_path, include, exclude, expected):
    make(tmp_path, "a.step", "b.stl", "Old/a.STEP", "Old/deep/c.step", "new/d.step")
    found = find_documents([tmp_path], NameFilter(include, exclude))
    assert names(found, tmp_path) == expected
    assert names(find_documents([tmp_path / "b.stl"], NameFilter(include, exclude)), tmp_path) == [
        "b.stl"]


def test_a_folder_that_is_left_out_is_not_even_listed(tmp_path, monkeypatch):
    make(tmp_path, "a.step", "archive/1.step", "archive/deep/2.step")
    real, listed = os.scandir, []

    def scandir(folder):
        listed.append(os.path.relpath(folder, tmp_path))
        return real(folder)

    monkeypatch.setattr(os, "scandir", scandir)
    assert names(find_documents([tmp_path], NameFilter((), ("Archive/*",))), tmp_path) == ["a.step"]
    assert listed == ["."]
