# SPDX-License-Identifier: LGPL-2.1-or-later
"""A worker that a foreign file has taken over: what it can reach, and what its answers can do."""

import ctypes
import json
import os
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
import time_limit
from hostile_documents import changed, harmless, with_resource
from program import SAMPLES, records, thinpart
from run_workers import run_workers

from thinpart_workbench.system.bubblewrap import has_bubblewrap
from thinpart_workbench.system.confinement import VARIABLE, chosen_confinement
from thinpart_workbench.system.landlock import landlock_version
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.workers.pool_messages import DONE
from thinpart_workbench.workflow.workers.worker_thread import WorkerDied

HERE = [name for name, is_here in (("landlock", landlock_version() > 0), ("bubblewrap", has_bubblewrap())) if is_here]
CONFINEMENTS = [pytest.param(name, marks=[] if name in HERE else pytest.mark.skip(f"no {name} on this system"))
                for name in ("landlock", "bubblewrap")]

_WRITES = {
    "make a file": lambda folder: open(folder / "new", "w").close(),
    "write into a file": lambda folder: open(folder / "old", "r+b").close(),
    "replace a file": lambda folder: open(folder / "old", "wb").close(),
    "shorten a file": lambda folder: os.truncate(folder / "old", 1),
    "remove a file": lambda folder: os.unlink(folder / "old"),
    "make a folder": lambda folder: os.mkdir(folder / "new folder"),
    "remove a folder": lambda folder: os.rmdir(folder / "empty"),
    "move a file in": lambda folder: os.rename(_own("x"), folder / "new"),
    "move a file out": lambda folder: os.rename(folder / "old", _own("y", make=False)),
    "link a file in": lambda folder: os.link(_own("x"), folder / "new"),
    "link a name": lambda folder: os.symlink("old", folder / "new link"),
    "make a pipe": lambda folder: os.mkfifo(folder / "pipe"),
    "through a link of its own": lambda folder: _through_a_link(folder / "old"),
    "change permissions": lambda folder: os.chmod(folder / "old", 0o600),
    "change times": lambda folder: os.utime(folder / "old"),
    "change attributes": lambda folder: os.setxattr(folder / "old", "user.thinpart", b"x"),
    "change permissions of an open file": lambda folder: os.fchmod(os.open(folder / "old", os.O_RDONLY), 0o600),
    "from another program": lambda folder: subprocess.run(
        ["sh", "-c", 'echo x > "$1"', "sh", folder / "new"], check=True, stderr=subprocess.DEVNULL),
}

_NETWORK = {
    "TCP": lambda address: socket.create_connection(address, 5),
    "UDP": lambda address: socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b"x", address),
    "Unix": lambda address: socket.socket(socket.AF_UNIX).connect("/run/dbus/system_bus_socket"),
    "listening": lambda address: socket.create_server(("127.0.0.1", 0)),
}

_OTHERS = {
    "signal": lambda number: os.kill(number, 0),
    "memory": lambda number: open(f"/proc/{number}/mem", "r+b").close(),
    "follow": lambda number: _follow(number),
}

_ATTACH, _DETACH = 16, 17


def _own(name, make=True):
    path = os.path.join(tempfile.gettempdir(), name)
    if make:
        open(path, "w").close()
    return path


def _through_a_link(victim):
    link = _own("link", make=False)
    os.symlink(victim, link)
    open(link, "wb").close()


def _follow(number):
    ptrace = ctypes.CDLL(None, use_errno=True).ptrace
    if ptrace(_ATTACH, number, None, None) < 0:
        raise OSError(ctypes.get_errno(), "refused")
    os.waitpid(number, 0)
    ptrace(_DETACH, number, None, None)


def attempt(task):
    """In the worker: what of `_WRITES` and the like is done, by name."""
    folder, address, number = json.loads(task.file)
    done = []
    for kind, given in ((_WRITES, Path(folder)), (_NETWORK, tuple(address)), (_OTHERS, number)):
        for name, act in kind.items():
            try:
                act(given)
            except (OSError, subprocess.CalledProcessError):
                continue
            done.append(name)
    Path(tempfile.gettempdir(), "own").write_text("kept meanwhile")
    return {"done": done, "read": Path(folder, "old").read_text(), "own": os.listdir(tempfile.gettempdir())}


