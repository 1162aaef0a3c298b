# SPDX-License-Identifier: LGPL-2.1-or-later
"""``classify --dask`` on a real scheduler and real workers, which know nothing of ThinPart at first."""

import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from pathlib import Path
from types import SimpleNamespace

import jsonschema
import pytest
import time_limit
from program import ROOT, SAMPLES, SCHEMA, failures, records, thinpart
from slow_files import make_endless

from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.run_control import RunControl
from thinpart_workbench.freecad_adapter.bootstrap import load_freecad
from thinpart_workbench.requirements import FREECAD_LIBS
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.analysis.analysis_outcome import failure
from thinpart_workbench.workflow.cluster.cluster_run import _Cluster, analyse_files_on_cluster
from thinpart_workbench.workflow.workers.task_run import Done

SMALL = ("wedge", "vee_block", "ribbed_block", "tube")


class Cluster:
    """A scheduler on a free port of this machine, and its workers."""

    def __init__(self, folder, **environment):
        self.folder, self.processes, self.environment = folder, [], environment
        self.file = folder / "scheduler.json"
        self.scheduler = self._start("scheduler", "--host", "127.0.0.1", "--port", "0", "--no-show",
                                     "--scheduler-file", self.file)
        time_limit.wait_until(lambda: self.file.is_file() and self.file.read_text().rstrip().endswith("}"),
                              "the file of the scheduler")
        self.address = json.loads(self.file.read_text())["address"]

    def worker(self, *options, before=()):
        return self._start("worker", self.address, "--nthreads", "1", "--memory-limit", "0",
                           "--host", "127.0.0.1", "--local-directory", self.folder, *options,
                           before=before)

    def _start(self, *arguments, before=()):
        # Nothing of ThinPart may be found by accident.
        environment = dict(os.environ, PYTHONPATH="", **self.environment)
        with open(self.folder / f"{len(self.processes)}.log", "wb") as log:
            process = subprocess.Popen(
                [*before, sys.executable, "-m", "dask", *map(str, arguments), "--no-dashboard"],
                cwd=self.folder, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                start_new_session=True)
        self.processes.append(process)
        return process

    def servers(self):
        """Processes that analyse files for these workers."""
        return [pid for pid in processes() if str(self.folder) in folder_of(pid)
                and b"analysis_server" in command_of(pid)]

    def stop(self):
        for process in self.processes:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGTERM)
        for process in self.processes:
            try:
                process.wait(4)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()


def processes():
    return [int(name) for name in os.listdir("/proc") if name.isdigit()]


def command_of(pid):
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return b""


def folder_of(pid):
    try:
        return os.readlink(f"/proc/{pid}/cwd")
    except OSError:
        return ""


def parent_of(pid):
    return int(Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])


def readers_of(file):
    for pid in processes():
        try:
            if any(os.readlink(link) == str(file) for link in Path(f"/proc/{pid}/fd").iterdir()):
                yield pid
        except OSError:
            continue


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    """Two workers, one with the process that Dask lets watch over it, one without."""
    cluster = Cluster(tmp_path_factory.mktemp("cluster"))
    try:
        cluster.worker()
        cluster.worker("--no-nanny")
        yield cluster
    finally:
        cluster.stop()


@pytest.fixture
def bare(tmp_path_factory):
    """A scheduler without workers, which gives a file up when one worker was lost with it."""
    cluster = Cluster(tmp_path_factory.mktemp("bare"),
                      DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES="0")
    try:
        yield cluster
    finally:
        cluster.stop()


def copies(folder, number, names=SMALL):
    folder.mkdir(exist_ok=True)
    for each in range(number):
        shutil.copy(SAMPLES / f"{names[each % len(names)]}.step", folder / f"{each}.step")
    return folder


def without_times(lines):
    return sorted(json.dumps({key: value for key, value in line.items() if key != "seconds"})
                  for line in lines)


def start(*arguments):
    return subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench", "classify", *map(str, arguments), "--json"],
        env=dict(os.environ, PYTHONPATH=str(ROOT)), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, encoding="utf-8", start_new_session=True)


