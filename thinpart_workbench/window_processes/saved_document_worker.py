"""The process that classifies a document after it was saved, from its file.

It does not use a snapshot of the open document: finding the equal solids among many would block FreeCAD's window for
seconds, and the info file describes linked documents as they were saved. The process receives one job, the arguments of
`classify_saved`, and responds with the attributes of `SavedVerdicts`, or with ``failure`` (see `JsonLines`). It stops at
the end of its input.
"""

import os
import threading
import time

from ..api.saved_documents import classify_saved
from ..core.analysis_settings import AnalysisSettings
from ..core.errors import ThinPartError
from ..core.message import message
from ..core.run_control import RunControl
from .json_lines import JsonLines

_SECONDS_TO_STOP = 2.5
"""Seconds until the process is ended even if it is blocked, for example by a lost share."""


def main():
    """Process the one job."""
    parent, control = JsonLines(), RunControl()
    job = parent.incoming.get()
    if job is None:
        parent.end()
    threading.Thread(target=_stop_at_end_of_input, args=(parent, control), daemon=True).start()
    with parent.reporting_failures():
        try:
            settings = AnalysisSettings(**job["settings"])
            parent.send(**vars(classify_saved(**{**job, "settings": settings}, control=control)))
        except ModuleNotFoundError as error:
            raise ThinPartError(
                message("The Python module {module} is missing: install it to have documents classified "
                        "automatically (Debian: python3-{module}).", module=error.name), "unsupported") from None
        except KeyboardInterrupt:
            pass  # the parent no longer waits for a response
    parent.end()


def _stop_at_end_of_input(parent, control):
    while parent.incoming.get() is not None:
        pass
    control.stop()
    time.sleep(_SECONDS_TO_STOP)
    os._exit(1)


if __name__ == "__main__":
    main()