def answer_something_else(task):
    """In the worker: say to the pool what no worker says, on the pipe that it keeps for its answers."""
    content = {
        "pickle": b"cos\nsystem\n(S'touch " + task.file.split()[1].encode() + b"'\ntR.",
        "no-text": b"\xff\xfe", "deep": b"[" * 200_000, "not-finite": b"NaN",
    }.get(task.file.split()[0])
    message = (struct.pack("<cQ", DONE, 1 << 62) if content is None else
               struct.pack("<cQ", DONE, len(content)) + content)
    for handle in range(3, 64):
        try:
            if os.readlink(f"/proc/self/fd/{handle}").startswith("pipe:") and _is_for_writing(handle):
                os.write(handle, message)
        except OSError:
            continue
    os._exit(0)


def _is_for_writing(handle):
    import fcntl

    return fcntl.fcntl(handle, fcntl.F_GETFL) & os.O_ACCMODE == os.O_WRONLY


def write_without_end(task):
    """In the worker: fill the disk, and open the same file again and again."""
    size, number = 0, 0
    try:
        with open(_own("large", make=False), "wb") as file:
            file.truncate(1 << 50)
            size = 1 << 50
    except OSError as error:
        size = error.strerror
    try:
        kept = []
        while number < 1 << 16:
            kept.append(os.open("/dev/null", os.O_RDONLY))
            number += 1
    except OSError:
        pass
    return {"size": size, "files": number}


def open_with_freecad(task):
    """In the worker: what FreeCAD does without our check."""
    from thinpart_workbench.freecad_adapter.bootstrap import load_freecad

    freecad = load_freecad()
    freecad.closeDocument(freecad.openDocument(task.file).Name)
    return "opened"


@pytest.fixture
def worked(tmp_path):
    """Have one worker do one thing: its future."""
    def work(do, file, confine=True):
        folder = tmp_path / "run"
        folder.mkdir(exist_ok=True)
        with run_workers(do, folder, 50.0, confine) as workers:
            workers.submit(FileTask(file))
            while (one := workers.next_finished()) is None:
                pass
            return one[0]

    return work


@pytest.fixture
def others(tmp_path):
    """A folder of the user's, a service that listens, and a process: what a worker is not to reach."""
    folder = tmp_path / "user"
    (folder / "empty").mkdir(parents=True)
    (folder / "old").write_text("the user's own")
    server = socket.create_server(("127.0.0.1", 0))
    process = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
    yield folder, process, json.dumps([str(folder), server.getsockname(), process.pid])
    process.kill()
    process.wait()
    server.close()


@pytest.mark.parametrize("confinement", CONFINEMENTS)
def test_a_worker_writes_into_its_own_folder_alone(worked, others, monkeypatch, confinement):
    monkeypatch.setenv(VARIABLE, confinement)
    folder, process, told = others
    result = worked(attempt, told).result()
    assert result["done"] == [] and result["read"] == "the user's own" and "own" in result["own"]
    assert sorted(os.listdir(folder)) == ["empty", "old"] and (folder / "old").read_text() == "the user's own"


def test_what_is_tried_there_can_be_done_without_confinement(worked, others, monkeypatch):
    """Else the test above would pass wherever an attempt is wrong in itself."""
    monkeypatch.setenv(VARIABLE, "none")
    *_, told = others
    done = set(worked(attempt, told).result()["done"])
    # No system bus need run here; a file that was moved away cannot be written; a process may not be followed anywhere.
    may_fail = {"Unix", "memory", "follow", "change attributes"}
    moved = {"shorten a file", "remove a file", "through a link of its own", "change permissions", "change times",
             "change permissions of an open file", "move a file out", "link a file in"}
    assert {*_WRITES, *_NETWORK, *_OTHERS} - done <= may_fail | moved


@pytest.mark.parametrize("confinement", CONFINEMENTS)
def test_the_disk_and_open_files_are_limited(worked, monkeypatch, confinement):
    monkeypatch.setenv(VARIABLE, confinement)
    told = worked(write_without_end, "x").result()
    assert told["size"] == "File too large" and 300 < told["files"] < 1024


