# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of whose faces OCC leaves out some, or single triangles."""

import os
from dataclasses import replace
from pathlib import Path

import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.mass_properties import volume
from thinpart_workbench.freecad_adapter.shapes import solid_mesher
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
from thinpart_workbench.freecad_adapter.shapes.repaired_copies import REPAIRS

TRAINING = Path(os.environ.get("THINPART_TRAINING", Path(__file__).resolve().parents[3] / "shared" / "training")) / "parts"
"""Real parts; tests that use them are skipped where they are absent."""

SETTINGS = AnalysisSettings()


def bored_block():
    """A block with two bores that meet: their faces have no four sides, so that there are no grids in place of facets."""
    import FreeCAD
    import Part

    shape = Part.makeBox(30, 20, 10).cut(Part.makeCylinder(4, 10, FreeCAD.Vector(15, 10, 0)))
    shape = shape.cut(Part.makeCylinder(2, 20, FreeCAD.Vector(15, 0, 5), FreeCAD.Vector(0, 1, 0)))
    return SolidPart("part", "part", shape=shape.Solids[0])


def meshes_without_a_face(monkeypatch, until):
    """Let OCC leave out a face at angles from one on: that it does so cannot be provoked."""
    asked, whole = [], solid_mesher.tessellate

    def tessellate(shape, linear_deflection, angular_deflection):
        asked.append(angular_deflection)
        found = whole(shape, linear_deflection, angular_deflection)
        if angular_deflection < until:
            return found
        kept = found.face_of_triangle != 0
        return replace(found, triangles=found.triangles[kept], face_of_triangle=found.face_of_triangle[kept])

    monkeypatch.setattr(solid_mesher, "tessellate", tessellate)
    return asked


@pytest.mark.parametrize("until, tried", [(20.0, 1), (12.0, 2), (8.0, 3)])
def test_a_face_that_is_left_out_at_one_angle_is_there_at_another(monkeypatch, until, tried):
    asked = meshes_without_a_face(monkeypatch, until)
    part = bored_block()
    mesh, _ = part.surface_mesh(SETTINGS, SETTINGS.linear_deflection)
    assert mesh.watertight and part.missing_faces(mesh) == []
    assert len(asked) == tried and asked == sorted(asked, reverse=True)


def test_a_face_that_is_never_there_is_said_to_be_missing(monkeypatch):
    asked = meshes_without_a_face(monkeypatch, 0.0)
    part = bored_block()
    mesh, _ = part.surface_mesh(SETTINGS, SETTINGS.linear_deflection)
    assert not mesh.watertight and part.missing_faces(mesh) == ["Face1"]
    assert asked[0] == SETTINGS.angular_deflection and len(asked) == 4 + len(REPAIRS)


@pytest.mark.skipif(not TRAINING.is_dir(), reason="the real parts are not here")
@pytest.mark.parametrize("name, linear", [("t255", 0.001), ("t355", 0.001), ("t252", 0.0003)])
def test_real_solids_with_gaps_in_their_meshes_have_their_volume(name, linear):
    from thinpart_workbench.freecad_adapter.reading.part_files import read_parts

    part = read_parts(next(TRAINING.glob(f"{name}_*"))).parts[0]
    mesh, _ = part.surface_mesh(SETTINGS, linear)
    assert mesh.watertight and volume(mesh) == pytest.approx(part.shape.Volume, rel=1e-4)
