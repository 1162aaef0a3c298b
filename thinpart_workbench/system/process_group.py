# SPDX-License-Identifier: LGPL-2.1-or-later
"""End a process together with the processes that it has started."""

import os
import signal
import sys

OWN_GROUP = sys.platform != "win32"
"""Value of ``start_new_session`` for a process that `kill_group` is to end: it then has no terminal either."""


def kill_group(process):
    """Kill a Popen started with `OWN_GROUP`, ended or not, and on Unix all it started that is still in its group."""
    if not OWN_GROUP:
        process.kill()
        return
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass  # all of them have ended
    except PermissionError:
        process.kill()  # macOS: it has ended, but nobody has waited for it
