# SPDX-License-Identifier: LGPL-2.1-or-later
"""The index says what the info files say, whatever happens to them or to it."""

import json
import multiprocessing
import os
import signal
import sqlite3
import subprocess
import sys
from pathlib import Path

import made_library
import pytest
from copied_program import answer, copied_program

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.message import message
from thinpart_workbench.storage.index import library_index
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.info import info_tree
from thinpart_workbench.storage.info.info_file import SUFFIX
from thinpart_workbench.workflow.library.find_parts import PartQuery, find_parts

PARTS = len(made_library.SHAPES) + 2


@pytest.fixture
def library(tmp_path):
    return made_library.make_library(tmp_path / "library")


@pytest.fixture
def index(library, tmp_path):
    with LibraryIndex(library, tmp_path / "cache") as index:
        index.refresh()
        yield index


def labels(index):
    return sorted(part.label for part in find_parts(index))


def failures(index):
    return {os.path.basename(part.info_file): part.error_message
            for part in find_parts(index, PartQuery(failed=True)) if part.error_kind == "info_file"}


def test_every_part_and_failure_is_there_and_a_second_refresh_reads_nothing(index, library):
    assert len(labels(index)) == PARTS and "Deckel Süd" in labels(index)
    found = {part.label: part for part in find_parts(index)}
    plate = found["plate"]
    assert plate.file == str(library / "group 0" / "plate.step") and plate.category == "thin"
    assert (plate.d1_mm, plate.d2_mm, plate.d3_mm) == pytest.approx((100, 100, 2))
    assert plate.thinnest_mm == pytest.approx(2) and "1" in plate.criteria
    assert found["Deckel Süd"].instances == 4 and found["open_box"].volume_ratio is None
    broken, = find_parts(index, PartQuery(failed=True))
    assert (broken.error_kind, broken.error_message) == ("no_solid", "broken bounds no solid.")
    again = index.refresh()
    assert (again.files, again.changed, again.removed, again.unreachable) == (PARTS - 1, 0, 0, [])


def test_what_sentences_of_failures_are_made_of_is_known(index, library):
    (library / ("foreign" + SUFFIX)).write_text("{}")
    said = message("'{object}' is a mesh without triangles: import it again or delete it.", object="Mesh")
    failure = {"part": "Mesh", "label": "Mesh", "kind": "empty", "message": said}
    made_library.store(library, "half.step", [made_library.record_of("plate")], [failure])
    index.refresh()
    told = {part.error_message: part.error_message for part in find_parts(index, PartQuery(failed=True))}
    assert told[said].fields == {"object": "Mesh"}
    assert told["foreign.thinpart.json is not a ThinPart info file."].fields == {"info_file": "foreign" + SUFFIX}


def test_what_changed_moved_or_went_is_followed(index, library, monkeypatch):
    made_library.store(library, "new.step", [made_library.record_of("cube", label="new one")])
    changed = made_library.store(library / "group 0", "plate.step",
                                 [made_library.record_of("tube", label="tube 2")])
    (library / "group 0" / f"cube.step{SUFFIX}").unlink()
    (library / "moved").mkdir()
    moved = library / "group 1" / f"ribbed_block.step{SUFFIX}"
    moved.rename(library / "moved" / moved.name)
    read = []
    monkeypatch.setattr(library_index, "open_regular", _spy(library_index.open_regular, read))
    refreshed = index.refresh()
    assert refreshed.removed == 1  # the cube; what moved did not go
    assert sorted(os.path.relpath(path, library) for path, in read) == [
        os.path.relpath(changed, library), f"new.step{SUFFIX}"]
    assert {"new one", "tube 2"} <= set(labels(index)) and not {"plate", "cube"} & set(labels(index))
    there, = (part for part in find_parts(index) if part.label == "ribbed_block")
    assert there.info_file == str(library / "moved" / moved.name)
    assert [part.label for part in find_parts(index, PartQuery(words="moved"))] == ["ribbed_block"]


def _spy(function, calls):
    def spied(*arguments):
        calls.append(arguments)
        return function(*arguments)

    return spied


