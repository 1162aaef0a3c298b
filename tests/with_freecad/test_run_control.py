# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs over whole folders: progress, pausing, interruption, going on, two at once."""

import csv
import os
import pty
import re
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from folder_runs import infos, messages, tubes
from program import environment, group_ended, thinpart
from slow_files import make_endless

PROGRESS_KEYS = ["done", "total", "failed", "reused", "seconds", "seconds_left", "file"]


def test_progress_lines_and_a_second_run_that_does_only_the_rest(tmp_path):
    folder = tubes(tmp_path / "parts", "a.step", "b.step")
    (folder / "empty.step").write_bytes(b"")
    for reused in (0, 2):
        run = thinpart("classify", folder, "--json", "--jobs", "1")
        told, sentences = messages(run.stderr)
        assert [each["state"] for each in told if "state" in each] == ["searching", "running"]
        lines = [each["progress"] for each in told if "progress" in each]
        assert all(list(line) == PROGRESS_KEYS for line in lines)
        assert [(line["done"], line["total"]) for line in lines] == [(0, 3), (1, 3), (2, 3), (3, 3)]
        assert (lines[0]["file"], lines[0]["seconds_left"]) == (None, None)
        assert {line["file"] for line in lines[1:]} == {
            str(folder / name) for name in ("a.step", "b.step", "empty.step")}
        assert (lines[-1]["failed"], lines[-1]["reused"]) == (1, reused)
        assert lines[-1]["seconds_left"] == 0 and lines[-1]["seconds"] >= lines[1]["seconds"]
        assert run.returncode == 1 and len(sentences) == 1 and "empty.step" in sentences[0]
    tubes(folder, "c.step")
    run = thinpart("classify", folder, "--json", "--jobs", "1")
    lines = [each["progress"] for each in messages(run.stderr)[0] if "progress" in each]
    assert (lines[-1]["total"], lines[-1]["reused"]) == (4, 2)
    # What is only looked up comes first.
    assert [Path(line["file"]).name for line in lines[1:3]] == ["a.step", "b.step"]


def test_time_left_is_told_once_something_was_measured(tmp_path):
    folder = tubes(tmp_path / "parts", *(f"{number}.step" for number in range(4)))
    run = thinpart("classify", folder, "--json", "--jobs", "1", "--no-info")
    left = [each["progress"]["seconds_left"] for each in messages(run.stderr)[0] if "progress" in each]
    assert left[0] is None and left[1] > left[3] > left[4] == 0


def test_a_terminal_has_a_bar_and_the_table_is_alone_on_stdout(tmp_path):
    folder = tubes(tmp_path / "parts", "a.step", "b.step")
    (folder / "empty.step").write_bytes(b"")
    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench", "classify", str(folder), "--no-info"],
        env=environment(COLUMNS="150", TERM="xterm"),
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=theirs, encoding="utf-8")
    os.close(theirs)
    shown = []

    def read():
        while True:
            try:
                content = os.read(ours, 65536)
            except OSError:  # how a terminal says that nobody writes any more
                return
            shown.append(content)

    reader = threading.Thread(target=read)
    reader.start()
    table = process.communicate()[0]
    reader.join()
    os.close(ours)
    text = re.sub(r"\x1b\[[\d;?]*[A-Za-z]", "", b"".join(shown).decode())
    assert "3 of 3 files, 1 failed" in text and "in all" in text and f"[{20 * '='}]" in text
    assert "empty.step is empty (0 bytes). [empty]" in text.replace("\r\n", " ")
    assert [line.split()[0] for line in table.splitlines()] == ["File", "a.step", "b.step", "empty.step"]


def test_without_a_terminal_only_failures_are_told(tmp_path):
    run = thinpart("classify", tubes(tmp_path / "parts", "a.step", "b.step"), "--no-info")
    assert run.returncode == 0 and run.stderr == ""


def test_pause_before_the_first_file_and_resume(tmp_path, start):
    folder = tubes(tmp_path / "parts", "a.step", "b.step", "gone.step")
    run = start(folder, "--json", "--control", first=b"pause\n")
    run.until('"done": 0')
    time.sleep(1)  # more than a file takes
    assert run.done() == [0] and not infos(folder)
    (folder / "gone.step").unlink()  # vanishes between listing and reading
    run.tell(b"what\nresume\n")
    status, lines, told, sentences = run.end()
    assert status == 1 and len(lines) == 3 and set(infos(folder)) == {"a.step", "b.step"}
    assert [line["error"]["kind"] for line in lines if "error" in line] == ["missing"]
    assert [each["state"] for each in told if "state" in each][-2:] == ["paused", "running"]
    assert any("no command 'what'" in sentence for sentence in sentences)


