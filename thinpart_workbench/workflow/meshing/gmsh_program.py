# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gmsh as a program: where it is, and how it ends."""

import os
import re
import shutil
import sys

from ...core.errors import ThinPartError
from ...core.foreign_text import is_gmsh_text
from ...core.message import message
from ...system.exit_cause import ExitCause
from ...system.process_limits import run_limited

PROGRAM = "gmsh"

CRASHED, TIMEOUT = message("Gmsh crashed"), message("Gmsh took too long")
MEMORY = message("Gmsh needed too much memory")
INCOMPLETE = message("its mesh is incomplete: is the disk full?")
"""Reasons why there is no mesh, beside those that Gmsh states."""

_ERROR_LINE = re.compile(r"^Error *: *(\S.*)$", re.MULTILINE)


def gmsh_program(preferred=""):
    """Path of Gmsh, at a preferred path first, and its version, str; raises ThinPartError ``unsupported`` without it."""
    # Beside Python too, as in FreeCAD's bundles.
    program = (preferred and shutil.which(preferred) or shutil.which(PROGRAM)
               or shutil.which(PROGRAM, path=os.path.dirname(sys.executable)))
    if program is not None:
        try:
            end = run_limited([program, "--version"], 20, os.getcwd())
        except OSError:
            end = None
        words = end.text.split() if end is not None and end.code == 0 else []
        if words:
            return program, words[-1]
    raise ThinPartError(message("Meshing needs Gmsh: install it (Debian: 'apt-get install gmsh', elsewhere: "
                                "https://gmsh.info), and see that 'gmsh --version' runs."), "unsupported")


def mesh_volume(program, inputs, output, seconds, folder, options=()):
    """Mesh a volume with Gmsh, one thread, into a binary file of the format MSH 2.2.

    Returns `reason` (str; why there is no mesh; empty if there may be one) and `stated` (str; all that Gmsh printed).

    Parameters
    ----------
    program : str
        Path of Gmsh.
    inputs : list of str
        Files of geometry and scripts, in their order.
    output : str
    seconds : float
        Limit.
    folder : str
        Working directory, in which all of them lie: a temporary one, since Gmsh runs scripts that are called like its files.
    options : sequence of str, optional
        Further ones of Gmsh.
    """
    return _meshed(program, inputs, output, seconds, folder, ("-3", *options))


def mesh_surface(program, script, output, seconds, folder, around, order):
    """Mesh faces with triangles, as `mesh_volume` does a volume. Returns `reason` and `stated` (str): as there.

    Parameters
    ----------
    program, output, seconds, folder
        As there.
    script : str
        Of Gmsh, with the faces and their element sizes.
    around : int
        Elements around a circle.
    order : int
        Of the elements.
    """
    return _meshed(program, [script], output, seconds, folder, ("-2", "-clcurv", str(around), "-order", str(order)))


def _meshed(program, inputs, output, seconds, folder, options):
    end = run_limited([program, *(_own(each, folder) for each in inputs), *options, "-format", "msh2", "-bin", "-nt", "1",
                       "-v", "2", "-o", _own(output, folder)], seconds, folder)
    reason = _reason(end)
    if not reason and not os.path.exists(output):
        reason = message("Gmsh wrote no mesh")
    return reason, end.text


def convert_mesh(program, mesh, output, seconds, folder):
    """Convert a mesh to another format, that of the ending of the output, with all its elements.

    Returns a str: why that failed; empty if it did not.
    """
    end = run_limited([program, _own(mesh, folder), "-save", "-save_all", "-v", "2", "-o", _own(output, folder)], seconds,
                      folder)
    return _reason(end) or ("" if os.path.exists(output) else message("Gmsh wrote no mesh"))


def _own(file, folder):
    """The plain name of a file in a working directory, whose own path may hold anything."""
    if os.path.dirname(os.path.abspath(file)) != os.path.abspath(folder) or not is_gmsh_text(os.path.basename(file)):
        raise ValueError(file, folder)
    return os.path.basename(file)


def _reason(end):
    """Why a run of Gmsh gave no mesh; empty where it may have given one."""
    if end.timed_out:
        return TIMEOUT
    cause = end.cause()
    if cause is ExitCause.OUT_OF_MEMORY:
        return MEMORY
    if cause in (ExitCause.CRASHED, ExitCause.KILLED):
        return CRASHED
    return "" if cause is ExitCause.WELL else stated_error(end.text) or CRASHED


def stated_error(output):
    """The first error that Gmsh states."""
    found = _ERROR_LINE.search(output)
    return "" if found is None else found[1][:200].rstrip()
