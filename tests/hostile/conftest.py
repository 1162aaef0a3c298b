import pytest

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad


@pytest.fixture(scope="session", autouse=True)
def freecad():
    """The real FreeCAD, without a window."""
    return load_freecad()
