# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure one part and draw its thickness map, in a worker process: the file may be anybody's."""

import base64
from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional

from ...core.analysis_settings import RAY, AnalysisSettings
from ...core.errors import ThinPartError
from ...core.judging.criteria import profile_from
from ...core.kinds.compound_kinds import Record
from ...core.kinds.value_kinds import Number, OrNull, Text
from ...core.message import message
from ...core.record.thinnest_sentence import thinnest_kind
from ...core.rendering.map_picture import MapLook, map_picture
from ...storage.exchange.map_export import MAP_FORMATS
from ...storage.info.info_definition import SOURCE
from ...storage.png import png_bytes
from ..analysis.analyse_part import analyse_part
from ..analysis.measured_source import check_source, source_of
from ..workers.preparation import require_preparation
from ..workers.task_run import run_tasks

PNG = ".png"

_SAID = {"label": Text(), "thinnest": OrNull(Number(0.0)), "thinnest_at": Text(), "low": Number(), "high": Number()}

_LONGEST = 1 << 30
"""Greatest number of characters of a file in base64."""


@dataclass(frozen=True)
class MapTask:
    """One part whose map is wanted.

    Attributes
    ----------
    file : str
    part : str or None
        Its name or label; None for the only one.
    profile : dict
        Content of the profile.
    formats : tuple of str
        Of `core.kinds.file_marks.MAPS`.
    look : MapLook
    measure : str
        One of `SHOWN_MEASURES`.
    analysis : AnalysisSettings
    """

    file: str
    part: Optional[str]
    profile: dict
    formats: tuple
    look: MapLook = field(default_factory=MapLook)
    measure: str = RAY
    analysis: AnalysisSettings = field(default_factory=AnalysisSettings)


def map_of_part(task, limits, control=None):
    """Make the map of a part.

    Returns a dict: ``file``, ``label``; ``thinnest``, mm, the wall that the record names, or None; ``low`` and ``high``, mm,
    of the colours; and ``contents``: bytes by format. Or ``file`` and ``error`` with ``kind`` and ``message``. Raises
    ThinPartError if no worker can be started; Cancelled when `control` was asked to stop.

    Parameters
    ----------
    task : MapTask
    limits : Limits
    control : RunControl, optional
    """
    done, = run_tasks([task], _drawn, _map, limits, control=control)
    return done.failure or {"file": task.file, **done.result}


def _map(task, answer):
    """The map that an answer holds."""
    contents = Record({ending: Text(_LONGEST, "[A-Za-z0-9+/=]*") for ending in task.formats})
    fault = Record({**_SAID, "source": SOURCE, "contents": contents}).fault(answer, "")
    if fault:
        raise ValueError(fault)
    try:
        files = {ending: base64.b64decode(answer["contents"][ending], validate=True) for ending in task.formats}
    except ValueError:  # of base64
        raise ValueError(message("it is damaged or incomplete")) from None
    check_source(answer["source"], task.file)
    return {**{key: answer[key] for key in _SAID}, "contents": files}


def _drawn(task):
    """Runs in a worker."""
    require_preparation()
    return {"source": source_of(task.file), **_contents(task)}


def _contents(task):
    # Imported here since the adapter loads FreeCAD.
    from ...core.maps.mapped_part import MappedPart
    from ...core.maps.thickness_map import thickness_map
    from ...freecad_adapter.reading.part_files import read_parts

    part = _chosen(read_parts(task.file), task)
    measurement, record = analyse_part(part, task.analysis, profile_from(task.profile))
    mapped = MappedPart(record, thickness_map(measurement, by=task.measure))
    scale = task.look.scale(mapped)
    contents = {ending: _png(map_picture(mapped, task.look)) if ending == PNG
                else MAP_FORMATS[ending].content([mapped], scale.of_corners) for ending in task.formats}
    thinnest = record["descriptors"]["thickness_mm"]["min"]
    return {"label": part.label, "thinnest": thinnest, "thinnest_at": thinnest_kind(record),
            "low": scale.low, "high": scale.high,
            "contents": {ending: base64.b64encode(content).decode() for ending, content in contents.items()}}


def _png(pixels):
    height, width, _ = pixels.shape
    return png_bytes(pixels.tobytes(), width, height)


def _chosen(content, task):
    """The part that is wanted, of those that were read."""
    name, chosen = Path(task.file).name, [part for part in content.parts if task.part in (None, part.name, part.label)]
    if len(chosen) == 1:
        return chosen[0]
    for broken in content.broken:
        each = broken.failure()
        if not content.parts or task.part in (each["part"], each["label"]):
            raise ThinPartError(each["message"], each["kind"])
    if not chosen:
        raise ThinPartError(message("There is no part {part} in {file}: it has {parts}.", part=task.part, file=name,
                                    parts=_names(content.parts)), "usage")
    raise ThinPartError(message("{file} has {count} parts: name one after --part, of {parts}.", file=name,
                                count=len(chosen), parts=_names(chosen)), "usage")


def _names(parts):
    """The first names of parts; labels may be the same, names are not."""
    shown = ", ".join(part.label if part.label == part.name else f"{part.label} ({part.name})" for part in parts[:8])
    return shown + (" \u2026" if len(parts) > 8 else "")
