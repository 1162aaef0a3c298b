# SPDX-License-Identifier: LGPL-2.1-or-later
"""On PYTHONPATH: the Python of a FreeCAD bundle, which has numpy and scipy and none of HIDDEN.

What was installed beside the bundle, as the Addon Manager does it, is there.
"""

import sys
from importlib.machinery import PathFinder

HIDDEN = ("sklearn",)
INSTALLED = "AdditionalPythonPackages"


class BundlesFinder(PathFinder):
    """Finds what a bundle has."""

    @classmethod
    def find_spec(cls, fullname, path=None, target=None):
        """None for what it has not."""
        spec = super().find_spec(fullname, path, target)
        if spec is None or fullname.partition(".")[0] not in HIDDEN or INSTALLED in str(spec.origin):
            return spec
        return cls.find_spec(fullname, [each for each in sys.path if INSTALLED in each]) if path is None else None


sys.meta_path[sys.meta_path.index(PathFinder)] = BundlesFinder
