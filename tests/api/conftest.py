# SPDX-License-Identifier: LGPL-2.1-or-later
import made_library
import pytest

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad


@pytest.fixture(scope="session")
def freecad():
    """The real FreeCAD, without a window."""
    return load_freecad()


@pytest.fixture
def document(freecad):
    """An empty document, closed afterwards."""
    document = freecad.newDocument("Test")
    yield document
    freecad.closeDocument(document.Name)


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """A library of parts that no CAD program is needed for."""
    return made_library.make_library(tmp_path_factory.mktemp("api") / "library")
