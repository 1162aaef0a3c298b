# SPDX-License-Identifier: LGPL-2.1-or-later
import shutil

import pytest
from program import SAMPLES, thinpart

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad


@pytest.fixture(scope="session", autouse=True)
def freecad():
    """The real FreeCAD, without a window."""
    return load_freecad()


@pytest.fixture(scope="session")
def classified(tmp_path_factory):
    """A library of one part."""
    folder = tmp_path_factory.mktemp("classified")
    shutil.copyfile(SAMPLES / "plate.step", folder / "plate.step")
    assert thinpart("classify", folder).returncode == 0
    return folder


@pytest.fixture
def library(classified, tmp_path):
    """The same, for a test to change."""
    return shutil.copytree(classified, tmp_path / "library")
