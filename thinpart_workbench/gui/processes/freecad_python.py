# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python interpreter for child processes, one that can import FreeCAD."""

import sys

from ...core.errors import ThinPartError
from ...freecad_adapter.python_beside_freecad import python_beside_freecad
from ..application.qt import translate


def python_program():
    """Path of the Python that FreeCAD was built with, or of FreeCADCmd where there is none beside FreeCAD.

    Raises
    ------
    ThinPartError
        kind ``unsupported`` where there is none.

    Notes
    -----
    Inside FreeCAD ``sys.executable`` is FreeCAD itself.
    """
    program = python_beside_freecad()
    if program is not None:
        return program
    raise ThinPartError(translate(
        "ThinPart", "Measuring needs Python {} beside FreeCAD, which was not found: install it."
    ).format(f"{sys.version_info.major}.{sys.version_info.minor}"), "unsupported")
