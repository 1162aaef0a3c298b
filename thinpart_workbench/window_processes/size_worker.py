# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that proposes element sizes for one part and meshes it.

The first line on standard input is ``{"folder", "megabytes", "gmsh"}``: the folder of a snapshot with one part, the limit of
the address space, a path of Gmsh to look at first. It prints ``{"progress": fraction}`` and ``{"measured": {"record",
"gmsh", "shell_walls"}}``, where ``gmsh`` is a sentence if nothing can be meshed. Each further line is a request:
``{"settings", "sizes_wanted"}``, with ``"mesh": true`` to mesh, or ``{"shell": settings}``; see `PartSizes`. It is answered
by ``{"proposed": dict}``, ``{"meshed": dict}`` or ``{"shelled": dict}``, or where it cannot be done by
``{"refused": sentence}``.

The parent stops it by killing it. The shapes may come from an untrusted file, so it can only write into the snapshot's
folder.
"""

import os

from ..core.errors import ThinPartError
from ..core.message import message
from ..core.problem import problem_of
from ..system.confinement import confine_running_process
from ..system.process_limits import limit_memory
from .json_lines import JsonLines


def main():
    """Answer requests until the parent closes the pipe."""
    parent = JsonLines(in_thread=False)
    with parent.reporting_failures():
        job = parent.receive()
        if job is not None:
            _serve(parent, job)
    parent.end()


def _serve(parent, job):
    from ..freecad_adapter.bootstrap import load_meshing

    load_meshing()
    from ..api.mesh_sizes import missing_gmsh
    from ..api.window.part_sizes import PartSizes

    os.chdir(job["folder"])
    confine_running_process(job["folder"], with_programs=True)
    limit_memory(job["megabytes"] * 1024 * 1024)
    sizes = PartSizes(job["folder"], lambda fraction: parent.send(progress=round(fraction, 3)))
    parent.send(measured={"record": sizes.record, "gmsh": missing_gmsh(job["gmsh"]), "shell_walls": sizes.shell_walls})
    while (request := parent.receive()) is not None:
        _answer(parent.send, sizes, job["gmsh"], **request)


def _answer(send, sizes, gmsh, settings=None, sizes_wanted=(), mesh=False, shell=None):
    try:
        if shell is not None:
            send(shelled=sizes.shell(shell, gmsh))
        elif mesh:
            send(meshed=sizes.mesh(settings, sizes_wanted, gmsh))
        else:
            send(proposed=sizes.proposed(settings, sizes_wanted))
    except ThinPartError as error:
        send(refused=error.args[0])
    except OSError as error:
        send(refused=message("Temporary files cannot be written ({problem}): free some disk space. Nothing was meshed.",
                             problem=problem_of(error)))


if __name__ == "__main__":
    main()
