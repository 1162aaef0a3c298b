# SPDX-License-Identifier: LGPL-2.1-or-later
"""`reclassify` over more info files than one process takes: interrupted, killed, and with files that kill."""

import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import time_limit
from made_library import PAPER, make_large_library, make_library
from program import environment

from thinpart_workbench.core.errors import Cancelled
from thinpart_workbench.core.run_control import RunControl
from thinpart_workbench.storage.info.info_file import SUFFIX, read_info
from thinpart_workbench.workflow.library import reclassify
from thinpart_workbench.workflow.library.reclassify import reclassify_files
from thinpart_workbench.workflow.workers import process_pool

FILES = 400
ROUNDS = 4
PROFILES = {name: {**PAPER.content, "name": name} for name in ("one", "another")}

linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="processes are found in /proc")


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """Info files that every test may judge by either of `PROFILES`, and those profiles as files."""
    folder = tmp_path_factory.mktemp("reclassify")
    infos = sorted(make_library(folder / "models").rglob(f"*{SUFFIX}"))
    make_large_library(folder / "library", infos, FILES)
    for name, content in PROFILES.items():
        (folder / f"{name}.json").write_text(json.dumps(content))
    return folder / "library"


@pytest.fixture(autouse=True)
def tidy(library):
    """A process that is killed leaves the file behind that it was writing."""
    for each in unfinished(library):
        each.unlink()


def info_files(library):
    return sorted(str(path) for path in library.rglob(f"*{SUFFIX}"))


def started(library, profile):
    return subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench", "reclassify", str(library), "--profile",
         str(library.parent / f"{profile}.json"), "--write", "--json", "--jobs", "2"],
        env=environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        encoding="utf-8", start_new_session=True)


def worker_processes(run):
    return [number for number, command in time_limit.children(run.pid) if "pool_worker" in command]


def in_the_middle(run, chance):
    """Some moment after the workers were started; the run may just have ended."""
    time_limit.wait_until(lambda: worker_processes(run) or run.poll() is not None, "workers")
    time.sleep(chance.uniform(0.0, 1.2))


def is_over(group):
    """Whether no process of a group is left but such as wait for whoever inherited them."""
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, its_group = stat.read_text(errors="replace").rpartition(")")[2].split()[:3]
        except OSError:
            continue  # it ended while being looked at
        if int(its_group) == group and state != "Z":
            return False
    return True


def profiles_of(library):
    """How many info files, all of them whole, say which profile."""
    names = [read_info(path)["profile"]["name"] for path in info_files(library)]
    assert len(names) == FILES
    return {name: names.count(name) for name in set(names)}


def unfinished(library):
    return list(library.rglob("*.tmp"))


@linux
@pytest.mark.timeout(180)
def test_ctrl_c_ends_it_at_once_with_every_file_whole(library):
    chance, statuses = random.Random(7), []
    for number in range(ROUNDS):
        run = started(library, ("one", "another")[number % 2])
        in_the_middle(run, chance)
        os.killpg(run.pid, signal.SIGINT)
        rows, errors = run.communicate(timeout=20)
        told = {json.loads(row)["info_file"] for row in rows.splitlines() if json.loads(row)["category"]}
        # It may have told all before it was asked.
        assert run.returncode == 130 or (run.returncode, len(told)) == (0, FILES), errors
        assert "Traceback" not in errors, errors
        time_limit.wait_until(lambda run=run: is_over(run.pid), "the end of all its processes", 2)
        assert not unfinished(library) and set(profiles_of(library)) <= {"paper", *PROFILES}
        statuses.append(run.returncode)
    assert 130 in statuses


@linux
@pytest.mark.timeout(180)
def test_workers_end_with_a_parent_that_is_killed(library):
    chance = random.Random(8)
    for number in range(4):
        run = started(library, ("one", "another")[number % 2])
        in_the_middle(run, chance)
        run.kill()
        run.communicate(timeout=20)
        time_limit.wait_until(lambda run=run: is_over(run.pid), "the end of all its processes", 2)
        assert set(profiles_of(library)) <= {"paper", *PROFILES}


