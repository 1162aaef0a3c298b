# SPDX-License-Identifier: LGPL-2.1-or-later
"""A library of info files that no CAD program is needed for."""

import copy
import json
import os
import random
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import made_meshes

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.record.part_record import part_record
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.core.walls.face_thickness import face_thicknesses
from thinpart_workbench.core.walls.thinnest_place import WallErrors
from thinpart_workbench.storage.info.info_file import info_content, info_path, new_source, write_info

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


@cache
def _record(shape):
    return measured_record(shape, SHAPES[shape]())


def measured_record(label, shape, settings=AnalysisSettings(minimum_samples=2000)):
    """The part record of a shape of `made_meshes`."""
    mesh = surface_mesh(*shape)
    measurement = measure(mesh, settings)
    verdict = classify(measurement.descriptors, PAPER)
    part = SimpleNamespace(name="Solid1", label=label, instances=1, warnings=(), face_surfaces=None)
    record = part_record(part, mesh, measurement, verdict, verdict,
                         face_thicknesses(measurement.field, 5.0), WallErrors(0.01, 0.01, 0.01), 0.0)
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
    source = new_source(document, info_file=info)
    content = info_content(source, AnalysisSettings().content(), PAPER.content, records, list(failures))
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


def make_large_library(folder, info_files, count, files_per_folder=500):
    """Write `count` info files without documents: the given ones in other sizes, under other names.

    Parameters
    ----------
    folder : Path
    info_files : list of Path
    count : int
    """
    chance = random.Random(1)
    models = [json.loads(Path(each).read_bytes()) for each in info_files]
    for content in models:
        for part in content["parts"]:
            part["faces"] = []
    for number in range(count):
        content = copy.copy(models[number % len(models)])
        name = f"part {number:06d}.step"
        content["source"] = {**content["source"], "file": name, "sha256": f"{number:064x}",
                             "modified": f"20{10 + number % 16}-03-01T10:00:00.000000+00:00"}
        factor = 10.0 ** chance.uniform(-1.0, 1.0)
        content["parts"] = [_varied(part, factor, number, chance) for part in content["parts"]]
        place = Path(folder, f"{number // files_per_folder:04d}")
        if number % files_per_folder == 0:
            place.mkdir(parents=True)
        (place / f"{name}.thinpart.json").write_text(json.dumps(content), encoding="utf-8")


def _varied(part, factor, number, chance):
    measured = dict(part["descriptors"])
    measured["box_mm"] = [side * factor for side in measured["box_mm"]]
    measured["diagonal_mm"] *= factor
    measured["thickness_mm"] = {key: value and value * factor
                                for key, value in measured["thickness_mm"].items()}
    measured["box_axes"] = [list(axis) for axis in measured["box_axes"]]
    if measured["volume_ratio"]:
        measured["volume_ratio"] *= chance.uniform(0.5, 1.0)
    thinnest = {key: value * factor if key.endswith("_mm") and value else value
                for key, value in part["thinnest"].items()}
    return {**part, "descriptors": measured, "thinnest": thinnest, "label": f"{part['label']} {number}",
            "margin": chance.uniform(-0.2, 2.0), "borderline": chance.random() < 0.1,
            "notes": f"order {number}" if number % 10 == 0 else ""}
