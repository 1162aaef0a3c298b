# SPDX-License-Identifier: LGPL-2.1-or-later
import json
import os
import signal
import subprocess
import sys
import time
import zipfile

import made_library
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.message import message
from thinpart_workbench.storage.atomic_file import write_atomically
from thinpart_workbench.storage.info import info_file

SETTINGS, PROFILE = AnalysisSettings().content(), made_library.PAPER.content


@pytest.fixture
def document(tmp_path):
    path = tmp_path / "part.step"
    path.write_bytes(b"some geometry")
    return path


def content_of(document, notes=""):
    source = info_file.new_source(document)
    return info_file.info_content(source, SETTINGS, PROFILE, [made_library.record_of("plate", notes=notes)])


def test_round_trip_and_stable_bytes(document):
    path = info_file.info_path(document)
    info_file.write_info(path, content_of(document))
    assert path.name == "part.step.thinpart.json"
    assert info_file.read_info(path) == content_of(document)
    first = path.read_bytes()
    info_file.write_info(path, content_of(document))
    assert path.read_bytes() == first and first.decode("utf-8").endswith("\n")


def test_the_paths_of_many_documents_are_those_of_each(tmp_path):
    for document in ("/tree/a/x.step", "/tree/x.step", "x.step", "a/b.step"):
        beside = info_file.info_path_getter()(document)
        assert os.path.abspath(beside) == os.path.abspath(info_file.info_path(document))
        mirrored = info_file.info_path_getter(tmp_path, "/tree")(document)
        assert mirrored == str(info_file.info_path(document, tmp_path, "/tree"))


def test_current_as_long_as_document_settings_and_profile_are_the_same(document):
    content = content_of(document)
    current = info_file.is_current
    assert current(content, document, SETTINGS, PROFILE)
    assert not current(content, document, {"measure": "pairs"}, PROFILE)
    assert not current(content, document, SETTINGS, {"name": "house"})
    os.utime(document, (5, 5))
    assert current(content, document, SETTINGS, PROFILE)  # the hash decides
    document.write_bytes(b"same length!!")
    assert not current(content, document, SETTINGS, PROFILE)
    document.unlink()
    assert not current(content, document, SETTINGS, PROFILE)


def test_notes_survive(document):
    path = info_file.info_path(document)
    info_file.write_info(path, content_of(document, notes="meshed with 3 layers"))
    info_file.write_info(path, content_of(document))
    assert info_file.read_info(path)["parts"][0]["notes"] == "meshed with 3 layers"


def test_notes_that_come_with_a_new_analysis_replace_the_old_ones(document):
    path = info_file.info_path(document)
    info_file.write_info(path, content_of(document, notes="meshed with 3 layers"))
    info_file.write_info(path, content_of(document, notes="meshed with 4 layers"))
    assert info_file.read_info(path)["parts"][0]["notes"] == "meshed with 4 layers"


def test_what_sentences_are_made_of_is_kept(document):
    path, content = info_file.info_path(document), content_of(document)
    said = message("{count} duplicate triangles were left out.", count=3)
    content["parts"][0]["warnings"] = [said, "Somebody else's."]
    info_file.write_info(path, content)
    stored = json.loads(path.read_bytes())
    assert stored["parts"][0]["warnings"] == ["3 duplicate triangles were left out.", "Somebody else's."]
    assert stored["messages"] == [{"template": said.template, "fields": {"count": 3}}]

    def annotate(content):
        content["parts"][0]["notes"] = "mine"
        return True

    info_file.change_info(path, annotate)
    told = info_file.read_info(path)
    assert told["parts"][0]["notes"] == "mine" and told["parts"][0]["warnings"][0].fields == {"count": 3}
    assert "messages" not in told


def test_of_sentences_that_are_no_more_nothing_is_kept(document):
    path, content = info_file.info_path(document), content_of(document)
    content["parts"][0]["warnings"] = [message("It holds no triangles.")]
    info_file.write_info(path, content)
    info_file.change_info(path, lambda content: content["parts"][0].update(warnings=[]) is None)
    assert "messages" not in json.loads(path.read_bytes())


