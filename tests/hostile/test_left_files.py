# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is left behind by processes that are killed: nothing, or nothing for long."""

import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pytest
import time_limit
from program import ROOT, SAMPLES, environment
from run_workers import run_workers
from slow_files import make_endless
from worker_outcomes import results

MADE_AND_KILLED = """
import os, sys
from thinpart_workbench.storage import atomic_file
def fsync(handle):
    print("written", flush=True)
    sys.stdin.read()
os.fsync = fsync
atomic_file.write_atomically(sys.argv[1], b"half of it")
"""


@pytest.fixture
def killed_writer(tmp_path):
    """A file whose writer is waiting for the disk: the process, and the temporary file."""
    writer = subprocess.Popen([sys.executable, "-c", MADE_AND_KILLED, str(tmp_path / "part.thinpart.json")], cwd=ROOT,
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    assert writer.stdout.readline() == b"written\n"
    temporary, = tmp_path.glob(".thinpart-*.tmp")
    yield writer, temporary
    writer.kill()
    writer.communicate()


def _written_by_the_next(path):
    """Another process writes, which looks at the folder for the first time."""
    subprocess.run([sys.executable, "-c", "import sys; from thinpart_workbench.storage.atomic_file import write_atomically\n"
                                          "write_atomically(sys.argv[1], b'whole')", str(path)], cwd=ROOT, check=True)
    assert path.read_bytes() == b"whole"


def _aged(path, seconds=3600):
    then = time.time() - seconds
    os.utime(path, (then, then))


def test_what_a_killed_writer_left_is_removed_by_the_next(killed_writer, tmp_path):
    writer, temporary = killed_writer
    writer.kill()
    writer.wait()
    _aged(temporary)
    _written_by_the_next(tmp_path / "other")
    assert os.listdir(tmp_path) == ["other"]


def test_what_is_still_being_written_is_not_removed(killed_writer, tmp_path):
    writer, temporary = killed_writer
    _aged(temporary)
    _written_by_the_next(tmp_path / "other")
    assert temporary.exists()
    writer.communicate()
    assert (tmp_path / "part.thinpart.json").read_bytes() == b"half of it" and not temporary.exists()


def test_what_is_new_or_something_else_is_not_removed(tmp_path):
    (tmp_path / ".thinpart-new.tmp").touch()
    (tmp_path / ".thinpart-folder.tmp").mkdir()
    (tmp_path / "victim").touch()
    (tmp_path / ".thinpart-link.tmp").symlink_to("victim")
    (tmp_path / "thinpart-other.tmp").touch()
    for path in tmp_path.iterdir():
        if path.name != ".thinpart-new.tmp":
            _aged(path)
    before = sorted(os.listdir(tmp_path))
    _written_by_the_next(tmp_path / "victim")
    assert sorted(os.listdir(tmp_path)) == before


def open_and_end(task):
    """In the worker: open a document and end, or go on for ever."""
    from thinpart_workbench.freecad_adapter.bootstrap import load_freecad

    what, file = task.file.split(maxsplit=1)
    document = load_freecad().openDocument(file)
    assert document.TransientDir.startswith(tempfile.gettempdir() + os.sep)
    Path(document.TransientDir, "unpacked").write_bytes(b"x" * 1_000_000)
    if what == "die":
        os.kill(os.getpid(), signal.SIGSEGV)
    if what == "hang":
        time.sleep(600)
    return document.TransientDir


def test_an_unpacked_document_goes_with_the_worker_that_died_of_it(tmp_path, monkeypatch):
    for name in ("home", "run"):
        (tmp_path / name).mkdir()
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    file = SAMPLES / "tube.FCStd"
    with run_workers(open_and_end, tmp_path / "run", 8.0) as workers:
        (_, first), (_, died), (_, late), _ = results(
            workers, [f"{what} {file}" for what in ("end", "die", "hang", "end")])
        assert (died, late) == ("WorkerDied", "TimeoutError") and first.startswith(str(tmp_path / "run"))
        time_limit.wait_until(lambda: not list((tmp_path / "run").rglob("unpacked")),
                              "the end of what was unpacked: none of it is left for the next task")
    assert list((tmp_path / "run").iterdir()) == []
    assert [path for path in (tmp_path / "home").rglob("*") if path.is_file()] == []


def test_a_run_with_crashes_timeouts_and_a_kill_leaves_nothing_once_there_was_another(tmp_path):
    for name in ("home", "temporary", "parts"):
        (tmp_path / name).mkdir()
    place = environment(HOME=str(tmp_path / "home"), TMPDIR=str(tmp_path / "temporary"))
    sample = (SAMPLES / "wedge.step").read_bytes()
    for number in range(4):
        (tmp_path / "parts" / f"{number}.step").write_bytes(sample)
        (tmp_path / "parts" / f"cut{number}.step").write_bytes(sample[:2000 + 500 * number])
    make_endless(tmp_path / "parts" / "endless.step")
    command = [sys.executable, "-m", "thinpart_workbench", "classify", str(tmp_path / "parts"), "--timeout", "10"]
    run = subprocess.Popen(command, env=place, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time_limit.wait_until(lambda: list((tmp_path / "parts").glob("*.thinpart.json")), "a first part")
    run.kill()
    run.wait()
    assert os.listdir(tmp_path / "temporary")
    subprocess.run(command, env=place, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    assert os.listdir(tmp_path / "temporary") == []
    freecads = [path for path in (tmp_path / "home").rglob("*")
                if path.is_file() and "thinpart" not in str(path)[len(str(tmp_path)):]]
    assert freecads == [] and len(list((tmp_path / "parts").glob("*.thinpart.json"))) == 4
