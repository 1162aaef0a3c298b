# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces cut by each other, in a program of its own where there are many: OCC cannot be interrupted, a program can.

    python -m thinpart_workbench.freecad_adapter.mid_surface.cut_faces INPUT OUTPUT TOLERANCE
"""

import os
import sys
import tempfile
import time

from ...core.errors import ThinPartError
from ...core.message import message
from ..bootstrap import load_freecad
from ..python_beside_freecad import run_module_limited
from ..shapes.brep_file import read_brep, write_brep

FEW = 40
"""Faces up to which they are cut within this process: that takes less than to start another one."""

SECONDS = 14.0
"""Of processor time, for a mid-surface. Those of real parts take up to 10 s to be made, or minutes, without a shell at the
end: hundreds of pieces that nearly lie on each other."""


LEAST_SECONDS = 1.0
"""That a process is given to start."""


class TimeLimit:
    """The time limit of a mid-surface, which is made by many short operations and by processes of their own."""

    def __init__(self, seconds=SECONDS):
        self._end = _processor_time() + seconds

    @property
    def left(self):
        """float, s"""
        return max(self._end - _processor_time(), 0.0)

    def check(self):
        """Raise a ThinPartError of the kind ``no_shell`` where it has taken too long."""
        if not self.left:
            raise too_long()


def _processor_time():
    """That of this process and of those that it has waited for, float, s."""
    times = os.times()
    return time.process_time() + times.children_user + times.children_system


def too_long():
    """The ThinPartError of a mid-surface that takes too long."""
    return ThinPartError(message("Cutting the mid-faces of the walls to each other takes too long, as there are too many "
                                 "that nearly touch: mesh it as a solid."), "no_shell")


def faces_cut(faces, tolerance, limit=None):
    """Cut faces by each other: list of Part.Face, the pieces; those that meet share their edges.

    Raises ThinPartError, kind ``no_shell`` where it takes too long, or fails.

    Parameters
    ----------
    faces : list of Part.Face
    tolerance : float, mm
        Edges that are nearer to each other are one.
    limit : TimeLimit, optional
        Where there are more than `FEW`.
    """
    import Part

    if len(faces) == 1:
        return list(faces)
    if len(faces) <= FEW:
        return faces[0].generalFuse(faces[1:], tolerance)[0].Faces
    with tempfile.TemporaryDirectory(prefix="thinpart-cut-") as folder:
        given, found = os.path.join(folder, "faces.brep"), os.path.join(folder, "cut.brep")
        write_brep(Part.makeCompound(faces), given)
        left = max((limit or TimeLimit()).left, LEAST_SECONDS)
        end = run_module_limited(__spec__.name, [given, found, repr(tolerance)], left, folder)
        if end is None:
            return faces[0].generalFuse(faces[1:], tolerance)[0].Faces
        if end.timed_out:
            raise too_long()
        if end.code or not os.path.exists(found):
            raise ThinPartError(message("The mid-faces of the walls could not be cut to each other: mesh it as a solid."),
                                "no_shell")
        return read_brep(found).Faces


def main():
    """Read the faces of a file, and write the pieces."""
    given, found, tolerance = sys.argv[1:]
    load_freecad()
    first, *others = read_brep(given).Faces
    write_brep(first.generalFuse(others, float(tolerance))[0], found)


if __name__ == "__main__":
    main()
