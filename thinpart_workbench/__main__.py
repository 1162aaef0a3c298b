# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m thinpart_workbench COMMAND``."""

import os
import signal
import sys

if __name__ == "__main__":
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK"):  # `interruption.STOP_SIGNALS`, which is not imported yet
        if hasattr(signal, name) and signal.getsignal(getattr(signal, name)) != signal.SIG_IGN:
            # Nothing has started yet. Exit directly, because an exception could get lost in the middle of an import.
            signal.signal(getattr(signal, name), lambda *_: os._exit(130))
    from .cli import INTERRUPTED, main

    status = main()
    if status == INTERRUPTED:
        # Python would end by SIGINT instead where the exception came through an `exec`, as of a dataclass.
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)
    sys.exit(status)
