# SPDX-License-Identifier: LGPL-2.1-or-later
import time

import made_meshes
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure


class Stop(Exception):
    pass


@pytest.mark.parametrize("how", ["rays", "pairs"])
@pytest.mark.parametrize("shape", [made_meshes.wedge(30), made_meshes.spherical_shell(steps=60)])
def test_progress_rises_from_nothing_to_one(shape, how):
    seen = []
    measure(surface_mesh(*shape), AnalysisSettings(measure=how), seen.append)
    assert seen[0] == 0.0 and seen[-1] == 1.0
    assert seen == sorted(seen)


@pytest.mark.parametrize("at", [0.0, 0.05, 0.3, 0.6, 0.84])
def test_it_stops_wherever_progress_is_told(at):
    told = []

    def stop(done):
        told.append(done)
        if done >= at:
            raise Stop

    with pytest.raises(Stop):
        measure(surface_mesh(*made_meshes.spherical_shell(steps=60)), AnalysisSettings(), stop)
    assert told[-1] >= at and all(done < at for done in told[:-1])


def test_progress_is_told_often():
    mesh = surface_mesh(*made_meshes.spherical_shell(steps=160))
    started = time.process_time()
    told = []
    measure(mesh, AnalysisSettings(), lambda done: told.append(time.process_time() - started))
    # Processor time, so that a busy machine fails nothing: 50,000 triangles take about a second.
    longest = max(later - earlier for earlier, later in zip([0.0, *told], told))
    assert longest < 0.3 * told[-1] + 0.05
