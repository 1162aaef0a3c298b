"""Judge stored parts by another profile from their info files alone, without geometry or FreeCAD."""

import json
import math
import os
import signal
import time
from collections import deque
from concurrent.futures import TimeoutError as TaskTimeout
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, Optional

from ...core.errors import ThinPartError
from ...core.judging.classification import classify
from ...core.judging.criteria import Profile, profile_from
from ...core.message import message
from ...core.problem import problem_of
from ...core.record.part_record import descriptors_of, judge_again, verdict
from ...core.record.record_types import VerdictRecord
from ...core.run_control import RunControl
from ...storage.info.info_file import change_info, read_info
from ...system.process_limits import crash_quietly, limit_memory
from ..workers.process_pool import ProcessPool
from ..workers.task_run import worker_folder
from ..workers.worker_thread import WorkerDied

FILES_AT_ONCE = 64
"""Info files per batch that a worker process receives."""

_BATCHES_AHEAD = 16
"""Per worker. Results are held until all earlier ones are there; this limit bounds their number."""

_SECONDS = 300.0
"""Time limit for a batch, and for a file that is judged alone; a network share may have stopped answering."""

_MEGABYTES = 4096
"""Address space of a worker: enough for the largest info file, `storage/info/info_file.LARGEST`."""

_MOST_DEATHS = 2
"""Workers that may die with one info file before it counts as failed: somebody may have killed the first."""

_SECONDS_TO_SETTLE = 1.0
"""Seconds to wait for files that are being written when a run is stopped."""


class Verdict(NamedTuple):
    """A part with its verdicts before and after reclassification."""

    name: str
    label: str
    before: VerdictRecord
    after: VerdictRecord

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
    """Judge the parts of one info file.

    Parameters
    ----------
    info_file : str
    profile_content : dict
    write : bool
        Whether to update the info file; measured values are not changed.

    Returns
    -------
    ReclassifiedFile
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

    Parameters
    ----------
    info_files : list of str
    profile_content : dict
    write : bool
    jobs : int
        Processes.
    control : RunControl, optional
        Stops the run, also while it is waiting.

    Yields
    ------
    ReclassifiedFile
        In the order given.

    Raises
    ------
    Cancelled
        When `control` was asked to stop. Each info file is either unchanged or updated, never partly
        written.
    ThinPartError
        If no worker can be started, or there is no space for temporary files.

    Notes
    -----
    Judging is idempotent. So a batch that is lost with its worker is repeated file by file, and a file that kills
    its reader is one failure. Files of such a batch that were already written are reported as read the second
    time: with the new verdict as the previous one.
    """
    control = control or RunControl()
    starts = range(0, len(info_files), FILES_AT_ONCE)
    jobs = min(jobs, len(starts))
    if jobs <= 1:
        for info_file in info_files:
            control.check()
            yield reclassify_file(info_file, profile_content, write)
        return
    with worker_folder() as folder:
        stop = os.path.join(folder, "stop")
        batches = deque(Batch(start, info_files[start:start + FILES_AT_ONCE], profile_content, write, stop)
                        for start in starts)
        workers = ProcessPool(jobs, _SECONDS, folder, _process_batch, _start_worker, (_MEGABYTES,))
        try:
            yield from _in_order(batches, workers, _BATCHES_AHEAD * FILES_AT_ONCE * jobs, control)
        finally:
            if write and workers.busy:
                _wait_for_writes(workers, stop)
            workers.stop()


@dataclass(frozen=True)
class Batch:
    """Info files that a worker judges together. Contains only plain values, so that it can be pickled.

    Attributes
    ----------
    first : int
        Position of its first file among all info files.
    info_files : list of str
    profile : dict
    write : bool
    stop : str
        Path of a file; once it exists, no further info file is started.
    deaths : int
        Workers that have died with it since it has been a single file.
    """

    first: int
    info_files: list
    profile: dict
    write: bool
    stop: str
    deaths: int = 0

    def split(self):
        """The batch as a list of batches of one file each."""
        return [replace(self, first=self.first + position, info_files=[info_file])
                for position, info_file in enumerate(self.info_files)]


