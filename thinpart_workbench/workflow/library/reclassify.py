# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judge stored parts by another profile from their info files alone, without geometry or FreeCAD."""

import json
import math
import os
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional

from ...core.analysis_limits import Limits
from ...core.errors import ThinPartError
from ...core.judging.classification import classify
from ...core.judging.criteria import Profile, profile_from
from ...core.judging.older_record import is_to_be_measured
from ...core.message import message
from ...core.problem import UNEXPECTED
from ...core.record.part_record import descriptors_of, judge_again, verdict
from ...core.record.record_types import VerdictRecord
from ...core.risk.mesh_risk import judged_risk
from ...core.run_control import RunControl
from ...storage.info.info_file import change_info, read_info
from ..workers.task_run import task_workers

FILES_AT_ONCE = 64
"""Info files per batch that a worker process receives."""

_BATCHES_AHEAD = 16
"""Per worker. Results are held until all earlier ones are there; this limit bounds their number."""

_SECONDS = 300.0
"""Time limit for a batch, and for a file that is judged alone; a network share may have stopped answering."""

_MEGABYTES = 4096
"""Address space of a worker: enough for the largest info file, `storage/info/info_file.LARGEST`."""

_ATTEMPTS = 3
"""A file is judged in its batch, then alone, and once more if that crashed: somebody may have killed the worker."""


class Verdict(NamedTuple):
    """A part with its verdicts before and after reclassification."""

    name: str
    label: str
    before: VerdictRecord
    after: VerdictRecord
    measure_again: bool
    """Whether it is ``unknown`` now because an earlier version did not measure what decides."""

    @property
    def differs(self):
        """Whether the verdict has changed; rounding of the stored margin does not count."""
        before: dict[str, Any] = dict(self.before)
        after: dict[str, Any] = dict(self.after)
        margins = before.pop("margin"), after.pop("margin")
        if before != after or None in margins:
            return before != after or margins != (None, None)
        return not math.isclose(*margins, rel_tol=1e-6, abs_tol=1e-9)


class ReclassifiedFile(NamedTuple):
    """An info file: on success a `Verdict` per part, no error, and whether its profile or verdicts differ from before;
    on failure no parts, an error message, and False."""

    info_file: str
    document: str
    parts: list[Verdict]
    error: Optional[str]
    differs: bool


def reclassify_file(info_file, profile_content, write=False):
    """Judge the parts of one info file. Returns a ReclassifiedFile.

    Parameters
    ----------
    info_file : str
    profile_content : dict
    write : bool
        Whether to update the info file; measured values are not changed.
    """
    profile, verdicts, differs = _profile(profile_content), [], False

    def judge(content):
        nonlocal differs
        for part in content["parts"]:
            verdicts.append(_verdict_of(part, profile, write))
        differs = content["profile"] != profile_content or any(each.differs for each in verdicts)
        content["profile"] = profile_content
        return differs

    try:
        if write:
            content = change_info(info_file, judge)
        else:
            content = read_info(info_file)
            judge(content)
        return ReclassifiedFile(info_file, described_document(info_file, content), verdicts, None, differs)
    except ThinPartError as error:
        return _failure(info_file, str(error))
    except MemoryError:
        return _failure(info_file, message("The info file {info_file} needs more memory than the limit allows.",
                                           info_file=os.path.basename(info_file)))


def reclassify_files(info_files, profile_content, write=False, jobs=1, control=None):
    """Judge the parts of many info files.

    Yields a ReclassifiedFile: in the order given. Raises Cancelled when `control` was asked to stop. Each info file is
    either unchanged or updated, never partly written. Raises ThinPartError if no worker can be started, or there is no space
    for temporary files.

    Parameters
    ----------
    info_files : list of str
        Each once.
    profile_content : dict
    write : bool
    jobs : int
        Processes that read and judge. What changes is written by this one, which judges it again while the folder is locked.
    control : RunControl, optional
        Stops the run, also while it is waiting.
    """
    control = control or RunControl()
    if jobs <= 1 or len(info_files) <= FILES_AT_ONCE:
        for info_file in info_files:
            control.check()
            yield reclassify_file(info_file, profile_content, write)
        return
    batches = [Batch(info_files[start:start + FILES_AT_ONCE], profile_content)
               for start in range(0, len(info_files), FILES_AT_ONCE)]
    limits = Limits(_SECONDS, _MEGABYTES, min(jobs, len(batches)))
    with task_workers(limits.jobs, _judged, _checked, limits) as run:
        ahead = _BATCHES_AHEAD * limits.jobs
        for first in range(0, len(batches), ahead):
            for file in _in_order(batches[first:first + ahead], run, control):
                control.check()
                yield reclassify_file(file.info_file, profile_content, write) if write and file.differs else file


@dataclass(frozen=True)
class Batch:
    """Info files that a worker judges together. Contains only plain values, so that it can be pickled."""

    info_files: list
    profile: dict

    @property
    def file(self):
        """The file that failures name: they count only where it is alone."""
        return self.info_files[0]


def _in_order(batches, run, control):
    """The results of batches in the order of their files. The files of one that failed are judged one by one, so that a file
    which kills its reader is one failure."""
    info_files = [info_file for batch in batches for info_file in batch.info_files]
    results, position = {}, 0
    for attempt in range(1, _ATTEMPTS + 1):
        again = []
        for done in run(batches, control):
            alone = len(done.task.info_files) == 1
            if done.failure is None:
                results.update(done.result)
            elif attempt < _ATTEMPTS and (not alone or done.failure["error"]["kind"] == "crash"):
                again += [Batch([info_file], done.task.profile) for info_file in done.task.info_files]
            else:
                results[done.task.file] = _failure(done.task.file, done.failure["error"]["message"])
            while position < len(info_files) and info_files[position] in results:
                yield results.pop(info_files[position])
                position += 1
        batches = again


def _judged(batch):
    """In a worker: the results of a batch, as JSON values."""
    return [list(reclassify_file(info_file, batch.profile)) for info_file in batch.info_files]


def _checked(batch, answer):
    """The results that a worker returned: dict of str to ReclassifiedFile."""
    if len(answer) != len(batch.info_files):
        raise ValueError(UNEXPECTED)
    return {info_file: ReclassifiedFile(info_file, document, [Verdict(*part) for part in parts], error, differs)
            for info_file, (_, document, parts, error, differs) in zip(batch.info_files, answer)}


def _failure(info_file, sentence):
    return ReclassifiedFile(info_file, info_file, [], sentence, False)


def _verdict_of(part, profile, write):
    before = VerdictRecord(category=part["category"], criteria=part["criteria"], margin=part["margin"],
                           borderline=part["borderline"])
    descriptors = descriptors_of(part)
    classification = classify(descriptors, profile)
    if write:
        judge_again(part, classification, None if descriptors.hazards is None else judged_risk(descriptors))
    return Verdict(part["name"], part["label"], before, verdict(classification), is_to_be_measured(part, classification))


_profiles: dict[str, Profile] = {}


def _profile(content):
    """The profile, parsed once per process: a library may have a hundred thousand parts."""
    key = json.dumps(content)
    if key not in _profiles:
        _profiles[key] = profile_from(content)
    return _profiles[key]


def described_document(info_file, content):
    """Path of the document that an info file with some content, dict, is about: str."""
    source = content["source"]
    folder = os.path.join(os.path.dirname(os.path.abspath(info_file)), source.get("folder", ""))
    return os.path.normpath(os.path.join(folder, source["file"]))