def test_links_are_looked_at_too(tmp_path, document):
    near, far = tmp_path / "near.FCStd", tmp_path / "lib" / "far.FCStd"
    far.parent.mkdir()
    for link in (near, far):
        save_fcstd(link, "other geometry")
    links = [near, far, tmp_path / "gone.FCStd"]
    source = info_file.new_source(document, links)
    assert [each["file"] for each in source["links"]] == ["near.FCStd", "lib/far.FCStd", "gone.FCStd"]

    def current(links):
        content = info_file.info_content(info_file.new_source(document, links), SETTINGS, PROFILE, [])
        return lambda: info_file.is_current(content, document, SETTINGS, PROFILE)

    missing, whole = current(links), current(links[:2])
    assert not missing() and whole()
    os.utime(near, (5, 5))
    assert whole()  # the hash decides
    save_fcstd(far, "same length!!!")
    assert not whole() and not info_file.source_is_unchanged(source, document)
    far.unlink()
    assert not whole()


def save_fcstd(path, text):
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("Document.xml", text)


def test_of_files_that_are_no_documents_a_link_tells_nothing(tmp_path, document):
    """Whoever sends a document must not learn what lies on the machine of whoever opens it."""
    secret, packed, disguised = tmp_path / "shadow", tmp_path / "packed.zip", tmp_path / "shadow.FCStd"
    secret.write_text("root:$6$...")
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr("secret", "...")
    disguised.symlink_to(secret)
    os.mkfifo(tmp_path / "pipe.FCStd")
    links = [secret, packed, disguised, tmp_path / "pipe.FCStd", tmp_path]
    source = info_file.new_source(document, links)
    assert [each["file"] for each in source["links"]] == [
        os.path.relpath(link, document.parent) for link in links]
    assert all(each[key] is None for each in source["links"] for key in ("sha256", "bytes", "modified"))
    # That is no reason to measure again and again, nor does it look as if they had changed.
    content = info_file.info_content(source, SETTINGS, PROFILE, [])
    assert info_file.is_current(content, document, SETTINGS, PROFILE)
    assert info_file.source_is_unchanged(source, document)
    secret.write_text("changed")
    assert info_file.is_current(content, document, SETTINGS, PROFILE)
    disguised.unlink()
    save_fcstd(disguised, "a document by now")
    assert not info_file.is_current(content, document, SETTINGS, PROFILE)


def test_only_failures_that_come_again_are_taken_from_an_info_file(document):
    for kind, lasts in (("no_solid", True), ("zero_volume", True), ("memory", False),
                        ("missing", False)):
        failure = {"part": "Pad", "label": "Pad", "kind": kind, "message": "It is broken."}
        content = info_file.info_content(
            info_file.new_source(document), SETTINGS, PROFILE, [], [failure])
        assert info_file.is_current(content, document, SETTINGS, PROFILE) == lasts


def test_an_info_file_of_another_document_is_not_overwritten(tmp_path):
    path = tmp_path / "info" / "part.step.thinpart.json"
    contents = {}
    for folder in "ab":
        (tmp_path / folder).mkdir()
        document = tmp_path / folder / "part.step"
        document.write_bytes(b"geometry of " + folder.encode())
        contents[folder] = info_file.info_content(
            info_file.new_source(document, info_file=path), SETTINGS, PROFILE,
            [made_library.record_of("plate", notes=folder)])
    assert contents["a"]["source"]["folder"] == "../a"
    info_file.write_info(path, contents["a"])
    before = path.read_bytes()
    with pytest.raises(ThinPartError, match="belongs to .*a/part.step") as failure:
        info_file.write_info(path, contents["b"])
    assert failure.value.kind == "info_write" and path.read_bytes() == before
    (tmp_path / "link").symlink_to(tmp_path / "a")
    linked = info_file.new_source(tmp_path / "link" / "part.step", info_file=path)
    assert linked == contents["a"]["source"]
    (tmp_path / "a").rename(tmp_path / "c")  # moved: its notes go with it
    moved = info_file.info_content(
        info_file.new_source(tmp_path / "c" / "part.step", info_file=path), SETTINGS, PROFILE,
        [made_library.record_of("plate")])
    assert not info_file.is_current(info_file.read_info(path), tmp_path / "c" / "part.step",
                                    SETTINGS, PROFILE, path)
    info_file.write_info(path, moved)
    assert info_file.read_info(path)["parts"][0]["notes"] == "a"
    assert info_file.read_info(path)["source"]["folder"] == "../c"


