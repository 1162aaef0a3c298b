# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decides which copy of ThinPart runs where FreeCAD finds several: a link, an installed add-on, a folder given by ``-M``."""

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

from .application.qt import translate

LOADED_FOLDER = Path(__file__).resolve().parents[2]
"""The folder that the package was imported from; it is the same for all copies, since a package is imported once."""


def is_to_start(init_file):
    """Whether an ``InitGui.py`` has to start the workbench; warns where it belongs to a copy that is not used.

    Parameters
    ----------
    init_file : str or None
        Path of the ``InitGui.py``, where FreeCAD provides it.

    Notes
    -----
    FreeCAD puts all add-ons on the module path before it runs the first ``InitGui.py``, so the imported package may
    belong to another copy than that file. The ``InitGui.py`` beside the package starts it, so the versions match.
    The ``InitGui.py`` of a copy with another version imports this function too: keep its name and parameter.
    """
    folder = Path(init_file).resolve().parent if init_file else LOADED_FOLDER
    if folder != LOADED_FOLDER:
        App.Console.PrintWarning(translate(
            "ThinPart", "ThinPart is installed twice: {} is used, {} is not. Remove one of them."
        ).format(LOADED_FOLDER, folder) + "\n")
    # FreeCAD may find the same folder twice, through two links or -M.
    return folder == LOADED_FOLDER and "ThinPartWorkbench" not in Gui.listWorkbenches()
