# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ctrl-C and requests to end: every command ends soon, whatever it waits for, and says what it is at meanwhile."""

import fcntl
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from program import SAMPLES, all_ended, descendants, environment, group_ended, thinpart
from slow_files import held, make_endless
from time_limit import wait_until

from thinpart_workbench.cli import stop_signals
from thinpart_workbench.core.errors import Cancelled, ThinPartError
from thinpart_workbench.core.run_control import RunControl
from thinpart_workbench.storage import folder_lock
from thinpart_workbench.storage.info.info_file import change_info, read_info

SECONDS_TO_END = 8.0
"""Far more than it takes, and far less than what each of these commands waits for."""

needs_gmsh = pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed")


class Run:
    """A command in a group of processes of its own."""

    def __init__(self, *arguments, **variables):
        self.process = subprocess.Popen(
            [sys.executable, "-m", "thinpart_workbench", *map(str, arguments)], env=environment(COLUMNS="200", **variables),
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
            start_new_session=True)
        self.lines, self.errors = [], []
        self._readers = [threading.Thread(target=lines.extend, args=(stream,)) for lines, stream in (
            (self.lines, self.process.stdout), (self.errors, self.process.stderr))]
        for reader in self._readers:
            reader.start()

    def progress(self):
        """What was told of the progress so far."""
        return [json.loads(line)["progress"] for line in list(self.errors) if line.startswith('{"progress"')]

    def opened(self):
        """Paths that the process has open."""
        return _opened(self.process.pid)

    def opened_by_workers(self):
        """Paths that the processes that it has started have open."""
        return set().union(*map(_opened, descendants(self.process.pid)))

    def stop(self, number, to_all=True):
        """Send a signal and wait for the end: the exit status."""
        started = descendants(self.process.pid)
        (os.killpg if to_all else os.kill)(self.process.pid, number)
        wait_until(lambda: self.process.poll() is not None, f"the end after {number!r}", SECONDS_TO_END)
        for reader in self._readers:
            reader.join()
        assert group_ended(self.process.pid) and all_ended(started)
        assert "Traceback" not in "".join(self.errors)
        return self.process.returncode

    def end(self):
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        for reader in self._readers:
            reader.join()
        self.process.stdout.close()
        self.process.stderr.close()


def _opened(process):
    found = set()
    with suppress(OSError):  # it has ended, or has closed it meanwhile
        for link in Path(f"/proc/{process}/fd").iterdir():
            with suppress(OSError):
                found.add(os.readlink(link))
    return found


@pytest.fixture
def begin():
    """Starts a command; what is still running after the test ends."""
    runs = []

    def start(*arguments, **variables):
        runs.append(Run(*arguments, **variables))
        return runs[-1]

    yield start
    for run in runs:
        run.end()


@contextmanager
def locked(folder):
    """Somebody who may only read a folder keeps it locked."""
    handle = os.open(folder, os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)
    try:
        yield
    finally:
        os.close(handle)


@pytest.fixture(scope="module")
def meshed_slowly(tmp_path_factory):
    """A part that is meshed at once with elements of 1 mm, and a document of two, the second of which takes minutes."""
    import FreeCAD
    import Part

    folder = tmp_path_factory.mktemp("meshed") / "parts"
    folder.mkdir()
    Part.makeBox(6, 6, 4).exportBrep(str(folder / "quick.brep"))
    Part.makeCompound([Part.makeBox(5, 5, 4), Part.makeBox(200, 200, 200, FreeCAD.Vector(50, 0, 0))]).exportStep(
        str(folder / "slow.step"))
    return folder


@needs_gmsh
@pytest.mark.timeout(120)
@pytest.mark.parametrize("number, to_all", [(signal.SIGINT, True), (signal.SIGTERM, False)], ids=["a terminal", "kill"])
def test_size_tells_of_every_part_and_stops_while_a_mesh_takes_minutes(meshed_slowly, tmp_path, begin, number, to_all):
    command = ("size", "--check", "--json", "--size", "1", "--jobs", "2")
    variables = {"THINPART_CACHE": str(tmp_path / "cache"), "TMPDIR": str(tmp_path)}
    run = begin(*command, meshed_slowly, **variables)
    wait_until(lambda: any(each.get("number") == 2 and each["step"] == "mesh_at_one_size" for each in run.progress())
               and any(each["done"] for each in run.progress()), lambda: f"the second part: {run.errors}")
    assert run.stop(number, to_all) == 130, run.errors
    steps = [(os.path.basename(each["file"]), each["number"], each["parts"], each["step"]) for each in run.progress()
             if "step" in each]
    # What takes but a moment may go unnoticed.
    assert steps[-1] == ("slow.step", 2, 2, "mesh_at_one_size"), steps
    assert steps.index(("slow.step", 2, 2, "mesh_at_one_size")) > 0 and len(set(steps)) == len(steps), steps
    assert [os.path.basename(json.loads(line)["file"]) for line in run.lines] == ["quick.brep"]
    assert not list(tmp_path.glob("thinpart-*")), "temporary files"
    again = thinpart(*command, meshed_slowly / "quick.brep", variables=variables)
    assert again.returncode == 0 and '"step"' not in again.stderr, "what was done is kept"