def test_records_and_info_files_are_those_of_this_machine(cluster, tmp_path):
    parts = copies(tmp_path / "parts", 7)
    (parts / "6.step").write_bytes(b"")
    arguments = ("classify", "parts", "--json", "--info-dir")
    there = thinpart(*arguments, "there", "--dask", cluster.address, cwd=tmp_path)
    here = thinpart(*arguments, "here", cwd=tmp_path)
    assert there.returncode == here.returncode == 1
    assert len(records(there)) == 7 and failures(there) == {"6.step": "empty"}
    assert without_times(records(there)) == without_times(records(here))
    for info in (tmp_path / "here").iterdir():
        written = [json.loads((tmp_path / folder / info.name).read_text()) for folder in ("here", "there")]
        for content in written:
            content["parts"] = without_times(content["parts"])
        assert written[0] == written[1]
    assert len(list((tmp_path / "there").iterdir())) == 6
    again = thinpart(*arguments, "there", "--dask", cluster.address, cwd=tmp_path)
    assert sorted(again.stdout.splitlines()) == sorted(there.stdout.splitlines())
    # The workers are left as they were.
    time_limit.wait_until(lambda: not cluster.servers(), lambda: f"the end of {cluster.servers()}")
    time_limit.wait_until(lambda: not list(cluster.folder.rglob("thinpart_workbench")),
                          "the end of what was unpacked on the workers")


def test_the_files_of_a_worker_that_is_lost_are_done_by_others(cluster, tmp_path):
    parts = copies(tmp_path / "parts", 14, ["bent_sheet_bracket", "plate"])
    doomed = cluster.worker("--no-nanny")
    run = start(parts, "--dask", cluster.address)
    first = run.stdout.readline()
    time_limit.wait_until(lambda: len(cluster.servers()) == 3, "a process on each of three workers")
    doomed.kill()
    # Not `communicate`, which passes by what `readline` has buffered: lines that came along with the first.
    with run:
        rest, errors = run.stdout.read(), run.stderr.read()
    assert run.returncode == 0, errors
    assert len({json.loads(line)["file"] for line in (first + rest).splitlines()}) == 14
    assert len(list(parts.glob("*.thinpart.json"))) == 14
    # Also that of the lost worker.
    time_limit.wait_until(lambda: not cluster.servers(), lambda: f"the end of {cluster.servers()}")


def test_a_file_that_ends_its_reader_is_one_row(cluster, tmp_path):
    parts = copies(tmp_path / "parts", 3)
    make_endless(parts / "deadly.step")
    run = start(parts, "--no-info", "--dask", cluster.address)
    time_limit.wait_until(lambda: [*readers_of(parts / "deadly.step")], "a reader of the file")
    for reader in readers_of(parts / "deadly.step"):
        os.kill(reader, signal.SIGKILL)
    output, errors = run.communicate()
    lines = [json.loads(line) for line in output.splitlines()]
    assert run.returncode == 1 and len(lines) == 4 and "Traceback" not in errors
    assert [line["error"]["kind"] for line in lines if "error" in line] == ["crash"]
    assert all(process.poll() is None for process in cluster.processes[:3])


def test_a_file_that_ends_dask_workers_is_one_row(bare, tmp_path):
    parts = copies(tmp_path / "parts", 1)
    make_endless(parts / "deadly.step")
    watched = bare.worker()
    run = start(parts, "--no-info", "--dask", bare.address)
    time_limit.wait_until(lambda: [*readers_of(parts / "deadly.step")], "a reader of the file")
    server, = bare.servers()
    os.kill(parent_of(server), signal.SIGKILL)
    output, errors = run.communicate()
    assert run.returncode == 1 and "given up by Dask" in errors and watched.poll() is None
    kinds = {Path(line["file"]).name: line.get("error", {}).get("kind")
             for line in map(json.loads, output.splitlines())}
    assert kinds["deadly.step"] == "crash" and len(kinds) == 2


def test_a_paused_run_hands_out_nothing_more(cluster, tmp_path):
    tasks = [FileTask(str(file)) for file in sorted(copies(tmp_path / "parts", 16).iterdir())]
    control, seen = RunControl(), []
    resume = threading.Timer(2, control.resume)
    for outcome in analyse_files_on_cluster(cluster.address, tasks, Limits(), control):
        if not seen:
            control.pause()
            resume.start()
        seen.append((resume.finished.is_set(), outcome["file"]))
    assert len({file for _, file in seen}) == 16
    # Both workers had a few at hand.
    assert 1 <= sum(not resumed for resumed, _ in seen) <= 8