@pytest.mark.parametrize("confine", [False, True], ids=["free", "confined"])
@pytest.mark.parametrize("what", ["pickle", "no-text", "deep", "length"])
def test_no_answer_of_a_worker_is_run_or_waited_for(worked, tmp_path, what, confine):
    future = worked(answer_something_else, f"{what} {tmp_path / 'ran'}", confine)
    assert isinstance(future.exception(), WorkerDied) and not (tmp_path / "ran").exists()


@pytest.mark.parametrize("confinement", CONFINEMENTS)
def test_a_document_that_writes_anywhere_writes_nowhere(worked, freecad, tmp_path, monkeypatch, confinement):
    """The same document as in test_document_safety, without the check that refuses it."""
    victim = tmp_path / "victim.step"
    victim.write_text("the user's own")
    stored = "V/" + "../" * 16 + os.fspath(victim).lstrip("/")
    hostile = changed(harmless(freecad, tmp_path / "harmless.FCStd"), tmp_path / "hostile.FCStd",
                      with_resource(stored), [(stored, b"overwritten")])
    monkeypatch.setenv(VARIABLE, confinement)
    worked(open_with_freecad, str(hostile)).exception()  # may be opened, or not
    assert victim.read_text() == "the user's own"
    monkeypatch.setenv(VARIABLE, "none")
    worked(open_with_freecad, str(hostile)).exception()
    if freecad.Version()[:2] == ["0", "20"]:
        assert victim.read_text() == "overwritten"


@pytest.mark.parametrize("confinement", [*CONFINEMENTS, "none"])
def test_json_says_how_the_reader_was_confined(tmp_path, monkeypatch, confinement):
    monkeypatch.setenv(VARIABLE, confinement)
    files = [SAMPLES / "plate.step", SAMPLES / "tube.FCStd", tmp_path / "damaged.step"]
    files[2].write_bytes((SAMPLES / "plate.step").read_bytes()[:900])
    run = thinpart("classify", *files, "--info-dir", tmp_path / "info", "--json")
    network = {"landlock": "seccomp"}.get(confinement, confinement)
    said = records(run)
    assert len(said) == 3
    assert [each["confinement"] for each in said] == [{"files": confinement, "network": network}] * 3
    assert sorted(each.get("category", "") for each in said) == ["", "thin", "thin"]
    assert len(list((tmp_path / "info").rglob("*.thinpart.json"))) == 2


def test_without_either_the_check_alone_remains(tmp_path, monkeypatch):
    monkeypatch.setenv(VARIABLE, "none")
    assert chosen_confinement() == "none"
    monkeypatch.delenv(VARIABLE)
    monkeypatch.setattr("thinpart_workbench.system.confinement.landlock_version", lambda: 0)
    monkeypatch.setattr("thinpart_workbench.system.confinement.has_bubblewrap", lambda: False)
    assert chosen_confinement() == "none"


@pytest.mark.skipif(not has_bubblewrap(), reason="no bubblewrap on this system")
def test_what_runs_in_bubblewrap_ends_with_the_run(tmp_path):
    shutil.copy(SAMPLES / "plate.step", tmp_path)
    for number in range(40):
        shutil.copy(SAMPLES / "plate.step", tmp_path / f"{number}.step")
    run = subprocess.Popen([sys.executable, "-m", "thinpart_workbench", "classify", str(tmp_path), "--jobs", "2"],
                           cwd=Path(__file__).resolve().parents[2], stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, env={**os.environ, VARIABLE: "bubblewrap", "TMPDIR": str(tmp_path)})

    def workers():
        found = []
        for process in Path("/proc").glob("[0-9]*/environ"):
            try:
                if f"{tmp_path}/thinpart-run-".encode() in process.read_bytes():
                    found.append(process)
            except OSError:
                continue
        return found

    time_limit.wait_until(lambda: list(tmp_path.glob("*.thinpart.json")), "a first part")
    assert workers()
    run.kill()
    run.wait()
    time_limit.wait_until(lambda: not workers(), "the end of all workers", 20)
