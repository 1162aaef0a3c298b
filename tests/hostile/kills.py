#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that are killed at random moments, and what has to hold afterwards.

    python3 tests/hostile/kills.py --kills 2000 --seed 1 FOLDER

makes a library in FOLDER, which must be new, with a note on every part, and kills one command after the other. It stops
at the first thing that does not hold; the library stays where it is.
"""

import argparse
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[2]), str(Path(__file__).resolve().parents[1])]

from program import ROOT, SAMPLES, environment  # noqa: E402

from thinpart_workbench.storage.info.info_file import read_info  # noqa: E402

PARTS = ("plate.step", "tube.step", "ribbed_block.step", "wedge.step", "tube.FCStd", "assembly_of_three.step")
COPIES = 12
"""Of each part; `reclassify` takes 64 files at a time."""

LONGEST = 4.0
"""Seconds after which a command is killed at the latest."""

NOTE = "weighed and found thin"
COMMANDS = ("classify", "note", "reclassify", "find", "similar", "report", "size")
_SECONDS_TO_END = 15


class Library:
    """Parts with info files and notes, and commands that work on them.

    Parameters
    ----------
    folder : Path
        A new one.
    copies : int
        Of each part.

    Attributes
    ----------
    longest : float
        Seconds that a command took at most to end after it was asked to.
    """

    def __init__(self, folder, copies=COPIES):
        self.folder, self.parts, self.work, self.longest = folder, folder / "parts", folder / "work", 0.0
        if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
            # Started in the background; what it starts would ignore Ctrl-C as well, as it should.
            signal.signal(signal.SIGINT, signal.default_int_handler)
        for each in (self.parts, self.work, self.work / "home", self.work / "temporary"):
            each.mkdir(parents=True)
        for number in range(copies):
            for name in PARTS:
                # Each its own content, so that none stands for another.
                (self.parts / f"{number:02}-{name}").write_bytes(_own_content(SAMPLES / name, number))
        self.documents = {path: path.read_bytes() for path in self.parts.iterdir()}
        self.environment = environment(HOME=str(self.work / "home"), TMPDIR=str(self.work / "temporary"), COLUMNS="200")
        self.profiles = self._profiles()
        self.run("classify", self.parts)
        for path in self.info_files():
            content = json.loads(path.read_bytes())
            for part in content["parts"]:
                part["notes"] = NOTE
            path.write_text(json.dumps(content, ensure_ascii=False), encoding="utf-8")
        self.check()

    def _profiles(self):
        paper = json.loads((ROOT / "resources" / "profiles" / "paper.json").read_text(encoding="utf-8"))
        made = []
        for value in (0.2, 0.9):
            path = self.work / f"profile-{value}.json"
            for category in paper["categories"]:
                for criterion in category["criteria"]:
                    criterion["conditions"][0]["value"] = value
            path.write_text(json.dumps(paper), encoding="utf-8")
            made.append(path)
        return made

    def info_files(self):
        return sorted(self.parts.glob("*.thinpart.json"))

    def arguments(self, command, chance):
        """What a command is called with."""
        of_one_part = chance.choice([path for path in sorted(self.documents) if "assembly" not in path.name])
        return {
            "classify": ["classify", self.parts, "--force", "--jobs", 2],
            "note": ["note", of_one_part, "--set", f"{NOTE} again, {chance.random()}"],
            "reclassify": ["reclassify", self.parts, "--write", "--jobs", 2, "--profile", chance.choice(self.profiles)],
            "find": ["find", self.parts, "--category", "thin"],
            "similar": ["similar", of_one_part, self.parts],
            "report": ["report", *sorted(self.documents)[:3], "--output", self.work / "report", "--jobs", 2],
            "size": ["size", of_one_part, "--force", *(["--check"] if shutil.which("gmsh") else [])],
        }[command]

    def begin(self, *arguments):
        """Start the program in a session of its own."""
        return subprocess.Popen([sys.executable, "-m", "thinpart_workbench", *map(str, arguments)], env=self.environment,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                start_new_session=True, cwd=self.work)

    def run(self, *arguments):
        """Run a command to its end."""
        run = self.begin(*arguments)
        output = run.communicate()[0].decode(errors="replace")
        assert "Traceback" not in output, output[-3000:]
        assert run.returncode == 0, output[-3000:]

    def kill(self, command, chance, seconds):
        """Start a command and kill it after a part of `seconds`; whether it was still running."""
        run = self.begin(*self.arguments(command, chance))
        try:
            output = run.communicate(timeout=chance.random() * seconds)[0].decode(errors="replace")
        except subprocess.TimeoutExpired:
            how = chance.choice((signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT))
            run.send_signal(how)
            asked = time.monotonic()
            try:
                output = run.communicate(timeout=_SECONDS_TO_END)[0].decode(errors="replace")
            except subprocess.TimeoutExpired:
                raise AssertionError(f"{command} goes on after {how.name}: {_states(run.pid)}") from None
            # Python tells of a Ctrl-C that comes before we could have said what becomes of one.
            ours = output.replace("thinpart_workbench/__main__.py", "")
            assert "Traceback" not in output or "thinpart_workbench" not in ours, (command, how, output[-3000:])
            if how != signal.SIGKILL:
                self.longest = max(self.longest, time.monotonic() - asked)
                # Done just now, or asked before Python has come to our first line.
                assert run.returncode in (0, 130, -how) or "Traceback" in output, (
                    command, how, run.returncode, output[-3000:])
            self._wait_for_orphans(run.pid)
            return True
        assert "Traceback" not in output, (command, output[-3000:])
        return False

    def _wait_for_orphans(self, session):
        end = time.monotonic() + _SECONDS_TO_END
        while left := _in_session(session):
            assert time.monotonic() < end, f"processes {left} outlive the one that started them"
            time.sleep(0.05)

    def check(self):
        """Every info file is whole and valid and has its note, and no document was touched."""
        infos = self.info_files()
        assert len(infos) == len(self.documents)
        for path in infos:
            content = read_info(path)
            for part in content["parts"]:
                assert part["notes"].startswith(NOTE), (path, part["notes"])
        for path, content in self.documents.items():
            assert path.read_bytes() == content, path

    def finish(self):
        """Every command still does all of its work, and nothing of the killed ones is left."""
        then = time.time() - 3600
        for path in self.folder.rglob(".thinpart-*.tmp"):
            os.utime(path, (then, then))
        chance = random.Random(0)
        for command in COMMANDS:
            self.run(*self.arguments(command, chance))
        self.check()
        assert not list(self.parts.glob(".thinpart-*")) and os.listdir(self.work / "temporary") == []


def _own_content(path, number):
    content = path.read_bytes()
    if path.suffix != ".step":
        return content
    return content.replace(b"HEADER;", b"HEADER;\n/* copy %d */" % number, 1)


def _states(session):
    """What the processes of a session are doing, as far as the system tells."""
    told = []
    for number in _in_session(session):
        for task in Path(f"/proc/{number}/task").glob("*"):
            try:
                told.append(f"{number}/{task.name} {(task / 'stat').read_text().rpartition(')')[2].split()[0]} "
                            f"{(task / 'wchan').read_text()} {(task / 'syscall').read_text().split()[:2]}")
            except OSError:
                continue
    return told


def _in_session(session):
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if fields[3] == str(session) and fields[0] != "Z":
            found.append(int(stat.parent.name))
    return found


def kill_commands(library, kills, seed, commands=COMMANDS, tell=None):
    """Kill commands and check after each.

    Parameters
    ----------
    library : Library
    kills, seed : int
    commands : tuple of str
    tell : callable, optional
        Takes the kills so far.

    Returns
    -------
    Counter
        How often each was killed while it was running.
    """
    chance, killed = random.Random(seed), Counter()
    takes = {}
    for command in commands:
        started = time.monotonic()
        library.run(*library.arguments(command, chance))
        takes[command] = min(LONGEST, time.monotonic() - started)
    while sum(killed.values()) < kills:
        command = chance.choice(commands)
        killed[command] += library.kill(command, chance, takes[command])
        library.check()
        if tell is not None:
            tell(killed)
    return killed


def _tell(killed):
    print(f"\r{sum(killed.values())} kills", end="", file=sys.stderr, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    started = time.monotonic()
    library = Library(options.folder.absolute())
    killed = kill_commands(library, options.kills, options.seed, tell=_tell)
    library.finish()
    print(f"{options.kills} kills, seed {options.seed}: {time.monotonic() - started:.0f} s, "
          f"nothing lost, nobody left running; what was asked to end did within {library.longest:.2f} s")
    for command, count in killed.most_common():
        print(f"  {command:12} {count}")
    shutil.rmtree(options.folder)


if __name__ == "__main__":
    main()
