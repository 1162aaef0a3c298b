"""Solids without faces that lie on each other: walls and gaps of no thickness, which no mesher can fill.

    python -m thinpart_workbench.freecad_adapter.shapes.mended_solid INPUT OUTPUT
"""

import os
import sys

from ..bootstrap import load_freecad
from ..python_beside_freecad import run_module_limited

MOST_FACES = 500
"""Of a solid, above which cutting its faces with each other takes too long."""

SECONDS = 30.0
"""Of processor time, for that. Most solids take a few; some with free-form faces would take hours."""

SAME_VOLUME = 1e-3
"""Greatest relative difference of the volumes of a solid and of the mended one."""


def edges_of_many_faces(file):
    """How many edges of the shape in a BREP file join more than two faces: int."""
    import Part

    shape = Part.Shape()
    shape.read(os.fspath(file))
    uses: dict = {}
    for face in shape.Faces:
        for edge in face.Edges:
            same = uses.setdefault(edge.hashCode(), [])
            own = next((each for each in same if each[0].isSame(edge)), None)
            if own is None:
                same.append([edge, 1])
            else:
                own[1] += 1
    return sum(count > 2 for same in uses.values() for _, count in same)


def write_mended(file, output, seconds=SECONDS):
    """Write the solid of a file without the pieces of faces that coincide in pairs.

    Parameters
    ----------
    file : str
        BREP, with one solid.
    output : str
        BREP file.
    seconds : float, optional
        Limit of processor time.

    Returns
    -------
    bool
        False, and nothing is written, where no faces coincide, where what is left is no valid solid of the same volume, or
        where it takes too long.

    Notes
    -----
    All faces are cut with each other (general fuse). A piece that came of two faces has material on both sides or on none:
    the surface goes on where both are left out. So a shaft that was put into a hole of its own size without being fused, or
    two bodies that were joined with a cap between them, become what their author saw.
    """
    # In a process of its own, which can be ended.
    folder = os.path.dirname(os.path.abspath(output))
    end = run_module_limited(__spec__.name, [os.path.abspath(file), os.path.abspath(output)], seconds, folder)
    return end is not None and not end.timed_out and end.code == 0 and os.path.exists(output)


def _write(file, output):
    import Part

    whole = Part.Shape()
    whole.read(os.fspath(file))
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
    by_code: dict = {}
    for piece in (piece for image in images for shape in image for piece in shape.Faces):
        by_code.setdefault(piece.hashCode(), []).append(piece)
    kept, dropped = [], False
    for pieces in by_code.values():
        while pieces:
            same = [piece for piece in pieces if piece.isSame(pieces[0])]
            pieces = [piece for piece in pieces if not piece.isSame(same[0])]
            dropped |= len(same) > 1
            if len(same) % 2:
                kept.append(same[0])
    return kept if dropped else None


def main():
    """Exit with status 0 where a solid was written."""
    load_freecad()
    sys.exit(0 if _write(*sys.argv[1:]) else 1)


if __name__ == "__main__":
    main()
