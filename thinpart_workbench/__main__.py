"""``python -m thinpart_workbench COMMAND``."""

import os
import signal
import sys

if __name__ == "__main__":
    if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:
        # Nothing has started yet. Exit directly, because an exception could get lost in the middle of an import.
        signal.signal(signal.SIGINT, lambda *_: os._exit(130))
    from .cli import main

    sys.exit(main())
