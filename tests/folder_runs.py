# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs over whole folders under way, for the tests that pause, stop and kill them."""

import json
import queue
import shutil
import subprocess
import sys
import threading

import jsonschema
import time_limit
from program import SAMPLES, SCHEMA, environment

TUBE = SAMPLES / "tube.step"


def tubes(folder, *names):
    folder.mkdir(exist_ok=True)
    for name in names:
        shutil.copy(TUBE, folder / name)
    return folder


def messages(text):
    """The JSON lines on stderr, and the sentences among them."""
    lines = text.splitlines()
    return ([json.loads(line) for line in lines if line.startswith("{")],
            [line for line in lines if not line.startswith("{")])


def infos(folder):
    """The info files of a folder by name, each checked to be whole."""
    found = {}
    for path in folder.rglob("*.thinpart.json"):
        found[path.name.removesuffix(".thinpart.json")] = content = json.loads(path.read_bytes())
        jsonschema.validate(content, SCHEMA)
    return found


class Run:
    """The program under way, with what it says on stderr as it says it."""

    def __init__(self, *arguments, first=b"", **options):
        self.process = subprocess.Popen(
            [sys.executable, "-m", "thinpart_workbench", "classify", *map(str, arguments)],
            env=environment(), stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True, **options)
        self.lines, self.output, self.said = queue.Queue(), [], []
        self.tell(first)
        self.threads = [threading.Thread(target=target, daemon=True)
                        for target in (self._read_errors, self._read_output)]
        for thread in self.threads:
            thread.start()

    def _read_errors(self):
        for line in self.process.stderr:
            self.lines.put(line.decode())

    def _read_output(self):
        for line in self.process.stdout:
            self.output.append(line.decode())

    def tell(self, command):
        self.process.stdin.write(command)
        self.process.stdin.flush()

    def until(self, wanted):
        """Read on to the line that holds this; return it."""
        def is_said():
            while not self.lines.empty():
                self.said.append(self.lines.get())
                if wanted in self.said[-1]:
                    return True
            return False

        time_limit.wait_until(is_said, lambda: f"a line with {wanted} on stderr, which ends in {self.said[-3:]}")
        return self.said[-1]

    def end(self):
        """(exit status, records, JSON lines of stderr, sentences) once it has ended."""
        status = self.process.wait()
        self.close()
        while not self.lines.empty():
            self.said.append(self.lines.get())
        return (status, [json.loads(line) for line in self.output], *messages("".join(self.said)))

    def close(self):
        """Close the pipes of a process that has ended, once all is read."""
        for thread in self.threads:
            thread.join()
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            pipe.close()

    def done(self):
        """Numbers of done files that were told so far."""
        while not self.lines.empty():
            self.said.append(self.lines.get())
        return [each["progress"]["done"] for each in messages("".join(self.said))[0]
                if "progress" in each]
