"""Which ThinPart runs where FreeCAD finds several: a link, what the Addon Manager installed, a folder given by ``-M``."""

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

from .qt import translate

LOADED = Path(__file__).resolve().parents[2]
"""The folder that the package was imported from, which all copies share."""


def is_to_start(init_file):
    """Whether an ``InitGui.py`` is the one that starts the workbench; says which copy runs where it is another's.

    Parameters
    ----------
    init_file : str or None
        Its path, where FreeCAD tells it.

    Notes
    -----
    FreeCAD puts all add-ons on the module path before it runs the first ``InitGui.py``, so the package may be
    another copy's than the ``InitGui.py`` that comes first. The one beside the package starts it: the two fit.
    """
    folder = Path(init_file).resolve().parent if init_file else LOADED
    if folder != LOADED:
        App.Console.PrintWarning(translate(
            "ThinPart", "ThinPart is there twice: {} is used, {} is not. Remove one of them."
        ).format(LOADED, folder) + "\n")
    # The same folder may be found twice, by two links or by -M.
    return folder == LOADED and "ThinPartWorkbench" not in Gui.listWorkbenches()