def _in_order(pending, workers, ahead, control):
    """Run all batches, and yield the results in the order of the info files.

    Parameters
    ----------
    pending : deque of Batch
    workers : ProcessPool
    ahead : int
        Files that may be started ahead of the one that is yielded next.
    control : RunControl
    """
    results: dict[int, ReclassifiedFile] = {}
    position = 0

    def may_start(batch):
        return batch.first < position + ahead

    for future, batch in workers.run(pending, control, may_start):
        files, retries = _outcome(future, batch)
        pending.extendleft(reversed(retries))
        results.update(enumerate(files, batch.first))
        while position in results:
            control.check()
            yield results.pop(position)
            position += 1


def _wait_for_writes(workers, stop):
    """Let workers finish the files that they are writing, so that no temporary files are left."""
    end = time.monotonic() + _SECONDS_TO_SETTLE
    open(stop, "wb").close()
    while workers.busy and time.monotonic() < end:
        workers.next_finished()


def _outcome(future, batch):
    """The results of a batch, and the batches to run instead if it failed."""
    error = future.exception()
    if error is None:
        return [_from_json(*item) for item in zip(batch.info_files, future.result())], []
    if len(batch.info_files) > 1:
        return [], batch.split()
    if isinstance(error, WorkerDied) and batch.deaths + 1 < _MOST_DEATHS:
        return [], [replace(batch, deaths=batch.deaths + 1)]
    info_file, = batch.info_files
    return [_failure(info_file, _sentence(os.path.basename(info_file), error))], []


def _sentence(name, error):
    if isinstance(error, TaskTimeout):
        return message("The info file {info_file} took longer than {seconds:g} s, the limit for one file.",
                       info_file=name, seconds=_SECONDS)
    if isinstance(error, WorkerDied):
        return message("The info file {info_file} crashed the process that read it.", info_file=name)
    return message("The info file {info_file} could not be judged ({problem}).", info_file=name, problem=problem_of(error))


def _start_worker(megabytes):
    """Initialize a worker: ignore Ctrl-C, which the parent handles, and limit memory."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    limit_memory(megabytes * 1024 * 1024)
    crash_quietly()


def _process_batch(batch):
    """Judge the files of a batch until the run is stopped."""
    results = []
    for info_file in batch.info_files:
        if os.path.exists(batch.stop):
            break
        results.append(_to_json(reclassify_file(info_file, batch.profile, batch.write)))
    return results


def _to_json(file):
    """A `ReclassifiedFile` without its first field, as JSON values."""
    _, document, parts, error, differs = file
    return [document, [list(part) for part in parts], error, differs]


def _from_json(info_file, content):
    document, parts, error, differs = content
    return ReclassifiedFile(info_file, document, [Verdict(*part) for part in parts], error, differs)


def _failure(info_file, sentence):
    return ReclassifiedFile(info_file, info_file, [], sentence, False)


def _verdict_of(part, profile, write):
    before = VerdictRecord(category=part["category"], criteria=part["criteria"], margin=part["margin"],
                           borderline=part["borderline"])
    classification = classify(descriptors_of(part), profile)
    if write:
        judge_again(part, classification)
    return Verdict(part["name"], part["label"], before, verdict(classification))


_profiles: dict[str, Profile] = {}


def _profile(content):
    """The profile, parsed once per process: a library may have a hundred thousand parts."""
    key = json.dumps(content)
    if key not in _profiles:
        _profiles[key] = profile_from(content)
    return _profiles[key]


def described_document(info_file, content):
    """Path of the document that an info file is about: str.

    Parameters
    ----------
    info_file : str
    content : dict
        Of the info file.
    """
    source = content["source"]
    folder = os.path.join(os.path.dirname(os.path.abspath(info_file)), source.get("folder", ""))
    return os.path.normpath(os.path.join(folder, source["file"]))
