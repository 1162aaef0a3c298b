# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where lines cross faces."""

from ..bootstrap import load_freecad


def crossings(line, face):
    """Where a line crosses a face: list of Vector."""
    App = load_freecad()
    import Part

    try:
        points, _ = line.intersectCS(face.Surface)
    except Part.OCCError:
        return []  # a surface that OCC cannot cut
    found = [App.Vector(each.X, each.Y, each.Z) for each in points]
    return [each for each in found if face.isInside(each, face.Tolerance, True)]
