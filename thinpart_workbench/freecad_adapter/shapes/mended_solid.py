# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids without faces that lie on each other: walls and gaps of no thickness, which no mesher can fill.

    python -m thinpart_workbench.freecad_adapter.shapes.mended_solid INPUT OUTPUT
"""

import os
import sys
from collections import Counter

from ..bootstrap import load_freecad
from ..python_beside_freecad import run_module_limited
from .brep_file import read_brep
from .same_shapes import same_shapes

MOST_FACES = 500
"""Of a solid, above which cutting its faces with each other takes too long."""

SECONDS = 30.0
"""Of processor time, for that. Most solids take a few; some with free-form faces would take hours."""

SAME_VOLUME = 1e-3
"""Greatest relative difference of the volumes of a solid and of the mended one."""


def edges_of_many_faces(file):
    """How many edges of the shape in a BREP file join more than two faces: int."""
    edges = [edge for face in read_brep(file).Faces for edge in face.Edges]
    return sum(count > 2 for count in Counter(same_shapes(edges)).values())


def write_mended(file, output, seconds=SECONDS):
    """Write the solid of a file without the pieces of faces that coincide in pairs.

    Returns a bool: False, and nothing is written, where no faces coincide, where what is left is no valid solid of the same
    volume, or where it takes too long.

    All faces are cut with each other (general fuse). A piece that came of two faces has material on both sides or on none:
    the surface goes on where both are left out. So a shaft that was put into a hole of its own size without being fused, or
    two bodies that were joined with a cap between them, become what their author saw.

    Parameters
    ----------
    file : str
        BREP, with one solid.
    output : str
        BREP file.
    seconds : float, optional
        Limit of processor time.
    """
    # In a process of its own, which can be ended.
    folder = os.path.dirname(os.path.abspath(output))
    end = run_module_limited(__spec__.name, [os.path.abspath(file), os.path.abspath(output)], seconds, folder)
    return end is not None and not end.timed_out and end.code == 0 and os.path.exists(output)


def _write(file, output):
    import Part

    whole = read_brep(file)
    if len(whole.Solids) != 1 or not 2 <= len(whole.Faces) <= MOST_FACES:
        return False
    solid = whole.Solids[0]
    try:
        kept = _kept_pieces(solid.Faces)
        if kept is None:
            return False
        mended = Part.Solid(Part.makeShell(kept))
        if mended.Volume < 0.0:
            mended.reverse()
        if (not mended.Shells[0].isClosed() or not mended.isValid()
                or abs(mended.Volume - solid.Volume) > SAME_VOLUME * solid.Volume):
            return False
        mended.exportBrep(os.fspath(output))
    except Part.OCCError:
        return False
    return True


def _kept_pieces(faces):
    """Pieces that come of an odd number of faces; None where all do."""
    _, images = faces[0].generalFuse(faces[1:])
    pieces = [piece for image in images for shape in image for piece in shape.Faces]
    numbers = same_shapes(pieces)
    counts = Counter(numbers)
    if len(counts) == len(pieces):
        return None
    return [pieces[numbers.index(number)] for number, count in counts.items() if count % 2]


def main():
    """Exit with status 0 where a solid was written."""
    load_freecad()
    sys.exit(0 if _write(*sys.argv[1:]) else 1)


if __name__ == "__main__":
    main()