def test_pause_in_the_middle_lets_those_at_work_end(tmp_path, start):
    folder = tubes(tmp_path / "parts", *(f"{number:02}.step" for number in range(10)))
    run = start(folder, "--json", "--control", "--jobs", "1")
    run.until('"done": 1')
    run.tell(b"pause\n")
    run.until('"paused"')
    before = max(run.done())
    time.sleep(1)  # several files would be done
    assert before <= max(run.done()) <= before + 1 < 10
    assert len(infos(folder)) == max(run.done())
    run.tell(b"resume\n")
    status, lines, told, _ = run.end()
    assert status == 0 and len({line["file"] for line in lines}) == len(lines) == 10
    assert [each["state"] for each in told if "state" in each] == [
        "searching", "running", "paused", "running"]
    assert run.done() == list(range(11))


@pytest.mark.parametrize("how", ["stop", "end of input", "SIGTERM", "SIGINT", "SIGHUP", "stop in a pause"])
def test_a_run_that_is_stopped_keeps_what_was_done(tmp_path, start, how):
    folder = tubes(tmp_path / "parts", *(f"{number:02}.step" for number in range(3)))
    make_endless(folder / "zzz.step")  # its reader never ends
    table = tmp_path / "table.csv"
    run = start(folder, "--json", "--control", "--jobs", "1", "--csv", table)
    run.until('"done": 3')
    if how == "end of input":
        run.process.stdin.close()
    elif how.startswith("SIG"):
        os.kill(run.process.pid, getattr(signal, how))
    else:
        if how == "stop in a pause":
            run.tell(b"pause\n")
            run.until('"paused"')
        run.tell(b"stop\n")
    status, lines, _, sentences = run.end()
    assert status == 130 and "Traceback" not in "".join(sentences) and group_ended(run.process.pid)
    assert len(lines) == len(infos(folder)) == 3
    with open(table, newline="", encoding="utf-8") as file:
        assert [row["file"] for row in csv.DictReader(file)] == ["00.step", "01.step", "02.step"]


def test_a_run_goes_on_where_another_was_stopped(tmp_path, start):
    folder = tubes(tmp_path / "parts", *(f"{number:02}.step" for number in range(3)))
    make_endless(folder / "zzz.step")
    table = tmp_path / "table.csv"
    run = start(folder, "--json", "--control", "--jobs", "1", "--csv", table)
    run.until('"done": 3')
    run.tell(b"stop\n")
    assert run.end()[0] == 130
    (folder / "zzz.step").unlink()
    tubes(folder, "zzz.step")
    second = thinpart("classify", folder, "--json", "--csv", table)
    last = messages(second.stderr)[0][-1]["progress"]
    assert (second.returncode, last["done"], last["reused"]) == (0, 4, 3)
    assert len(table.read_text().splitlines()) == 5


def test_a_run_is_stopped_while_it_searches_too(tmp_path, start):
    folder = tubes(tmp_path / "parts", "a.step")
    run = start(folder, "--json", "--control", first=b"stop\n")
    assert run.end()[0] == 130


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_after_kill_9_of_the_command_no_worker_lives_on(tmp_path, start, jobs):
    folder = tubes(tmp_path / "parts", "a.step", "b.step", "c.step")
    (folder / "bad.step").write_bytes(b"")
    make_endless(folder / "zzz.step")
    run = start(folder, "--json", "--jobs", jobs)
    run.until('"done": 4')
    os.kill(run.process.pid, signal.SIGKILL)  # not its group: it is the system that ends the workers
    run.process.wait()
    assert group_ended(run.process.pid)
    assert set(infos(folder)) == {"a.step", "b.step", "c.step"}
    (folder / "zzz.step").unlink()
    tubes(folder, "zzz.step")
    second = thinpart("classify", folder, "--json")
    last = messages(second.stderr)[0][-1]["progress"]
    assert (last["done"], last["reused"], last["failed"]) == (5, 3, 1)


def test_two_runs_on_one_folder_do_not_harm_each_other(tmp_path, start):
    names = [f"{number}.step" for number in range(6)]
    folder = tubes(tmp_path / "parts", *names)
    runs = [start(folder, "--json", "--jobs", "1") for _ in range(2)]
    for run in runs:
        status, lines, _, _ = run.end()
        assert status == 0 and [line["category"] for line in lines] == ["thin"] * len(names)
    assert sorted(infos(folder)) == names
    assert sorted(os.listdir(folder)) == sorted([*names, *(f"{name}.thinpart.json" for name in names)])
