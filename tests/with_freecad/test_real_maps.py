# SPDX-License-Identifier: LGPL-2.1-or-later
"""Maps of real parts, against a ray for each of many points."""

import os
from pathlib import Path

import pytest
from map_accuracy import share_off

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.thickness.measurement import measure

TRAINING = Path(os.environ.get("THINPART_TRAINING", Path(__file__).resolve().parents[3] / "shared" / "training")) / "parts"
"""Real parts; tests that use them are skipped where they are absent."""


@pytest.mark.skipif(not TRAINING.is_dir(), reason="the real parts are not here")
@pytest.mark.parametrize("name, most_off", [("t264", 0.005), ("t054", 0.005), ("t316", 0.005), ("t106", 0.028)],
                         ids=["t264", "t054", "t316", "a frame full of small holes"])
def test_maps_of_real_parts_are_what_rays_meet(name, most_off):
    from thinpart_workbench.freecad_adapter.reading.part_files import read_parts

    part, settings = read_parts(next(TRAINING.glob(f"{name}_*"))).parts[0], AnalysisSettings()
    mesh, _ = part.surface_mesh(settings, settings.linear_deflection)
    off, unmeasured = share_off(mesh, thickness_map(measure(mesh, settings)))
    assert off < most_off and unmeasured < max(most_off, 0.005)