def test_ctrl_c_cancels_what_runs_and_leaves_nothing_behind(cluster, tmp_path):
    parts = copies(tmp_path / "parts", 10, ["flange"])
    run = start(parts, "--dask", cluster.address)
    first = run.stdout.readline()
    os.killpg(run.pid, signal.SIGINT)
    rest, errors = run.communicate()
    assert run.returncode == 130 and "Traceback" not in errors
    time_limit.wait_until(lambda: not cluster.servers(), lambda: f"the end of {cluster.servers()}")
    infos = list(parts.glob("*.thinpart.json"))
    assert 1 <= len((first + rest).splitlines()) <= len(infos) < 10
    for info in infos:
        jsonschema.validate(json.loads(info.read_text(encoding="utf-8")), SCHEMA)
    assert len(list(parts.iterdir())) == 10 + len(infos)
    assert thinpart("classify", parts / "0.step", "--dask", cluster.address).returncode == 0


def test_a_wrong_address_is_said_at_once(tmp_path):
    shutil.copy(SAMPLES / "wedge.step", tmp_path)
    for address in ("", "here", "tcp://here", "tcp://here:port", "http://here:8786", "tcp://a:1/b"):
        run = thinpart("classify", tmp_path, "--dask", address)
        assert run.returncode == 2 and "is not the address of a Dask scheduler" in run.stderr
        assert "Traceback" not in run.stderr


def test_nobody_at_the_address(tmp_path):
    task = FileTask(str(SAMPLES / "wedge.step"))
    with pytest.raises(ThinPartError, match="There is no Dask scheduler at tcp://127.0.0.1:1 ") as raised:
        list(analyse_files_on_cluster("tcp://127.0.0.1:1", [task], Limits(), patience=1))
    assert raised.value.kind == "cluster"


def test_a_scheduler_without_workers_and_one_that_is_lost(bare, tmp_path):
    parts = copies(tmp_path / "parts", 6, ["flange"])
    tasks = [FileTask(str(file)) for file in sorted(parts.iterdir())]
    with pytest.raises(ThinPartError, match="has no workers: start some with 'dask worker tcp://"):
        next(analyse_files_on_cluster(bare.address, tasks, Limits(), patience=1))
    bare.worker("--no-nanny")
    threads = []
    outcomes = analyse_files_on_cluster(bare.address, tasks, Limits(), on_threads_changed=threads.append)
    assert next(outcomes)["parts"] and threads == [1]
    bare.scheduler.kill()
    with pytest.raises(ThinPartError, match="finished results are saved: start again") as raised:
        list(outcomes)
    assert raised.value.kind == "cluster"


def mounts_allowed():
    return subprocess.run(["unshare", "--mount", "mount", "-t", "tmpfs", "none", "/mnt"],
                          capture_output=True).returncode == 0


@pytest.mark.skipif(not mounts_allowed(), reason="nothing may be hidden from a worker here")
def test_workers_that_lack_freecad_or_do_not_see_a_file(bare, tmp_path):
    parts = copies(tmp_path / "parts", 1)
    tasks = [FileTask(str(parts / "0.step"))]

    def hiding(*folders):
        script = ('while [ "$1" != -- ]; do [ ! -d "$1" ] || mount -t tmpfs none "$1" || exit; shift; done; '
                  'shift; exec "$@"')
        return "unshare", "--mount", "sh", "-c", script, "sh", *folders, "--"

    without = bare.worker("--no-nanny", before=hiding(*FREECAD_LIBS))
    with pytest.raises(ThinPartError, match="cannot analyse files: it lacks freecad"):
        next(analyse_files_on_cluster(bare.address, tasks, Limits()))
    without.terminate()
    without.wait(20)
    bare.worker("--no-nanny", before=hiding(str(parts)))
    outcome, = analyse_files_on_cluster(bare.address, tasks, Limits())
    assert outcome["file"] == tasks[0].file and outcome["error"]["kind"] == "missing"
    assert f"does not see {tasks[0].file}" in outcome["error"]["message"]


def test_duplicates_of_new_files_are_classified_there(cluster, tmp_path):
    folder = tmp_path / "parts"
    folder.mkdir()
    for name in ("one.step", "two.step"):
        shutil.copy(SAMPLES / "tube.step", folder / name)
    run = thinpart("duplicates", folder, "--json", "--dask", cluster.address)
    assert run.returncode == 0, run.stderr
    line, = map(json.loads, run.stdout.splitlines())
    assert line["kind"] == "identical" and {Path(part["file"]).name for part in line["parts"]} == {"one.step", "two.step"}
    assert thinpart("duplicates", folder, "--dask", "tcp://nowhere").returncode == 2


