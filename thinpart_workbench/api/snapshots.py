# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the parts of an open document from a snapshot of it, in another process than FreeCAD's."""

import os
import time
from collections import deque
from dataclasses import dataclass, replace
from functools import partial
from typing import Optional

from ..core.analysis_settings import AnalysisSettings
from ..core.judging.criteria import profile_from
from ..core.maps.first_map import first_map
from ..core.maps.mapped_part import MappedPart
from ..core.maps.thickness_map import thickness_map
from ..core.message import message
from ..core.record.record_types import PartRecord
from ..core.record.thin_faces import limit_in_millimetres
from ..core.walls.face_thickness import thin_shares
from ..freecad_adapter.features.face_features import face_features
from ..freecad_adapter.objects.snapshot import read_history, read_snapshot
from ..storage.map_file import write_maps
from ..system.exit_cause import is_out_of_memory
from ..workflow.analysis.analyse_part import analyse_part
from .classified_parts import PartFailure


@dataclass(frozen=True)
class SnapshotPart:
    """A measured part of a snapshot.

    Attributes
    ----------
    record : PartRecord
    thin_limit_mm : float or None
        The limit of the snapshot for thin faces; None if that of the verdict holds.
    thin_shares : list of float, or None
        By that limit, the thin share of each face.
    """

    record: PartRecord
    thin_limit_mm: Optional[float] = None
    thin_shares: Optional[list[float]] = None


@dataclass(frozen=True)
class SnapshotMap:
    """The thickness map of a part that was measured just before.

    Attributes
    ----------
    part : str
        Name of the part.
    file : str
        In the snapshot's folder; see `map_file`.
    """

    part: str
    file: str


@dataclass(frozen=True)
class FirstMap:
    """A coarse thickness map of a part that is yet to be measured; its record has nothing but names.

    Attributes
    ----------
    part, file : str
        See `SnapshotMap`.
    """

    part: str
    file: str


FIRST_MAPS_SECONDS = 6.0
"""How long first maps are made before measuring begins. What is left in an assembly of very many parts follows between the
parts that are measured, for as long as each of them took."""


def measure_snapshot(folder, megabytes, report=None, wait_for_history=None, pages=None):
    """Measure and judge the parts of a snapshot.

    Parameters
    ----------
    folder : str
        See `freecad_adapter.objects.snapshot.write_snapshot`.
    megabytes : int
        Limit of the address space of this process, which the sentence about a lack of memory names.
    report : callable, optional
        Called with the name of a part, the stage (``mesh``, ``measure``, ``map``) and the fraction of it that is done;
        may raise `Cancelled` to stop.
    wait_for_history : callable, optional
        Called before the feature history of the faces is read, which the window may still be writing.
    pages : OpenDocumentReport, optional
        Gets every part and every failure, instead of the maps being written.

    Yields
    ------
    SnapshotPart, SnapshotMap, FirstMap or PartFailure
        In the order of the snapshot. A map follows its part if the snapshot asks for maps, by the measure that it names.
        A part that fails does not affect the others. If the snapshot asks for first maps, those of the largest parts come
        before all else, and the others between the parts; see `FIRST_MAPS_SECONDS`.

    Raises
    ------
    ThinPartError
        If the profile is unusable. An unreadable snapshot raises whatever its reader does.

    Examples
    --------
    >>> [found.record["category"] for found in measure_snapshot(snapshot, 4096)]
    ['thin']
    """
    job, read = read_snapshot(folder)
    settings, profile = AnalysisSettings(**job["settings"]), profile_from(job["profile"])
    first_maps = _FirstMaps(job if job["first_maps"] and pages is None else None, read, folder)
    yield from first_maps.within(FIRST_MAPS_SECONDS)
    for entry in job["parts"]:
        begun = time.perf_counter()
        report_part = _part_report(report, entry["name"])
        try:
            started = time.perf_counter()
            part = read(entry)
            seconds = time.perf_counter() - started
            found, measurement = _measured(part, seconds, settings, profile, job["thin_limit"], report_part)
            yield found
            if pages is not None:
                pages.add(part, measurement, found.record, _features(part, entry, folder, wait_for_history))
            elif job["maps"]:
                part_map = thickness_map(measurement, partial(report_part, "map"), job["maps"], has_balls=True)
                mapped = MappedPart(found.record, part_map, _features(part, entry, folder, wait_for_history))
                yield SnapshotMap(part.name, _write_map(mapped, entry, folder))
        except Exception as error:  # a failed part does not affect the others
            failure = _failure(error, entry, megabytes)
            if pages is not None:
                pages.add_failure(failure)
            yield failure
        yield from first_maps.within(time.perf_counter() - begun)


class _FirstMaps:
    """Makes the coarse maps of the parts of a job, of those first that take most of the view; of no job, none."""

    def __init__(self, job, read, folder):
        self._measure, self._read, self._folder = job and job["maps"], read, folder
        self._waiting = deque(sorted(
            job["parts"], key=lambda entry: -entry["instances"] * entry["diagonal"] ** 2) if job else ())

    def within(self, seconds):
        """Yield a FirstMap of every part that has one, of as many as the time allows."""
        end = time.perf_counter() + seconds
        while self._waiting and time.perf_counter() < end:
            entry = self._waiting.popleft()
            try:
                part = self._read(entry)
                found = first_map(part.coarse_mesh(), self._measure)
            except Exception:  # measuring the part reports what is wrong with it
                continue
            if found is not None:
                path = os.path.join(self._folder, f"first-{entry['file']}.npz")
                write_maps(path, [MappedPart({"name": part.name, "label": part.label}, found)])
                yield FirstMap(part.name, path)


def _part_report(report, name):
    def report_part(stage, fraction):
        if report is not None:
            report(name, stage, fraction)

    return report_part


def _measured(part, seconds, settings, profile, thin_limit, report):
    measurement, record = analyse_part(part, settings, profile, report)
    record["seconds"] = {
        key: round(value, 4) for key, value in {"read": seconds, **record["seconds"]}.items()
    }
    if thin_limit is None:
        return SnapshotPart(record), measurement
    limit = limit_in_millimetres(thin_limit, record["descriptors"]["diagonal_mm"])
    return SnapshotPart(record, limit, thin_shares(measurement.field, limit).tolist()), measurement


def _write_map(mapped, entry, folder):
    path = os.path.join(folder, f"map-{entry['file']}.npz")
    write_maps(path, [mapped])
    return path


def _features(part, entry, folder, wait_for_history):
    if not entry.get("history"):
        return []
    if wait_for_history is not None:
        wait_for_history()
    return face_features(part.shape, read_history(folder, entry))


def _failure(error, entry, megabytes):
    failure = PartFailure.of_exception(error, entry["name"], entry["label"])
    if is_out_of_memory(error):
        return replace(failure, message=message(
            "{part} needs more than {megabytes} MB of memory: raise the limit in the preferences.",
            part=entry["label"], megabytes=megabytes))
    return failure