@linux
@pytest.mark.timeout(180)
def test_a_worker_that_is_killed_costs_nothing(library):
    chance = random.Random(9)
    for number in range(4):
        profile = ("one", "another")[number % 2]
        run = started(library, profile)
        for _ in range(2):
            in_the_middle(run, chance)
            for process in worker_processes(run)[:1]:
                os.kill(process, signal.SIGKILL)
        rows, errors = run.communicate(timeout=50)
        assert run.returncode == 0 and not errors, errors
        told = [json.loads(row)["info_file"] for row in rows.splitlines()]
        assert list(dict.fromkeys(told)) == info_files(library)
        expected = sum(len(read_info(path)["parts"]) for path in info_files(library))
        assert len(told) == expected and profiles_of(library) == {profile: FILES}


SLOW = "part 000000.step"
JUDGED = reclassify._judged


def deadly(batch):
    """As a worker judges, with files that end it or keep it busy."""
    for info_file in batch.info_files:
        if info_file == "deadly":
            os.kill(os.getpid(), signal.SIGKILL)
        if info_file == "endless":
            time.sleep(600)
    return JUDGED(batch)


def slow(batch):
    """As a worker judges; the first file of all takes long."""
    if SLOW in batch.info_files[0]:
        time.sleep(1)
    return JUDGED(batch)


@linux
def test_files_that_kill_or_hold_up_their_reader_are_rows_and_the_rest_goes_on(library, monkeypatch):
    monkeypatch.setattr(reclassify, "_judged", deadly)
    monkeypatch.setattr(reclassify, "_SECONDS", 2.0)
    monkeypatch.setattr(reclassify, "FILES_AT_ONCE", 8)
    files = info_files(library)[:30]
    files[3:3], files[20:20], files[29:29] = ["deadly"], ["endless"], ["gone" + SUFFIX]
    told = list(reclassify_files(files, PAPER.content, jobs=2))
    assert [each.info_file for each in told] == files
    assert {each.info_file: each.error for each in told if each.error} == {
        "deadly": "deadly crashed the process that read it: the file is probably damaged.",
        "endless": "endless took longer than 2 s, the limit for one file.",
        "gone" + SUFFIX: "The info file gone.thinpart.json cannot be read (No such file or directory)."}
    assert all(each.parts for each in told if not each.error)


def test_what_waits_for_its_turn_does_not_pile_up(library, monkeypatch):
    begun = []
    submit = process_pool.ProcessPool.submit
    monkeypatch.setattr(process_pool.ProcessPool, "submit",
                        lambda pool, batch: (begun.extend(batch.info_files), submit(pool, batch)))
    monkeypatch.setattr(reclassify, "_judged", slow)
    monkeypatch.setattr(reclassify, "FILES_AT_ONCE", 1)
    files = info_files(library)[:200]
    assert SLOW in files[0]
    judged = reclassify_files(files, PAPER.content, jobs=2)
    first = next(judged)
    assert len(begun) < 50
    assert [first.info_file, *(each.info_file for each in judged)] == files


@pytest.mark.parametrize("jobs", [1, 2])
def test_it_stops_between_two_files(library, jobs):
    control, told = RunControl(), []
    with pytest.raises(Cancelled):
        for each in reclassify_files(info_files(library), PROFILES["one"], True, jobs, control):
            told.append(each)
            control.stop()
    assert len(told) == 1 and not unfinished(library) and sum(profiles_of(library).values()) == FILES


@linux
def test_the_processes_behind_the_window_end_with_it(library):
    run = subprocess.Popen([sys.executable, "-m", "thinpart_workbench.window_processes.judging_worker"],
                           env=environment(), stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                           encoding="utf-8", start_new_session=True)
    for request in ({"ask": "open", "roots": [str(library)]}, {"ask": "write", "profile": PROFILES["one"]}):
        run.stdin.write(json.dumps(request) + "\n")
    run.stdin.flush()
    time_limit.wait_until(lambda: worker_processes(run), "workers")
    run.kill()
    run.communicate()
    time_limit.wait_until(lambda: is_over(run.pid), "the end of all its processes", 2)
