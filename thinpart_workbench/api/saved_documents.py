# SPDX-License-Identifier: LGPL-2.1-or-later
"""Classify a document from its file, once its measurements are no longer current, and tell what has changed."""

import os
from dataclasses import dataclass, field
from typing import Optional

from ..core.analysis_limits import Limits
from ..core.analysis_settings import DEFAULT_PROFILE, given_settings
from ..core.errors import ThinPartError
from ..core.judging.criteria import given_profile
from ..core.judging.older_record import is_enough
from ..core.message import message
from ..storage.info.info_file import is_current, stored_info
from ..storage.info.info_location import PATIENCE, call_in_folder, info_location
from ..workflow.analysis.analyse_file import FileTask
from ..workflow.workers.worker_pool import analyse_files
from .document_verdicts import PartVerdict, document_verdicts

_NO_PART_KINDS = ("empty", "no_solid")
"""Kinds of failures of documents without parts, which are not reported as failures."""


@dataclass
class SavedVerdicts:
    """The verdicts on the parts of a saved document.

    Attributes
    ----------
    verdicts : dict of str to PartVerdict, or None
        See `document_verdicts`; None if there are none.
    before : dict of str to PartVerdict, or None
        Those of the previous info file.
    current : bool
        Whether that info file was current, so that nothing had to be measured.
    older : bool
        Whether an earlier version wrote that info file and did not measure what decides, so that its parts have to be
        measured again.
    failures : list of str
        Sentences about parts that could not be classified, or why nothing could be stored.
    no_part : str
        Why the document has no part, else empty.
    """

    verdicts: Optional[dict[str, PartVerdict]] = None
    before: Optional[dict[str, PartVerdict]] = None
    current: bool = False
    older: bool = False
    failures: list[str] = field(default_factory=list)
    no_part: str = ""


def classify_saved(document, profile=DEFAULT_PROFILE, settings=None, *, folder="", seconds=Limits.seconds,
                   megabytes=Limits.megabytes, measure=True, patience=PATIENCE, control=None):
    """Classify a document and store the result, or take the verdicts from an info file that is current:
    SavedVerdicts.

    Parameters
    ----------
    document : str
        Absolute path.
    profile, settings, seconds, megabytes
        See `classify`; the settings may also be a dict.
    folder : str, optional
        See `info_location`.
    measure : bool, optional
        Whether to measure a document without a current info file.
    patience : float, optional
        Seconds to wait for the folder, which may be on another computer.
    control : RunControl, optional

    Raises
    ------
    ThinPartError
        For an unusable profile, kind ``unsupported`` where a Python module is missing.
    Cancelled
        When `control` was asked to stop.

    Examples
    --------
    >>> found = classify_saved(plate)  # its info file is current
    >>> found.current, [verdict["category"] for verdict in found.verdicts.values()]
    (True, ['thin'])
    """
    profile, settings = given_profile(profile).content, given_settings(settings)
    found = SavedVerdicts()
    info_file = os.fspath(info_location(document, folder))
    try:
        stored = call_in_folder(folder, lambda: stored_info(info_file), patience)
    except ThinPartError as error:
        # The verdict is useful even if it cannot be stored.
        stored, info_file = None, None
        found.failures.append(str(error))
    if stored is not None:
        found.before = document_verdicts(stored["parts"], stored["profile"])
        found.current = is_current(stored, document, settings.content(), profile, info_file)
        found.older = not all(is_enough(part, profile) for part in stored["parts"])
    if stored is not None and found.current:
        found.verdicts = found.before
        found.failures += [failure["message"] for failure in stored.get("failures", ())]
    elif measure:
        task = FileTask(document, info_file, settings, profile, thumbnails=True)
        try:
            outcome, = analyse_files([task], Limits(seconds, megabytes), control)
        except ModuleNotFoundError as error:
            raise ThinPartError(
                message("The Python module {module} is missing: install it to have documents classified "
                        "automatically (Debian: python3-{module}).", module=error.name), "unsupported") from None
        _add_outcome(found, outcome, profile)
    return found


def _add_outcome(found, outcome, profile):
    error = outcome.get("error")
    if error is None:
        found.verdicts = document_verdicts(outcome["parts"], profile)
        found.failures += [failure["message"] for failure in outcome["failures"]]
    elif error["kind"] in _NO_PART_KINDS:
        found.no_part = error["message"]
    else:
        found.failures.append(error["message"])
