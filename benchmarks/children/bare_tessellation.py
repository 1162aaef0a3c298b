# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that the whole program is compared with: it reads files and tessellates their solids, nothing else.

    python -m benchmarks.children.bare_tessellation FOLDER

A line of JSON per file. It does what a script of ten lines would do in FreeCAD: nothing is checked, equal solids are not
recognised, no file is confined to a process of its own.
"""

import json
import math
import sys
import time
from pathlib import Path

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad

LINEAR_DEFLECTION = 0.001
"""Share of the diagonal."""

ANGULAR_DEFLECTION = 5.0
"""Degrees."""

DOCUMENT, SHAPES = ".fcstd", (".step", ".stp", ".brep", ".brp", ".iges", ".igs")
ENDINGS = (DOCUMENT, *SHAPES)


def main(folder):
    """Print a line per file of the folder and of those below it."""
    load_freecad()
    folder = Path(folder)
    for file in sorted(path for path in folder.rglob("*") if path.suffix.lower() in ENDINGS):
        line = {"file": file.relative_to(folder).as_posix()}
        started = time.perf_counter()
        try:
            solids, close = _solids(file)
            line["read"] = time.perf_counter() - started
            line["triangles"] = sum(map(_triangles, solids))
            line["solids"] = len(solids)
            close()
        except Exception as error:  # FreeCAD raises its own classes; the other files still count
            line["error"] = " ".join(str(error).split())[:200]
        line["seconds"] = time.perf_counter() - started
        print(json.dumps(line), flush=True)


def _solids(file):
    """The solids of a file, or its faces if there are none, and what closes it again."""
    import FreeCAD
    import Part

    if file.suffix.lower() != DOCUMENT:
        shape = Part.read(str(file))
        return shape.Solids or [shape], lambda: None  # IGES has loose faces
    document = FreeCAD.openDocument(str(file), True)
    shapes = [
        each.Shape for each in document.Objects
        if hasattr(each, "Shape") and each.TypeId != "App::Part" and not any(hasattr(user, "Shape") for user in each.InList)
    ]
    return [solid for shape in shapes for solid in shape.Solids], lambda: FreeCAD.closeDocument(document.Name)


def _triangles(solid):
    import MeshPart

    # A finer triangulation that comes with a file would be taken as it is.
    fresh = solid.copy(True, False)
    return MeshPart.meshFromShape(
        Shape=fresh, LinearDeflection=LINEAR_DEFLECTION * fresh.BoundBox.DiagonalLength,
        AngularDeflection=math.radians(ANGULAR_DEFLECTION)).CountFacets


if __name__ == "__main__":
    main(sys.argv[1])
