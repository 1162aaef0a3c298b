# SPDX-License-Identifier: LGPL-2.1-or-later
"""``--control``: lets another program pause and stop a run through its standard input."""

import os
import sys
import threading

from ..system.pipe_input import is_readable


def listen(control, handle=0):
    """Read commands in a thread and apply them to a RunControl.

    It is paused by ``pause``, resumed by ``resume``, stopped by ``stop`` and by the end of the input, which means that the
    program that started the run has ended. The handle is no `sys.stdin`, whose lock this thread would still hold when the
    process ends.
    """
    commands = {b"pause": control.pause, b"resume": control.resume, b"stop": control.stop}
    pending = b""

    def obey_next():
        nonlocal pending
        content = _read(handle)
        *lines, pending = (pending + content).split(b"\n")
        for line in [line.strip() for line in lines] + ([] if content else [b"stop"]):
            if line in commands:
                commands[line]()
            elif line:
                print(f"thinpart: there is no command {line.decode(errors='replace')!r} here: use "
                      "pause, resume or stop.", file=sys.stderr, flush=True)

    def obey():
        while not control.stopped:
            obey_next()

    # Apply commands that were sent before the start right away; the thread might read them after the first file.
    while not control.stopped and _has_input(handle):
        obey_next()
    threading.Thread(target=obey, name="thinpart-control", daemon=True).start()


def _has_input(handle):
    try:
        return is_readable(handle, 0)
    except OSError:
        return True  # reading reports the error


def _read(handle):
    try:
        is_readable(handle)  # wait, because the descriptor may be non-blocking
        return os.read(handle, 4096)
    except OSError:
        return b""  # the terminal was closed, or there is no input at all