@pytest.mark.parametrize("command", [("map", "--png", "map.png"), ("size",), ("classify",)], ids=lambda each: each[0])
def test_a_signal_to_all_processes_is_no_damaged_file(tmp_path, begin, command):
    make_endless(tmp_path / "endless.step")
    name, *more = command
    run = begin(name, tmp_path / "endless.step", *more)
    wait_until(lambda: str(tmp_path / "endless.step") in run.opened_by_workers(), "a worker that reads")
    assert run.stop(signal.SIGTERM) == 130, run.errors
    assert "damaged" not in "".join(run.errors)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_size_stops_while_it_asks_gmsh_for_its_version(tmp_path, begin, number):
    program = tmp_path / "gmsh"
    program.write_text(f"#!/bin/sh\ntouch {tmp_path}/asked\nexec sleep 600\n")
    program.chmod(0o755)
    run = begin("size", SAMPLES / "plate.step", "--check", PATH=f"{tmp_path}:{os.environ['PATH']}")
    wait_until((tmp_path / "asked").exists, "Gmsh")
    assert run.stop(number) == 130
    assert "install it" not in "".join(run.errors)


@pytest.mark.parametrize("command, number", [("classify", signal.SIGINT), ("size", signal.SIGTERM), ("map", signal.SIGINT),
                                             ("report", signal.SIGTERM), ("reclassify", signal.SIGINT)])
def test_every_command_stops_while_a_server_does_not_answer(library, tmp_path, begin, command, number):
    profile = tmp_path / "profile.json"
    more = {"map": ["--png", tmp_path / "map.png"], "report": ["--output", tmp_path / "report"]}.get(command, [])
    source = library / "plate.step" if command == "map" else library
    with held(profile):
        run = begin(command, source, "--profile", profile, *more)
        wait_until(lambda: waits_in_system(run.process.pid), "that it opens its profile")
        assert run.stop(number) == 130, run.errors


def waits_in_system(process):
    """Whether a process waits for a lease to end, as on a server."""
    try:
        with open(f"/proc/{process}/wchan", encoding="ascii") as file:
            return "lease" in file.read()
    except OSError:
        return False


@pytest.mark.parametrize("command, number", [
    (("note", "--set", "x"), signal.SIGINT), (("note", "--set", "x"), signal.SIGTERM),
    (("classify", "--force"), signal.SIGINT)])
def test_a_command_stops_while_a_folder_is_locked(library, begin, command, number):
    name, *more = command
    with locked(library):
        run = begin(name, library / "plate.step", *more)
        wait_until(lambda: str(library) in run.opened(), "that it opens the folder")
        assert run.stop(number, to_all=False) == 130
    assert "locked" not in "".join(run.errors)
    assert thinpart(name, library / "plate.step", *more).returncode == 0


def test_a_folder_that_stays_locked_is_named_and_waited_for_only_once(library, monkeypatch):
    monkeypatch.setattr(folder_lock, "PATIENCE", 0.2)
    info_file = library / "plate.step.thinpart.json"
    with locked(library):
        for _ in range(2):
            with pytest.raises(ThinPartError) as raised:
                change_info(info_file, lambda content: True)
            monkeypatch.setattr(folder_lock, "PATIENCE", 1e6)
        assert raised.value.kind == "info_write"
        assert str(raised.value) == (
            f"The info file plate.step.thinpart.json could not be written: another program keeps the folder {library} "
            "locked; end that program, or choose another place for info files.")
    assert change_info(info_file, lambda content: True) == read_info(info_file)
    opened = os.open(library, os.O_RDONLY)
    fcntl.flock(opened, fcntl.LOCK_EX)
    threading.Timer(0.5, os.close, [opened]).start()
    assert change_info(info_file, lambda content: True) == read_info(info_file), "it is waited for again"


@pytest.fixture
def short(monkeypatch):
    monkeypatch.setattr(stop_signals, "PATIENCE", 0.1)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_run_that_comes_to_no_safe_point_is_interrupted(short, number):
    control, waited = RunControl(), threading.Event()
    with pytest.raises(Cancelled), stop_signals.stop_signals(control):
        os.kill(os.getpid(), number)
        assert control.stopped
        waited.wait(60)
        pytest.fail("it went on")


def test_a_run_that_is_ending_is_left_alone_and_so_is_what_must_not_be_disturbed(short):
    control = RunControl()
    with pytest.raises(Cancelled), stop_signals.stop_signals(control):
        os.kill(os.getpid(), signal.SIGINT)
        try:
            control.check()
        finally:
            ended = threading.Event()
            threading.Timer(0.4, ended.set).start()
            assert ended.wait(60), "a worker to end"
    control = RunControl()
    with stop_signals.stop_signals(control) as undisturbed:
        with undisturbed():
            os.kill(os.getpid(), signal.SIGINT)
            written = threading.Event()
            threading.Timer(0.4, written.set).start()
            assert written.wait(60), "a table to be written"
        with pytest.raises(Cancelled):
            control.check()
