# SPDX-License-Identifier: LGPL-2.1-or-later
"""A screen without a monitor, for one FreeCAD."""

import os
import select
import subprocess
from contextlib import contextmanager

SECONDS = 60


@contextmanager
def virtual_screen(width, height):
    """Start Xvfb and yield the name of its display, such as ":0"; it ends with the block.

    The server looks for a free number itself. xvfb-run looks into /tmp for one, which folders of several systems
    do not share although their screens' abstract sockets have the same names.

    Raises
    ------
    RuntimeError
        Where the server does not start.
    """
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{width}x{height}x24", "-dpi", "96", "-nolisten", "tcp"],
        pass_fds=[writing], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        os.close(writing)
        yield f":{_number(server, reading)}"
    finally:
        os.close(reading)
        server.kill()
        server.wait()
        server.stderr.close()


def _number(server, reading):
    """What the server says that its number is."""
    said = b""
    while not said.endswith(b"\n"):
        ready, _, _ = select.select([reading], [], [], SECONDS)
        more = os.read(reading, 64) if ready else b""
        if not more:
            server.kill()
            raise RuntimeError("Xvfb does not start: " + server.stderr.read().decode(errors="replace")[-2000:])
        said += more
    return int(said)
