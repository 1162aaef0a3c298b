# SPDX-License-Identifier: LGPL-2.1-or-later
"""``dask worker --preload`` of this file: a worker that answers with programs instead of results.

$HOSTILE_FOLDER takes a file with the number of each process that ran one, $HOSTILE_WAY says what it does.
"""

import json
import os
import threading
import time

WAYS = {}


class Program:
    """Leaves a file when it is unpickled, named by the process that did it."""

    def __reduce__(self):
        return os.system, (f"touch {os.environ['HOSTILE_FOLDER']}/$PPID",)


class ProgramError(Exception):
    """The same as an exception."""

    __reduce__ = Program.__reduce__


def way(function):
    WAYS[function.__name__] = function


@way
def a_program_as_result(plugin):
    plugin.analyse = lambda task: Program()


@way
def a_program_as_error(plugin):
    def analyse(task):
        raise ProgramError("hostile")

    plugin.analyse = analyse


@way
def a_program_as_software(plugin):
    dumps = json.dumps
    json.dumps = lambda value, *rest, **more: Program() if "host" in value else dumps(value, *rest, **more)


@way
def no_result(plugin):
    plugin.analyse = lambda task: json.dumps({"software": plugin.software(), "outcome": json.dumps({
        "parts": [{"file": "/etc/passwd"}], "failures": []})})


@way
def no_text(plugin):
    plugin.analyse = lambda task: {"software": {}, "outcome": 7}


def dask_setup(worker):
    """Called by Dask."""
    def change():
        changed = set()
        while True:
            for name, plugin in list(worker.plugins.items()):
                if name not in changed and hasattr(plugin, "analyse"):
                    changed.add(name)
                    WAYS[os.environ["HOSTILE_WAY"]](plugin)
            time.sleep(0.001)

    threading.Thread(target=change, daemon=True).start()