DAMAGED = {
    "truncated": lambda text: text[:len(text) // 2],
    "foreign": lambda text: '{"format": "something else"}',
    "newer": lambda text: text.replace('"version": 1', '"version": 2', 1),
    "list": lambda text: "[1, 2]",
    "binary": lambda text: "\x00\x01\x02",
    "no parts": lambda text: json.dumps({**json.loads(text), "parts": 7}),
    "label is a list": lambda text: _with(text, label=["a"]),
    "number too large": lambda text: _with(text, instances=10 ** 40),
    "no descriptors": lambda text: _with(text, descriptors={}),
    "bin out of range": lambda text: text.replace('"bins": [', '"bins": [99999999, ', 1),
    "source is a text": lambda text: json.dumps({**json.loads(text), "source": "x"}),
    "surrogates": lambda text: json.dumps({**json.loads(text), "source": {"file": "\ud800"}}),
    "deep": lambda text: "[" * 100_000,
}


def _with(text, **changes):
    content = json.loads(text)
    content["parts"][0].update(changes)
    return json.dumps(content)


@pytest.mark.parametrize("damage", DAMAGED)
def test_an_info_file_that_cannot_be_used_is_one_row_and_the_rest_goes_on(index, library, damage):
    info = library / "group 0" / f"plate.step{SUFFIX}"
    info.write_text(DAMAGED[damage](info.read_text(encoding="utf-8")), encoding="utf-8")
    before = info.read_bytes()
    index.refresh()
    assert len(labels(index)) == PARTS - 1
    message, = failures(index).values()
    assert info.name in message and message.endswith(".")
    assert info.read_bytes() == before
    assert index.refresh().changed == 0  # not read again as long as it stays as it is


def test_a_huge_file_is_no_info_file(index, library):
    with open(library / f"huge.step{SUFFIX}", "wb") as file:
        file.truncate(300 * 1024 * 1024)
    index.refresh()
    assert "too large" in failures(index)[f"huge.step{SUFFIX}"]


def test_odd_names_and_loops_of_links(tmp_path):
    library = tmp_path / "library"
    names = ["with space.step", "quo'te\".step", "new\nline.step", os.fsdecode(b"caf\xe9.step"),
             "x" * 230 + ".step"]
    for name in names:
        made_library.store(library / "a", name, [made_library.record_of("cube", label=name[:9])])
    (library / "a" / "loop").symlink_to(library)
    (library / "nowhere").symlink_to(tmp_path / "gone")
    (library / f"gone.step{SUFFIX}").symlink_to(tmp_path / "gone")
    with LibraryIndex(library, tmp_path / "cache") as index:
        refreshed = index.refresh()
        assert (refreshed.files, refreshed.unreachable) == (len(names), [])
        assert sorted(os.path.basename(part.file) for part in find_parts(index)) == sorted(names)


@pytest.mark.parametrize("damage", ["garbage", "truncated", "empty"])
def test_a_damaged_index_is_made_anew(library, tmp_path, damage):
    with LibraryIndex(library, tmp_path / "cache") as index:
        index.refresh()
    content = Path(index.path).read_bytes()
    damaged = {"garbage": b"no database" * 1000, "truncated": content[:4096 + 17], "empty": b""}[damage]
    with open(index.path, "wb") as file:
        file.write(damaged)
    with LibraryIndex(library, tmp_path / "cache") as index:
        index.refresh()
        assert len(labels(index)) == PARTS and index.warning is None


def test_pages_damaged_in_the_middle_are_noticed_and_made_anew(library, tmp_path):
    with LibraryIndex(library, tmp_path / "cache") as index:
        index.refresh()
    with open(index.path, "r+b") as file:
        for page in range(1, os.path.getsize(index.path) // 4096):
            file.seek(page * 4096)
            file.write(b"\xff" * 64)
    with LibraryIndex(library, tmp_path / "cache") as index:
        index.refresh()
        assert len(labels(index)) == PARTS


def test_without_a_place_for_it_the_index_lives_in_memory(library, tmp_path):
    (tmp_path / "file").write_text("in the way")
    with LibraryIndex(library, tmp_path / "file" / "cache") as index:
        refreshed = index.refresh()
        assert "cannot be saved" in refreshed.warning and len(labels(index)) == PARTS
        assert index.refresh().changed == 0


def test_without_a_home_the_index_lives_in_memory(library, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", "~nobody of this name/cache")
    monkeypatch.chdir(tmp_path)
    with LibraryIndex(library) as index:
        assert "no home" in index.refresh().warning and len(labels(index)) == PARTS
    assert os.listdir(tmp_path) == ["library"]


def test_a_full_disk_keeps_the_index_in_memory(library, tmp_path, monkeypatch):
    with LibraryIndex(library, tmp_path / "cache") as index:
        assert labels(index) == []  # the file is there, and holds nothing yet

    # SQLite answers with the same error where it may have no more pages than it has.
    def connect(path, *arguments, original=sqlite3.connect, **options):
        database = original(path, *arguments, **options)
        if path != ":memory:":
            database.execute("PRAGMA max_page_count = 1")
        return database

    monkeypatch.setattr(sqlite3, "connect", connect)
    with LibraryIndex(library, tmp_path / "cache") as index:
        refreshed = index.refresh()
        assert "full" in refreshed.warning and len(labels(index)) == PARTS


def test_a_folder_that_cannot_be_listed_keeps_what_was_known_of_it(index, library, monkeypatch):
    real = os.scandir

    def scandir(path):
        if os.fsencode(path).endswith(b"group 1"):
            raise OSError(116, "Stale file handle")  # an unreachable share cannot be provoked here
        return real(path)

    monkeypatch.setattr(info_tree.os, "scandir", scandir)
    refreshed = index.refresh()
    sentence, = refreshed.unreachable
    assert "group 1" in sentence and "Stale file handle" in sentence and refreshed.removed == 0
    assert len(labels(index)) == PARTS


def test_a_library_that_is_gone(index, library, tmp_path):
    library.rename(tmp_path / "elsewhere")
    refreshed = index.refresh()
    assert len(refreshed.unreachable) == 1 and len(labels(index)) == PARTS
    with LibraryIndex(tmp_path / "never seen", tmp_path / "cache") as other:
        with pytest.raises(ThinPartError, match="cannot be reached"):
            other.refresh()


REFRESH = """
import sys
from thinpart_workbench.storage.index import library_index
library_index.FILES_AT_ONCE = 5
index = library_index.LibraryIndex(sys.argv[1], sys.argv[2])
print(index.refresh(lambda done, total: print(done, flush=True)).files)
"""


def test_two_refreshes_at_once_and_one_that_is_killed(tmp_path):
    library = tmp_path / "library"
    for number in range(60):
        made_library.store(library, f"{number}.step", [made_library.record_of("cube", label=str(number))])
    command = [sys.executable, "-c", REFRESH, str(library), str(tmp_path / "cache")]
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join(sys.path))
    killed = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE)
    assert b"5" in iter(lambda: killed.stdout.readline().strip(), b"")
    killed.send_signal(signal.SIGKILL)
    killed.communicate()
    both = [subprocess.Popen(command, env=environment, stdout=subprocess.PIPE) for _ in range(2)]
    assert [each.communicate(timeout=60)[0].split()[-1] for each in both] == [b"60", b"60"]
    with LibraryIndex(library, tmp_path / "cache") as index:
        assert index.refresh().changed == 0
        assert sorted(map(int, labels(index))) == list(range(60))


def _open_at_once(library, cache, barrier, answers):
    barrier.wait()
    with LibraryIndex(library, cache) as index:
        index.query("SELECT 1 FROM files")
        answers.put(index.warning)


def test_many_that_open_a_new_index_at_once_all_get_it(library, tmp_path):
    context = multiprocessing.get_context("fork")
    for attempt in range(15):
        barrier, answers = context.Barrier(6), context.Queue()
        arguments = library, tmp_path / str(attempt), barrier, answers
        others = [context.Process(target=_open_at_once, args=arguments) for _ in range(6)]
        for each in others:
            each.start()
        assert [answers.get(timeout=60) for _ in others] == [None] * len(others)
        for each in others:
            each.join()


def test_others_read_while_one_writes(index, library, tmp_path):
    with LibraryIndex(library, tmp_path / "cache") as reader:
        writer = sqlite3.connect(index.path)
        writer.execute("BEGIN IMMEDIATE")
        writer.execute("DELETE FROM parts")
        assert len(labels(reader)) == PARTS  # SQLite would refuse it after a while
        writer.rollback()
        writer.close()


CHANGES = {
    "another column": ("storage/record_columns.py", 'Column("median_mm"', 'Column("middle_mm"'),
    "another type": ("core/record/record_types.py", "    triangles: int", "    triangles: float"),
    "another value": ("storage/record_columns.py", 'measured["thickness_mm"]["median"]', 'measured["thickness_mm"]["max"]'),
    "another quantity": ("core/descriptors/descriptor_table.py", "lambda d: d.area,", "lambda d: d.area / 2.0,"),
    "another signature": ("core/reuse/similarity.py", "THICKNESS_UNIT = 0.05", "THICKNESS_UNIT = 0.06"),
    "other bins": ("core/descriptors/bins.py", "BINS = 1000", "BINS = 500"),
    "another definition": (
        "core/record/record_types.py", "instances: Annotated[int, Whole(1)", "instances: Annotated[int, Whole(2)"),
    "another SQL index": ("storage/index/library_index.py", "parts_by_file", "files_of_parts"),
    "another table": ("storage/index/library_index.py", '"inode": "INTEGER"', '"inode": "TEXT"'),
}
PATH = """
from thinpart_workbench.storage.index.library_index import LibraryIndex
print(LibraryIndex("library", "cache").path)
"""


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    return copied_program(tmp_path_factory.mktemp("program"))


@pytest.mark.parametrize("change", CHANGES)
def test_a_program_that_would_make_another_index_has_a_file_of_its_own(program, change):
    name, old, new = CHANGES[change]
    file = program / name
    content, before = file.read_text(encoding="utf-8"), answer(program, PATH)
    assert old in content
    try:
        file.write_text(content.replace(old, new), encoding="utf-8")
        assert answer(program, PATH) != before
    finally:
        file.write_text(content, encoding="utf-8")
    assert answer(program, PATH) == before


def test_the_same_index_whatever_else_changes_and_however_lines_end(program):
    before = answer(program, PATH)
    for name in ("core/walls/thickness_field.py", "storage/part_table.py"):
        with open(program / name, "a", encoding="utf-8") as file:
            file.write("# changed\n")
    columns = program / "storage" / "index" / "index_columns.py"
    columns.write_bytes(columns.read_bytes().replace(b"\n", b"\r\n"))
    assert answer(program, PATH) == before
