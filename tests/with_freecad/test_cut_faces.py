# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mid-faces cut by each other: in this process, in another one, and not at all where that takes too long."""

import numpy as np
import pytest

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.freecad_adapter.mid_surface.bridges import spread_points
from thinpart_workbench.freecad_adapter.mid_surface.cut_faces import FEW, TimeLimit, faces_cut


def grid(count):
    """Planes across each other, so many of each of two directions: each is cut into strips."""
    import Part

    side = count + 1
    level = [[(0, 0, row), (side, 0, row), (side, side, row), (0, side, row)] for row in range(1, side)]
    upright = [[(row, 0, 0), (row, side, 0), (row, side, side), (row, 0, side)] for row in range(1, side)]
    return [Part.Face(Part.makePolygon([*corners, corners[0]])) for corners in level + upright]


@pytest.mark.parametrize("count", [3, FEW // 2 + 1])
def test_pieces_share_their_edges_however_many_faces_there_are(count):
    faces = grid(count)
    assert (len(faces) > FEW) == (count > 3)
    pieces = faces_cut(faces, 1e-4)
    assert len(pieces) == 2 * count * (count + 1)
    assert sum(piece.Area for piece in pieces) == pytest.approx(sum(face.Area for face in faces))
    sharing = {}
    for piece in pieces:
        for edge in piece.Edges:
            sharing.setdefault(edge.hashCode(), []).append(edge)
    # Each crossing of two planes is an edge of four pieces.
    crossings = [same for same in sharing.values() if len(same) == 4 and all(edge.isSame(same[0]) for edge in same)]
    assert len(crossings) >= count * count


def test_one_face_stays_as_it_is():
    import Part

    face = Part.makePlane(3, 4)
    assert faces_cut([face], 1e-4)[0].isSame(face)


def test_what_takes_too_long_is_refused_with_a_sentence():
    with pytest.raises(ThinPartError, match="takes too long.*: mesh it as a solid") as refused:
        faces_cut(grid(150), 1e-4, TimeLimit(1.0))
    assert refused.value.kind == "no_shell"
    limit = TimeLimit(0.0)
    with pytest.raises(ThinPartError, match="takes too long"):
        sum(range(10**5))
        limit.check()


class _WithoutTriangles:
    """A face of which OCC makes no triangles, as of some whose edges are shorter than their ends are exact."""

    def __init__(self, face):
        self._face = face

    def tessellate(self, deflection):
        return [], []

    def __getattr__(self, name):
        return getattr(self._face, name)


def test_points_are_spread_over_a_face_without_triangles_too():
    import FreeCAD
    import Part

    plate = Part.makePlane(40, 20).cut(Part.makeCylinder(6, 2, FreeCAD.Vector(20, 10, -1))).Faces[0]
    points, area = spread_points(_WithoutTriangles(plate), 1.0)
    assert len(points) > 100 and area.sum() == pytest.approx(plate.Area)
    assert np.abs(points[:, 2]).max() < 1e-9
    assert np.hypot(points[:, 0] - 20.0, points[:, 1] - 10.0).min() > 5.9  # none in the hole
    assert points[:, 0].max() > 35.0 and points[:, 1].min() < 5.0
