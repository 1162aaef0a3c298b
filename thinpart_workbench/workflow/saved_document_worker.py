"""The process that classifies a document which was just saved, from its file.

Not from a snapshot of the open document: to find out which of its solids are equal takes FreeCAD's
window seconds where there are many, and what is linked into the document counts as it was saved, which
is what the info file tells. It is told one job, the keywords of `classify_saved`, and answers with what
that returns, or ``{"failure": sentence}``. It stops when the other end is closed.
"""

import os
import threading
import time

from ..core.analysis_settings import AnalysisSettings
from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..storage.info_file import is_current, stored_info
from .analyse_file import FileTask
from .document_verdicts import document_verdicts
from .info_location import PATIENCE, info_location, reach
from .json_lines import JsonLines
from .run_control import RunControl
from .worker_pool import Limits, analyse_files

_STOPPING = 2.5
"""Seconds after which the process ends whatever it is busy with, such as a share that is gone."""

_NO_PART = ("empty", "no_solid")
"""Kinds of failures of documents that have no part, which is nothing to complain about."""


def classify_saved(document, folder, settings, profile, seconds, megabytes, measure=True,
                   patience=PATIENCE, control=None):
    """Classify a document, or take its verdicts from a current info file.

    Parameters
    ----------
    document : str
    folder : str
        See `info_location`.
    settings : dict
    profile : str
        A shipped profile's name, or a file.
    seconds : float
    megabytes : int
    measure : bool
        Whether to measure what has no current info file.
    patience : float
        Seconds to wait for the folder.
    control : RunControl, optional

    Returns
    -------
    dict
        ``verdicts`` (see `document_verdicts`) or None where there are none; ``before``, those of the
        info file until now, or None; ``current``, whether that was current; ``failures``, sentences;
        ``no_part``, why there is none, else empty.

    Raises
    ------
    ThinPartError
        For a profile that cannot be used.
    KeyboardInterrupt
        When `control` was asked to stop.
    """
    settings, profile = AnalysisSettings(**settings), load_profile(profile).content
    answer = {"verdicts": None, "before": None, "current": False, "failures": [], "no_part": ""}
    info_file = os.fspath(info_location(document, folder))
    try:
        stored = reach(folder, lambda: stored_info(info_file), patience)
    except ThinPartError as error:
        # The verdict is worth having, although it cannot be kept.
        stored, info_file = None, None
        answer["failures"].append(str(error))
    if stored is not None:
        answer["before"] = document_verdicts(stored["parts"], stored["profile"])
        answer["current"] = is_current(stored, document, settings.content(), profile, info_file)
    if answer["current"]:
        answer["verdicts"] = answer["before"]
        answer["failures"] += [each["message"] for each in stored.get("failures", ())]
    elif measure:
        task = FileTask(document, info_file, settings, profile, thumbnails=True)
        outcome, = analyse_files([task], Limits(seconds, megabytes), control)
        _take(answer, outcome, profile)
    return answer


def _take(answer, outcome, profile):
    error = outcome.get("error")
    if error is None:
        answer["verdicts"] = document_verdicts(outcome["parts"], profile)
        answer["failures"] += [each["message"] for each in outcome["failures"]]
    elif error["kind"] in _NO_PART:
        answer["no_part"] = error["message"]
    else:
        answer["failures"].append(error["message"])


def main():
    """Do the one job."""
    lines, control = JsonLines(), RunControl()
    job = lines.incoming.get()
    if job is None:
        lines.end()
    threading.Thread(target=_stop_when_left, args=(lines, control), daemon=True).start()
    try:
        lines.say(**classify_saved(**job, control=control))
    except ThinPartError as error:
        lines.say(failure=str(error))
    except ModuleNotFoundError as error:
        lines.say(failure=f"The Python module {error.name} is missing: install it to have documents "
                          f"classified automatically (Debian: python3-{error.name}).")
    except KeyboardInterrupt:
        pass  # nobody waits for an answer any more
    lines.end()


def _stop_when_left(lines, control):
    while lines.incoming.get() is not None:
        pass
    control.stop()
    time.sleep(_STOPPING)
    os._exit(1)


if __name__ == "__main__":
    main()
