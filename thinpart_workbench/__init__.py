# SPDX-License-Identifier: LGPL-2.1-or-later
"""ThinPart: tells before meshing whether a CAD part is thin, and where.

As a library: ``import thinpart_workbench as thinpart``; see docs/python.md.
"""

import importlib
import os
import sys

__version__ = "0.1.0"

PACKAGES_VARIABLE = "THINPART_PYTHON_PACKAGES"
"""Environment variable that lists the folders into which FreeCAD's Addon Manager installs Python packages."""

_MODULE_OF = {
    "AnalysisSettings": "core.analysis_settings",
    "Cancelled": "core.errors",
    "ClassifiedPart": "api.classified_parts",
    "ClassifiedParts": "api.classified_parts",
    "LearnedProfile": "workflow.learning.learn_profile",
    "FoundPart": "api.found_parts",
    "SearchResult": "api.found_parts",
    "Measurement": "core.thickness.measurement",
    "PartFailure": "api.classified_parts",
    "PartRecord": "core.record.record_types",
    "RunControl": "core.run_control",
    "ThinPartError": "core.errors",
    "classify": "api.classification",
    "classify_files": "api.classification",
    "duplicates": "api.libraries",
    "find": "api.libraries",
    "learn": "api.learning",
    "measure": "api.mesh_measurement",
    "reclassify": "api.reclassification",
    "similar": "api.libraries",
}
"""Maps each public name to its module."""

__all__ = ["__version__", *_MODULE_OF]


def __getattr__(name):
    # Import on first access: FreeCAD imports this package when it starts, and importing numpy takes a while.
    if name not in _MODULE_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(f".{_MODULE_OF[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__():
    return sorted({*globals(), *__all__})


def _find_additional_packages():
    # Append them last, as FreeCAD does: in PYTHONPATH, another numpy in them would take precedence over FreeCAD's.
    for folder in os.environ.get(PACKAGES_VARIABLE, "").split(os.pathsep):
        if folder and folder not in sys.path:
            sys.path.append(folder)


_find_additional_packages()
