"""A library of info files that no CAD program is needed for."""

import copy
import os
from functools import lru_cache
from types import SimpleNamespace

import made_meshes
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.classification import classify
from thinpart_workbench.core.criteria import load_profile
from thinpart_workbench.core.face_thickness import face_thicknesses
from thinpart_workbench.core.measurement import measure
from thinpart_workbench.core.part_record import part_record
from thinpart_workbench.core.surface_mesh import surface_mesh
from thinpart_workbench.storage.info_file import info_content, info_path, new_source, write_info

PAPER = load_profile("paper")
SHAPES = {
    "plate": lambda: made_meshes.box(100, 100, 2),
    "long_plate": lambda: made_meshes.box(240, 60, 3),
    "cube": lambda: made_meshes.box(10, 10, 10),
    "ribbed_block": made_meshes.ribbed_block,
    "wedge": made_meshes.wedge,
    "tube": made_meshes.tube,
    "open_box": lambda: (made_meshes.box(10, 10, 10)[0], made_meshes.box(10, 10, 10)[1][2:]),
}
CATEGORIES = {"plate": "thin", "long_plate": "thin", "cube": "normal", "open_box": "unknown"}


@lru_cache(maxsize=None)
def _record(shape):
    mesh = surface_mesh(*SHAPES[shape]())
    measurement = measure(mesh, AnalysisSettings(minimum_samples=2000))
    verdict = classify(measurement.descriptors, PAPER)
    part = SimpleNamespace(name="Solid1", label=shape, instances=1, warnings=())
    record = part_record(part, mesh, measurement, verdict, verdict,
                         face_thicknesses(measurement.field, 5.0), 0.01, 0.0)
    return {**record, "seconds": {"read": 0.0, "tessellate": 0.0, "measure": 0.0}}


def record_of(shape, **changes):
    """A part record of one of `SHAPES`, with some keys changed."""
    return {**copy.deepcopy(_record(shape)), **changes}


def store(folder, name, records, failures=(), info_folder=None):
    """Write a document, which no program could read, and its info file; the latter's path."""
    os.makedirs(folder, exist_ok=True)
    document = folder / name
    document.write_bytes(b"geometry of " + os.fsencode(name))
    info = info_path(document, info_folder)
    content = info_content(new_source(document, info_file=info), AnalysisSettings().content(), PAPER.content,
                           records, list(failures))
    write_info(info, content)
    return info


def make_library(folder):
    """One document per shape, in two folders, one with two parts and a failure."""
    for number, shape in enumerate(SHAPES):
        store(folder / f"group {number % 2}", f"{shape}.step", [record_of(shape)])
    failure = {"part": "Solid3", "label": "broken", "kind": "no_solid", "message": "broken bounds no solid."}
    store(folder, "assembly.step", [
        record_of("plate", name="Solid1", label="Deckel Süd", instances=4),
        record_of("cube", name="Solid2", label="foot"),
    ], [failure])
    return folder
