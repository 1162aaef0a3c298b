"""ThinPart: tells before meshing whether a CAD part is thin, and where."""

import os
import sys

__version__ = "0.1.0"

PACKAGES_VARIABLE = "THINPART_PYTHON_PACKAGES"
"""Environment variable with the folders into which FreeCAD's Addon Manager installs Python packages."""


def _find_additional_packages():
    # Last, as FreeCAD itself has them: in PYTHONPATH another numpy in them would go before FreeCAD's.
    for folder in os.environ.get(PACKAGES_VARIABLE, "").split(os.pathsep):
        if folder and folder not in sys.path:
            sys.path.append(folder)


_find_additional_packages()
