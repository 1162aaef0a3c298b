"""Arguments of the command line that follow from the preferences."""

import os

from ..freecad_adapter.settings import preference


def measuring_arguments():
    """list of str: how fine surfaces are meshed, and what one file may take of memory."""
    return ["--memory", str(preference("MemoryMegabytes")),
            "--linear-deflection", str(preference("LinearDeflection")),
            "--angular-deflection", str(preference("AngularDeflection"))]


def info_place_arguments(folder):
    """list of str: where info files lie, given the folder of all of them; none where that is empty."""
    return ["--info-dir", folder, "--info-tree", os.sep] if folder else []
