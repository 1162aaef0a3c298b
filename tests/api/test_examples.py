# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every public function of `api` has an example, which does what it says."""

import ast
import doctest
import importlib
import os
import shutil

import made_maps
import numpy as np
import pytest
from program import ROOT, SAMPLES

from thinpart_workbench.api.classification import classify_files
from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.api.found_parts import record_and_profile
from thinpart_workbench.api.mesh_sizes import missing_gmsh
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.objects.snapshot import write_snapshot
from thinpart_workbench.freecad_adapter.reading.document_parts import document_parts

API = ROOT / "thinpart_workbench" / "api"
OF_GMSH = {"shell_of", "missing_gmsh"}

FUNCTIONS = [(".".join(file.relative_to(ROOT).with_suffix("").parts), node.name, ast.get_docstring(node) or "")
             for file in sorted(API.rglob("*.py")) for node in ast.parse(file.read_text(encoding="utf-8")).body
             if isinstance(node, ast.FunctionDef) and not node.name.startswith("_")]


@pytest.fixture(scope="module")
def classified(tmp_path_factory):
    """A folder with two samples and their info files."""
    folder = tmp_path_factory.mktemp("examples") / "samples"
    folder.mkdir()
    for name in ("block.step", "plate.step"):
        shutil.copy(SAMPLES / name, folder)
    assert all(parts.parts for parts in classify_files(folder, write_info=True, jobs=1))
    return folder


@pytest.fixture(scope="module")
def open_plate(freecad, tmp_path_factory):
    """A document with a plate, its thickness map, and a folder with its snapshot."""
    import Part

    document, folder = freecad.newDocument("Example"), tmp_path_factory.mktemp("snapshot")
    plate = document.addObject("Part::Feature", "Plate")
    plate.Label, plate.Shape = "plate", Part.makeBox(80, 60, 2)
    document.recompute()
    thickness = made_maps.add_map(document, plate)
    profile = load_profile().content
    list(write_snapshot(document_parts(document), os.fspath(folder), AnalysisSettings(), profile))
    yield {"document": document, "thickness": thickness, "snapshot": os.fspath(folder), "profile": profile,
           "preferred": load_profile(), "parts_of": parts_of, "document_parts": document_parts}
    freecad.closeDocument(document.Name)


@pytest.fixture
def names(classified, open_plate, tmp_path):
    """What examples may name, each its own files."""
    samples = shutil.copytree(classified, tmp_path / "samples")
    corners = np.array([[x, y, z] for x in (0, 80) for y in (0, 60) for z in (0, 2)])
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    labels = tmp_path / "given.csv"
    labels.write_text("file,part,category\nplate.step,plate,thin\n")
    plate = os.fspath(samples / "plate.step")
    without = {key: value for key, value in open_plate["profile"].items() if key != "probability"}
    return {**open_plate, "samples": os.fspath(samples), "plate": plate, "block": os.fspath(samples / "block.step"),
            "record": record_and_profile(f"{plate}.thinpart.json", "plate")[0], "labels": labels, "vertices": corners,
            "triangles": np.array([half for a, b, c, d in sides for half in ((a, b, c), (a, c, d))]), "np": np, "os": os,
            "one_category": {**without, "categories": without["categories"][:1]}}


@pytest.mark.parametrize("module, name, text", FUNCTIONS, ids=[f"{module}.{name}" for module, name, _ in FUNCTIONS])
def test_a_function_has_an_example_that_does_what_it_says(module, name, text, names, monkeypatch):
    assert "Examples\n--------\n>>> " in text
    if name in OF_GMSH and missing_gmsh():
        pytest.skip("there is no Gmsh")
    monkeypatch.setenv("THINPART_CACHE", names["samples"] + "-cache")
    example = doctest.DocTestParser().get_doctest(
        text, {**names, **vars(importlib.import_module(module))}, name, module, 0)
    said = []
    doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(example, out=said.append)
    if said:
        pytest.fail("".join(said), pytrace=False)


def test_there_are_functions():
    assert len(FUNCTIONS) > 40
