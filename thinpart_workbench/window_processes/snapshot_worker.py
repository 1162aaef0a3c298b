# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that measures a snapshot: ``python -m thinpart_workbench.window_processes.snapshot_worker``.

It loads the modules for measuring and then waits for one line on standard input: ``{"folder", "megabytes"}``, the
folder of the snapshot and the limit of the address space; for a report also ``report``, the parameters of
`OpenDocumentReport` besides those of the snapshot: then it writes the report instead of maps. It prints one JSON object
per line:
``{"progress": {"part", "stage", "fraction"}}``, ``{"record": ...}``,
``{"failure": {"part", "label", "kind", "message"}}`` and at last ``{"done": true}``, or
``{"failure": {"kind", "message"}}`` if it cannot measure any of them.
If faces are to be shown as thin by another limit than that of the verdict, ``thin_limit_mm`` and ``thin_shares`` of
the faces accompany the record. If the job asks for maps, ``{"map": {"part", "file"}}`` follows the record: see
`map_file`. If it also asks for first maps, ``{"first_map": {"part", "file"}}`` comes for the parts that have one: before
all else for the largest, between the others for the rest. The feature history of the faces is read after the end of
standard input, since until then the window is still writing it. Lines have `with_messages`.
The parent stops the process by killing it; it writes nothing but these lines and the maps. The shapes may come from
an untrusted file, so from the job on the process can only write into the snapshot's folder, if the system can
restrict that.
"""

import os
import time
from contextlib import ExitStack, closing

from ..api.classified_parts import PartFailure
from ..system.confinement import confine_running_process
from ..system.process_limits import limit_memory
from .json_lines import JsonLines

PATIENCE = 600.0
"""Seconds without a job after which the process ends; loading the modules again takes less than one."""

_PROGRESS_SECONDS = 0.1
"""Between two lines of progress of one stage: for each, a window with OpenGL in software draws all of itself anew."""


def main():
    """Measure one snapshot."""
    parent = JsonLines(in_thread=False)
    with parent.reporting_failures():
        snapshots = _load()
        request = parent.receive(PATIENCE)
        if request is not None:
            _measure(request, snapshots, parent)
    parent.end()


def _measure(request, snapshots, parent):
    folder, megabytes = request["folder"], request["megabytes"]
    os.chdir(folder)
    with ExitStack() as stack:
        pages = None
        if "report" in request:
            pages = stack.enter_context(closing(_new_report(folder, request["report"])))
        confine_running_process(folder, *([request["report"]["output"]] if pages else []))
        limit_memory(megabytes * 1024 * 1024)
        _send_results(folder, megabytes, snapshots, parent, pages)
        if pages:
            pages.finish()
    parent.send(done=True)


def _new_report(folder, wanted):
    # Imported here: a report needs Jinja2, a measurement does not.
    from ..api.report.report_folder import OpenDocumentReport
    from ..api.snapshots import read_snapshot

    job, _ = read_snapshot(folder)
    return OpenDocumentReport(job["settings"], job["profile"], **wanted)


def _send_results(folder, megabytes, snapshots, parent, pages):
    send = parent.send
    told, due = None, 0.0

    def report(part, stage, fraction):
        nonlocal told, due
        if (part, stage) != told or time.monotonic() >= due:
            told, due = (part, stage), time.monotonic() + _PROGRESS_SECONDS
            send(progress={"part": part, "stage": stage, "fraction": round(fraction, 4)})

    # The window closes the pipe once it has written the feature history, which it does while idle.
    for found in snapshots.measure_snapshot(folder, megabytes, report, parent.receive, pages):
        if isinstance(found, PartFailure):
            send(failure={"part": found.part, "label": found.label, "kind": found.kind, "message": found.message})
        elif isinstance(found, snapshots.SnapshotMap):
            send(map=vars(found))
        elif isinstance(found, snapshots.FirstMap):
            send(first_map=vars(found))
        elif found.thin_limit_mm is None:
            send(record=found.record)
        else:
            send(**vars(found))


def _load():
    """Import what every snapshot needs; returns the module that measures one."""
    from ..freecad_adapter.bootstrap import load_meshing

    load_meshing()
    from ..api import snapshots

    return snapshots


if __name__ == "__main__":
    main()