@pytest.mark.parametrize("text, says", [
    ("", "cannot be read"), ("{", "cannot be read"), ("[]", "not a ThinPart info file"),
    ('{"format": "other"}', "not a ThinPart info file"),
    ('{"format": "thinpart-info", "version": 2}', "newer"),
    ('{"format": "thinpart-info", "version": 1}', "source is missing"),
    ("[" * 100_000, "cannot be read"),
])
def test_a_file_that_is_no_info_file_is_refused_and_not_overwritten(document, text, says):
    path = info_file.info_path(document)
    path.write_text(text)
    with pytest.raises(ThinPartError, match=says) as failure:
        info_file.read_info(path)
    assert failure.value.kind == "info_file"
    with pytest.raises(ThinPartError) as failure:
        info_file.write_info(path, content_of(document))
    assert failure.value.kind == "info_write" and path.read_text() == text


def test_not_a_number_is_never_written(document):
    content = content_of(document)
    content["parts"][0]["margin"] = float("nan")
    with pytest.raises(ThinPartError, match=r"not written: parts\[0\].margin is nan, not a finite number") as failure:
        info_file.write_info(info_file.info_path(document), content)
    assert failure.value.kind == "info_write"
    assert os.listdir(document.parent) == ["part.step"]


def test_failed_write_keeps_the_old_file_and_leaves_nothing(tmp_path, monkeypatch):
    path = tmp_path / "file"
    write_atomically(path, b"old")

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError):
        write_atomically(path, b"new")
    assert path.read_bytes() == b"old" and os.listdir(tmp_path) == ["file"]


def test_permissions_of_the_replaced_file_stay(tmp_path):
    path = tmp_path / "file"
    path.write_bytes(b"old")
    path.chmod(0o640)
    write_atomically(path, b"new")
    assert path.stat().st_mode & 0o777 == 0o640


def test_a_reader_never_sees_half_a_file_while_the_writer_is_killed(tmp_path):
    path = tmp_path / "file"
    script = (
        "import sys; from thinpart_workbench.storage.atomic_file import write_atomically\n"
        "n = 0\n"
        "while True:\n"
        "    n += 1\n"
        "    write_atomically(sys.argv[1], (b'%09d' % n) * 20000)\n"
    )
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    for _ in range(5):
        writer = subprocess.Popen([sys.executable, "-c", script, str(path)],
                                  env=dict(os.environ, PYTHONPATH=root))
        end = time.monotonic() + 0.6
        while time.monotonic() < end:
            if path.exists():
                content = path.read_bytes()
                assert len(content) == 180_000 and content == content[:9] * 20000
        writer.send_signal(signal.SIGKILL)
        writer.wait()
    assert len(path.read_bytes()) == 180_000


def test_source_says_what_is_wrong(tmp_path):
    with pytest.raises(ThinPartError) as failure:
        info_file.new_source(tmp_path / "no.step")
    assert failure.value.kind == "missing"


def test_names_with_bytes_that_are_no_text(tmp_path):
    name = os.fsdecode(b"p\xffart.step")
    document = tmp_path / name
    document.write_bytes(b"x")
    path = info_file.info_path(document)
    info_file.write_info(path, content_of(document))
    assert json.loads(path.read_bytes().decode("utf-8"))["source"]["file"] == name
    assert info_file.read_info(path)["source"]["file"] == name
