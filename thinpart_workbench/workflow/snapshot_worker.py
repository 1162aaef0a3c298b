"""The process that measures a snapshot: ``python -m thinpart_workbench.workflow.snapshot_worker``.

It loads what measuring takes and then waits for one line on standard input: ``{"folder", "megabytes"}``, the
snapshot and the address space that may be used. It prints one JSON object per line:
``{"progress": {"part", "stage", "fraction"}}``, ``{"record": ...}``,
``{"failure": {"part", "label", "kind", "message"}}`` and at last ``{"done": true}``.
Where walls are to be shown as thin under another limit than the verdict's, ``thin_limit_mm`` and
``thin_shares`` of the faces come beside the record. Where the job asks for maps, ``{"map": {"part", "file"}}``
comes after the record: see `map_file`. What made each face is read once standard input has ended, for until
then it is still being written.
Whoever started it stops it by killing it; it writes nothing but these lines and the maps.
"""

import json
import os
import time

from ..core.analysis_settings import AnalysisSettings
from ..core.criteria import profile_from
from ..core.errors import ThinPartError
from ..system.pipe_input import is_readable
from ..system.process_limits import limit_memory

PATIENCE = 600.0
"""Seconds without a job after which it ends; loading everything anew takes less than one."""


def main():
    """Measure one snapshot."""
    lines = _private_stdout()
    read_snapshot = _load()
    asked = _first_line()
    if not asked:
        return
    folder, megabytes = asked["folder"], asked["megabytes"]
    os.chdir(folder)
    limit_memory(megabytes * 1024 * 1024)

    def say(**line):
        lines.write(json.dumps(line, ensure_ascii=False) + "\n")
        lines.flush()

    job, read = read_snapshot(folder)
    settings = AnalysisSettings(**job["settings"])
    profile = profile_from(job["profile"])
    for entry in job["parts"]:
        try:
            _analyse(entry, read, settings, profile, job, folder, say)
        except ThinPartError as error:
            say(failure=_failure(entry, error.kind, str(error)))
        except MemoryError:
            say(failure=_failure(
                entry, "memory", f"{entry['label']} needs more than {megabytes} MB of memory: "
                                 "raise the limit in the preferences."))
    say(done=True)


def _load():
    """Load what every snapshot needs, and return what reads one."""
    from ..freecad_adapter.bootstrap import load_meshing

    load_meshing()
    from ..core import thickness_map  # noqa: F401
    from ..freecad_adapter.snapshot import read_snapshot
    from . import analyse_part  # noqa: F401

    return read_snapshot


def _first_line():
    """The job; None where nobody has one. What comes after it stays in the pipe."""
    line = b""
    while not line.endswith(b"\n"):
        if not is_readable(0, PATIENCE):
            return None
        byte = os.read(0, 1)
        if not byte:
            return None
        line += byte
    return json.loads(line)


def _failure(entry, kind, message):
    return {"part": entry["name"], "label": entry["label"], "kind": kind, "message": message}


def _analyse(entry, read, settings, profile, job, folder, say):
    from .analyse_part import analyse_part

    measured = []

    def report(stage, fraction):
        say(progress={"part": entry["name"], "stage": stage, "fraction": round(fraction, 4)})

    def show(measurement, _record):
        measured.append(measurement)

    started = time.perf_counter()
    part = read(entry)
    seconds = time.perf_counter() - started
    record = analyse_part(part, settings, profile, report, show)
    record["seconds"] = {
        key: round(value, 4) for key, value in {"read": seconds, **record["seconds"]}.items()
    }
    say(record=record, **_thin_faces(measured[0].field, record, job["thin_limit"]))
    if job["maps"]:
        say(map={"part": part.name, "file": _write_map(part, measured[0], record, entry, folder, report)})


def _thin_faces(field, record, thin_limit):
    """What is said beside a record of faces that are shown as thin under a limit of the user's own."""
    from ..core.face_thickness import thin_shares
    from ..core.thin_faces import limit_in_millimetres

    if thin_limit is None:
        return {}
    limit = limit_in_millimetres(thin_limit, record["descriptors"]["diagonal_mm"])
    return {"thin_limit_mm": limit, "thin_shares": thin_shares(field, limit).tolist()}


def _write_map(part, measurement, record, entry, folder, report):
    from ..core.mapped_part import MappedPart
    from ..core.thickness_map import thickness_map
    from ..storage.map_file import write_maps

    shown = thickness_map(measurement, lambda fraction: report("map", fraction))
    path = os.path.join(folder, f"map-{entry['file']}.npz")
    write_maps(path, [MappedPart(record, shown, _features(part, entry, folder))])
    return path


def _features(part, entry, folder):
    from ..freecad_adapter.face_features import face_features
    from ..freecad_adapter.snapshot import read_history

    if not entry.get("history"):
        return []
    while os.read(0, 4096):
        pass  # the window writes the shapes between other things
    return face_features(part.shape, read_history(folder, entry))


def _private_stdout():
    """The pipe to the parent; what FreeCAD prints to stdout goes to stderr instead."""
    private = os.dup(1)
    os.dup2(2, 1)
    return os.fdopen(private, "w", encoding="utf-8", errors="surrogateescape")


if __name__ == "__main__":
    main()
