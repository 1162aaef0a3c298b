"""``--control``: another program pauses and stops a run through its standard input."""

import os
import sys
import threading

from ..system.pipe_input import is_readable


def listen(control, handle=0):
    """Obey the lines that come in, in a thread of its own.

    Parameters
    ----------
    control : RunControl
        Is paused by ``pause``, resumed by ``resume``, stopped by ``stop`` and by the end of the input:
        whoever started the run is gone then.
    handle : int
        What is read; not through `sys.stdin`, whose lock this thread would take into the end of the
        process.
    """
    commands = {b"pause": control.pause, b"resume": control.resume, b"stop": control.stop}

    def obey():
        pending = b""
        while not control.stopped:
            content = _read(handle)
            *lines, pending = (pending + content).split(b"\n")
            for line in [each.strip() for each in lines] + ([] if content else [b"stop"]):
                if line in commands:
                    commands[line]()
                elif line:
                    print(f"thinpart: there is no command {line.decode(errors='replace')!r} for a run "
                          "under way: it takes pause, resume and stop.", file=sys.stderr, flush=True)

    threading.Thread(target=obey, name="thinpart-control", daemon=True).start()


def _read(handle):
    try:
        is_readable(handle)  # whoever made it may have made it non-blocking
        return os.read(handle, 4096)
    except OSError:
        return b""  # a terminal that is gone, or no input at all
