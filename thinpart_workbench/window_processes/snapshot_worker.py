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

import json
import os
import sys
from contextlib import ExitStack, closing

from ..api.classified_parts import PartFailure
from ..core.message import restored, with_messages
from ..system.confinement import confine_running_process
from ..system.pipe_input import is_readable
from ..system.process_limits import limit_memory
from .json_lines import failure_line

PATIENCE = 600.0
"""Seconds without a job after which the process ends; loading the modules again takes less than one."""


def main():
    """Measure one snapshot."""
    pipe = _private_stdout()

    def send(**line):
        pipe.write(json.dumps(with_messages(line), ensure_ascii=False) + "\n")
        pipe.flush()

    try:
        snapshots = _load()
        request = _read_request()
        if request:
            _measure(request, snapshots, send)
    except Exception as error:  # reported to the parent, whatever its class
        send(failure=failure_line(error))
        sys.exit(1)


def _measure(request, snapshots, send):
    folder, megabytes = request["folder"], request["megabytes"]
    os.chdir(folder)
    with ExitStack() as stack:
        pages = None
        if "report" in request:
            pages = stack.enter_context(closing(_new_report(folder, request["report"])))
        confine_running_process(folder, *([request["report"]["output"]] if pages else []))
        limit_memory(megabytes * 1024 * 1024)
        _send_results(folder, megabytes, snapshots, send, pages)
        if pages:
            pages.finish()
    send(done=True)


def _new_report(folder, wanted):
    # Imported here: a report needs Jinja2, a measurement does not.
    from ..api.report_folder import OpenDocumentReport
    from ..api.snapshots import read_snapshot

    job, _ = read_snapshot(folder)
    return OpenDocumentReport(job["settings"], job["profile"], **wanted)


def _send_results(folder, megabytes, snapshots, send, pages):

    def report(part, stage, fraction):
        send(progress={"part": part, "stage": stage, "fraction": round(fraction, 4)})

    for found in snapshots.measure_snapshot(folder, megabytes, report, _wait_for_end_of_input, pages):
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


def _read_request():
    """Read the request; None if none comes. Further input stays in the pipe."""
    line = b""
    while not line.endswith(b"\n"):
        if not is_readable(0, PATIENCE):
            return None
        byte = os.read(0, 1)
        if not byte:
            return None
        line += byte
    return restored(json.loads(line))


def _wait_for_end_of_input():
    """Wait until the window has written the feature history, which it does while idle."""
    while os.read(0, 4096):
        pass


def _private_stdout():
    """The pipe to the parent; output that FreeCAD prints to stdout is redirected to stderr."""
    descriptor = os.dup(1)
    os.dup2(2, 1)
    return os.fdopen(descriptor, "w", encoding="utf-8", errors="surrogateescape")


if __name__ == "__main__":
    main()
