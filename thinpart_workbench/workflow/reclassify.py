"""Judging stored parts by another profile, from their info files alone: no geometry, no FreeCAD."""

import json
import math
import os
import sys
from collections import namedtuple
from concurrent.futures import ProcessPoolExecutor
from itertools import islice

from ..core.classification import classify
from ..core.criteria import profile_from
from ..core.errors import ThinPartError
from ..core.part_record import descriptors_of, judge_again, verdict
from ..storage.info_file import change_info, read_info
from ..system.python_process import is_freecadcmd

FILES_AT_ONCE = 64
"""Info files that are handed to a process together."""

Verdict = namedtuple("Verdict", "name label before after")
"""A part; ``before`` and ``after`` are dict with ``category``, ``criteria``, ``margin``, ``borderline``."""

ReclassifiedFile = namedtuple("ReclassifiedFile", "info_file document parts error differs")
"""An info file: a `Verdict` per part, None, and whether what it says of profile or verdicts is another now;
or no parts, one sentence, and False."""

_TOLD = ("category", "criteria", "margin", "borderline")
"""What `part_record.verdict` gives."""


def is_another(part):
    """Whether a `Verdict` is another one; a margin that was rounded when it was stored is the same."""
    before, after = dict(part.before), dict(part.after)
    margins = before.pop("margin"), after.pop("margin")
    if before != after or None in margins:
        return before != after or margins != (None, None)
    return not math.isclose(*margins, rel_tol=1e-6, abs_tol=1e-9)


def reclassify_file(info_file, profile_content, write=False):
    """Judge the parts of one info file.

    Parameters
    ----------
    info_file : str
    profile_content : dict
    write : bool
        Whether the info file is updated; what was measured stays as it is.

    Returns
    -------
    ReclassifiedFile
    """
    profile, verdicts, differs = _profile(profile_content), [], False

    def judge(content):
        nonlocal differs
        for part in content["parts"]:
            verdicts.append(_judged(part, profile, write))
        differs = content["profile"] != profile_content or any(map(is_another, verdicts))
        content["profile"] = profile_content
        return differs

    try:
        if write:
            content = change_info(info_file, judge)
        else:
            content = read_info(info_file)
            judge(content)
        return ReclassifiedFile(info_file, _document(info_file, content), verdicts, None, differs)
    except ThinPartError as error:
        return ReclassifiedFile(info_file, info_file, [], str(error), False)
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        return ReclassifiedFile(
            info_file, info_file, [], f"The info file {os.path.basename(info_file)} is damaged "
            f"({type(error).__name__}: {error}): classify its document again.", False)


def reclassify_files(info_files, profile_content, write=False, jobs=1):
    """Judge the parts of many info files.

    Parameters
    ----------
    info_files : list of str
    profile_content : dict
    write : bool
    jobs : int
        Processes.

    Yields
    ------
    ReclassifiedFile
        In the order given.
    """
    batches = [info_files[start:start + FILES_AT_ONCE] for start in range(0, len(info_files), FILES_AT_ONCE)]
    # multiprocessing starts processes with a Python alone.
    if jobs == 1 or len(batches) <= 1 or is_freecadcmd(sys.executable):
        for batch in batches:
            yield from _reclassify_batch(batch, profile_content, write)
        return
    with ProcessPoolExecutor(min(jobs, len(batches))) as pool:
        waiting, rest = [], iter(batches)
        try:
            while True:
                for batch in islice(rest, 4 * jobs - len(waiting)):
                    waiting.append(pool.submit(_reclassify_batch, batch, profile_content, write))
                if not waiting:
                    break
                yield from waiting.pop(0).result()
        except BaseException:
            for each in waiting:
                each.cancel()
            raise


def _reclassify_batch(info_files, profile_content, write):
    return [reclassify_file(each, profile_content, write) for each in info_files]


def _judged(part, profile, write):
    before = {key: part[key] for key in _TOLD}
    classification = classify(descriptors_of(part), profile)
    if write:
        judge_again(part, classification)
    return Verdict(part["name"], part["label"], before, verdict(classification))


_profiles = {}


def _profile(content):
    """The profile, read once per process: a library has one and a hundred thousand parts."""
    key = json.dumps(content)
    if key not in _profiles:
        _profiles[key] = profile_from(content)
    return _profiles[key]


def _document(info_file, content):
    source = content["source"]
    folder = os.path.join(os.path.dirname(os.path.abspath(info_file)), source.get("folder", ""))
    return os.path.normpath(os.path.join(folder, source["file"]))
