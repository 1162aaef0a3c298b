# SPDX-License-Identifier: LGPL-2.1-or-later
"""Child process: FreeCAD writes copies of parts, turned elsewhere, mirrored, scaled, in other formats."""

import math
from pathlib import Path

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad

from .child_process import serve

KINDS = {"turned.step": "identical", "turned.brep": "identical", "turned.iges": "identical", "turned.stl": "identical",
         "mirrored.step": "mirrored", "scaled.step": "scaled"}
"""What copies are named after their originals, and what they are to them."""

INCH = 25.4


def copy(file, folder, kind):
    """Write a copy of a file of one solid; nothing where it has another number of them.

    Parameters
    ----------
    file, folder : str
    kind : str
        Of `KINDS`.

    Returns
    -------
    dict
        ``file``, the path of the copy or None.
    """
    load_freecad()
    import FreeCAD
    import Part

    solids = Part.read(file).Solids
    if len(solids) != 1:
        return {"file": None}
    solid, ending = solids[0], Path(kind).suffix
    matrix = FreeCAD.Matrix()
    if kind.startswith("mirrored"):
        matrix.scale(-1.0, 1.0, 1.0)
    elif kind.startswith("scaled"):
        matrix.scale(INCH, INCH, INCH)
    for turn, angle in ((matrix.rotateX, 0.3), (matrix.rotateY, -1.1), (matrix.rotateZ, 0.7)):
        turn(angle)
    matrix.move(FreeCAD.Vector(120.0, -40.0, 7.0))
    # A turn alone keeps the surfaces as they are; a scale has to be written into them.
    moved = solid.transformGeometry(matrix) if kind.startswith("scaled") else solid.transformed(matrix, True)
    target = Path(folder, f"{Path(file).stem}_{kind}")
    if ending == ".stl":
        import MeshPart

        # Triangles of another fineness than ThinPart's own.
        MeshPart.meshFromShape(Shape=moved, LinearDeflection=5e-4 * solid.BoundBox.DiagonalLength,
                               AngularDeflection=math.radians(8.0)).write(str(target))
    elif ending == ".brep":
        moved.exportBrep(str(target))
    elif ending == ".iges":
        moved.exportIges(str(target))
    else:
        moved.exportStep(str(target))
    return {"file": str(target)}


if __name__ == "__main__":
    serve({"copy": copy})
