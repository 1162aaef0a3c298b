# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest balls inside, held against the exact B-Rep of parts: FreeCAD tells how far it is from their centres."""

import numpy as np
import pytest
from program import SAMPLES

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.sampling import SurfaceSamples, even_samples, surface_samples
from thinpart_workbench.core.mesh.smooth_normals import normals_at
from thinpart_workbench.core.thickness.inscribed_balls import inscribed_balls
from thinpart_workbench.freecad_adapter.bootstrap import load_meshing

SETTINGS = AnalysisSettings()


@pytest.mark.parametrize("sample", ["flange", "heat_sink", "gear_thin_teeth", "worm_run_out"])
def test_balls_are_empty_and_touch_the_part(sample):
    load_meshing()
    import FreeCAD as App
    import Part

    from thinpart_workbench.freecad_adapter.reading.part_files import read_parts

    part, = read_parts(SAMPLES / f"{sample}.step").parts
    mesh, _ = part.surface_mesh(SETTINGS, SETTINGS.linear_deflection)
    surface = surface_samples(mesh)
    chosen = even_samples(surface.area, 60)
    samples = SurfaceSamples(surface.points[chosen], surface.triangle[chosen], surface.area[chosen])
    radius = 0.5 * inscribed_balls(mesh, samples)
    centres = samples.points - radius[:, None] * normals_at(mesh, samples.triangle, samples.points) + mesh.origin
    shell = Part.makeCompound(part.shape.Shells)
    clear = np.array([shell.distToShape(Part.Vertex(App.Vector(*centre)))[0] for centre in centres])
    slack = SETTINGS.linear_deflection * mesh.extent
    assert (np.abs(clear - radius) <= 0.02 * radius + slack).all()
    assert np.median(np.abs(clear / radius - 1.0)) < 0.002
    assert all(part.shape.isInside(App.Vector(*centre), 1e-7, True) for centre in centres)