def make_brackets(folder):
    """A bracket that is not its own mirror image, what has been made of it, and the one to keep, which is the latest."""
    load_freecad()
    import FreeCAD as App
    import Part

    def bracket(length):
        lug = Part.makeBox(14, 8, 12, App.Vector(20, 22, 4))
        return Part.makeBox(length, 30, 4).fuse([Part.makeBox(4, 30, 25), lug]).removeSplitter()

    turned, inches = bracket(60.0), bracket(60.0)
    turned.Placement = App.Placement(App.Vector(210, -40, 9), App.Rotation(App.Vector(1, 2, 0.5), 77))
    inches.scale(1 / 25.4)
    folder.mkdir()
    for name, shape in {"turned": turned, "left": bracket(60.0).mirror(App.Vector(), App.Vector(1, 0, 0)), "inches": inches,
                        "longer": bracket(64.0), "bracket": bracket(60.0)}.items():
        shape.exportStep(str(folder / f"{name}.step"))
    later = (folder / "bracket.step").stat().st_mtime + 60.0
    os.utime(folder / "bracket.step", (later, later))
    return folder


@pytest.mark.timeout(180)  # five documents are read here, and compared here and there
def test_duplicates_are_those_of_this_machine(cluster, tmp_path, monkeypatch):
    parts = make_brackets(tmp_path / "parts")
    found, kept = {}, {}
    for place, options in (("here", ("--jobs", 2)), ("there", ("--dask", cluster.address))):
        monkeypatch.setenv("THINPART_CACHE", str(tmp_path / place))  # else what was compared here is taken from its cache
        run = thinpart("duplicates", parts, "--json", *options)
        assert run.returncode == 0, run.stderr
        found[place] = run.stdout
        kept[place] = {file.name: file.read_text() for file in (tmp_path / place / "comparisons").iterdir()}
    assert found["there"] == found["here"]
    members = [part for line in map(json.loads, found["there"].splitlines()) for part in line["parts"][1:]]
    assert {part["kind"] for part in members} == {"identical", "mirrored", "scaled", "alike"}
    assert all(part["evidence"]["compared"] == "geometry" for part in members)
    # This machine keeps what the workers have found, so that nothing is asked of a cluster again.
    assert kept["there"] == kept["here"] and len(kept["there"]) == 4
    again = thinpart("duplicates", parts, "--json", "--dask", "tcp://127.0.0.1:9")
    assert again.returncode == 0 and again.stdout == found["there"]
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "empty"))
    without = thinpart("duplicates", parts, "--json", "--dask", "tcp://127.0.0.1:9")
    assert without.returncode == 1 and "There is no Dask scheduler at tcp://127.0.0.1:9" in without.stderr
    time_limit.wait_until(lambda: not cluster.servers(), lambda: f"the end of {cluster.servers()}")


@pytest.mark.timeout(120)
def test_a_document_that_no_worker_can_compare_is_named(cluster, tmp_path, monkeypatch):
    parts = make_brackets(tmp_path / "parts")
    assert thinpart("classify", parts).returncode == 0
    (parts / "left.step").write_bytes(b"ISO-10303-21;")
    (parts / "inches.step").unlink()
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    run = thinpart("duplicates", parts, "--json", "--dask", cluster.address)
    assert run.returncode == 1 and "Traceback" not in run.stderr
    assert "left.step is damaged" in run.stderr and f"The file {parts / 'inches.step'} no longer exists." in run.stderr
    assert run.stderr.count("It is compared by what its info file keeps.") == 2
    compared = {Path(part["file"]).stem: part["evidence"]["compared"] for line in records(run) for part in line["parts"][1:]}
    assert compared == {"turned": "geometry", "longer": "geometry", "left": "outlines", "inches": "outlines"}


def test_a_comparison_whose_document_a_worker_does_not_see_says_so(tmp_path):
    for name in ("a.step", "b.step"):
        (tmp_path / name).write_text("x")
    task = SimpleNamespace(file=str(tmp_path / "a.step"))
    work = SimpleNamespace(files=lambda task: [task.file, str(tmp_path / "b.step")])
    cluster = _Cluster(None, "tcp://here:1", work, Limits(), 1.0, None)
    told = Done(task, failure=failure(task.file, "missing", "It is gone."))
    assert cluster._told(task, told, "anvil").failure["error"]["message"] == (
        f"The worker anvil does not see {task.file} or {tmp_path / 'b.step'}: mount the share there under the same path.")
    (tmp_path / "b.step").unlink()
    assert cluster._told(task, told, "anvil") == told
