# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which walls are plates: wider than they are thick."""

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure

TURN = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()


def plate_share(vertices, triangles):
    return measure(surface_mesh(vertices, triangles), AnalysisSettings()).descriptors.plate_share


@pytest.mark.parametrize("size, least, most", [
    ((100.0, 100.0, 2.0), 0.9, 1.0),
    ((100.0, 100.0, 0.05), 0.97, 1.0),
    ((200.0, 40.0, 4.0), 0.8, 1.0),
    ((200.0, 20.0, 20.0), 0.0, 0.02),
    ((200.0, 40.0, 20.0), 0.0, 0.02),
    ((10.0, 10.0, 10.0), 0.0, 0.02),
])
@pytest.mark.parametrize("scale", [1.0, 0.01])
def test_boxes(size, least, most, scale):
    for rotation in (np.eye(3), TURN):
        share = plate_share(*made_meshes.moved(made_meshes.box(*size), rotation, np.zeros(3), scale))
        assert least <= share <= most


def test_a_shell_is_plates_and_a_ball_is_none():
    assert plate_share(*made_meshes.spherical_shell(20.0, 1.0, 60)) > 0.95
    assert plate_share(*made_meshes.sphere(20.0, 60)) < 0.02


def test_between_bar_and_plate_the_share_changes_gradually_and_its_error_says_so():
    """Bars of ever wider section: no step from one to the next is larger than what the errors of both allow."""
    shares, errors = [], []
    for width in np.arange(1.0, 8.25, 0.25):
        measured = measure(surface_mesh(*made_meshes.box(200.0, 10.0 * width, 10.0)), AnalysisSettings())
        shares.append(measured.descriptors.plate_share)
        errors.append(measured.regions.plate_share_error)
    shares, errors = np.array(shares), np.array(errors)
    assert shares[0] < 0.02 and shares[-1] > 0.7
    assert (np.diff(shares) > -0.03).all()
    assert (np.abs(np.diff(shares)) <= errors[1:] + errors[:-1] + 0.05).all()
    assert errors[0] < 0.02 and errors[-1] < 0.02 and errors.max() > 0.1
