"""Libraries of many info files, made by varying a few."""

import copy
import json
import random
from pathlib import Path
from types import SimpleNamespace

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.classification import classify
from thinpart_workbench.core.criteria import load_profile
from thinpart_workbench.core.measurement import measure
from thinpart_workbench.core.part_record import part_record
from thinpart_workbench.core.surface_mesh import surface_mesh
from thinpart_workbench.storage.info_file import info_content

PAPER = load_profile("paper")


def make_library(folder, info_files, count, files_per_folder=500):
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


def measured_info(folder, name, shape):
    """The info file of a shape of `made_meshes`, measured and written; its path."""
    mesh = surface_mesh(*shape)
    measurement = measure(mesh, AnalysisSettings())
    verdict = classify(measurement.descriptors, PAPER)
    part = SimpleNamespace(name=name, label=name, instances=1, warnings=())
    record = part_record(part, mesh, measurement, verdict, verdict, [], 0.0, 0.0)
    source = {"file": f"{name}.step", "sha256": "0" * 64, "bytes": 1, "modified": "2020-01-01"}
    path = folder / f"{name}.step.thinpart.json"
    path.write_text(json.dumps(info_content(source, {}, PAPER.content, [record])))
    return path


def _varied(part, factor, number, chance):
    measured = dict(part["descriptors"])
    measured["box_mm"] = [side * factor for side in measured["box_mm"]]
    measured["diagonal_mm"] *= factor
    measured["thickness_mm"] = {key: value and value * factor
                                for key, value in measured["thickness_mm"].items()}
    measured["box_axes"] = [list(axis) for axis in measured["box_axes"]]
    if measured["volume_ratio"]:
        measured["volume_ratio"] *= chance.uniform(0.5, 1.0)
    return {**part, "descriptors": measured, "label": f"{part['label']} {number}",
            "margin": chance.uniform(-0.2, 2.0), "borderline": chance.random() < 0.1,
            "notes": f"order {number}" if number % 10 == 0 else ""}
