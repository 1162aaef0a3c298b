# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which feature made each face of a part."""

import json
import os
import subprocess
import sys
from collections import Counter

import pytest
from program import ROOT

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.features import feature_history as history_module
from thinpart_workbench.freecad_adapter.features.face_features import face_features
from thinpart_workbench.freecad_adapter.features.feature_history import feature_history
from thinpart_workbench.freecad_adapter.objects.snapshot import write_snapshot
from thinpart_workbench.freecad_adapter.reading.document_parts import document_parts
from thinpart_workbench.storage.map_file import read_maps

WORKER = "thinpart_workbench.window_processes.snapshot_worker"


def made_by(document, label=None):
    """How many faces each feature made, of the only part or of the one with a label."""
    document.recompute()
    assert all("Invalid" not in each.State for each in document.Objects)
    part, = [each for each in document_parts(document) if label in (None, each.label)]
    return Counter(face_features(part.shape, feature_history(part)))


def place(freecad, x=0, y=0, z=0, angle=0):
    return freecad.Placement(freecad.Vector(x, y, z), freecad.Rotation(freecad.Vector(1, 2, 3), angle))


def box(document, name, *size):
    made = document.addObject("Part::Box", name)
    made.Length, made.Width, made.Height = size
    return made


def rectangle(body, name, low, high, height):
    import FreeCAD
    import Part

    sketch = body.newObject("Sketcher::SketchObject", name)
    (x, y), (right, top) = low, high
    corners = [FreeCAD.Vector(*each) for each in ((x, y), (right, y), (right, top), (x, top))]
    for k in range(4):
        sketch.addGeometry(Part.LineSegment(corners[k], corners[(k + 1) % 4]))
    sketch.Placement.Base.z = height
    return sketch


def body_with_history(document):
    """A pad with a pocket, which is repeated twice, and a fillet over one of the pad's edges."""
    body = document.addObject("PartDesign::Body", "Body")
    pad = body.newObject("PartDesign::Pad", "Pad")
    pad.Profile, pad.Length = rectangle(body, "Outline", (0, 0), (80, 30), 0), 10
    document.recompute()
    pocket = body.newObject("PartDesign::Pocket", "Pocket")
    pocket.Profile, pocket.Length = rectangle(body, "Window", (5, 5), (15, 25), 10), 4
    document.recompute()
    pattern = body.newObject("PartDesign::LinearPattern", "LinearPattern")
    pattern.Originals = [pocket]
    pattern.Direction = (body.Origin.OriginFeatures[0], [""])
    pattern.Length, pattern.Occurrences = 50, 3
    body.Tip = pattern
    document.recompute()
    fillet = body.newObject("PartDesign::Fillet", "Fillet")
    edge = next(f"Edge{k + 1}" for k, each in enumerate(pattern.Shape.Edges)
                if each.BoundBox.XMin > 79 and each.BoundBox.ZMin > 9)
    fillet.Base, fillet.Radius = (pattern, [edge]), 2
    body.Tip = fillet
    return body


IN_BODY = {"Pad": 6, "Pocket": 5, "LinearPattern": 10, "Fillet": 1}


def test_the_features_of_a_body(document):
    body_with_history(document)
    assert made_by(document) == IN_BODY


def test_a_body_that_was_moved_and_lies_in_a_moved_container(document, freecad):
    body = body_with_history(document)
    body.Placement = place(freecad, 100, 20, -3, 40)
    container = document.addObject("App::Part", "Unit")
    container.addObject(body)
    container.Placement = place(freecad, -7, 300, 9, 75)
    assert made_by(document) == IN_BODY


def test_a_link_to_a_body(document, freecad):
    body = body_with_history(document)
    body.Visibility = False
    link = document.addObject("App::Link", "Second")
    link.LinkedObject = body
    link.Placement = place(freecad, 500, 0, 0, 30)
    assert made_by(document) == IN_BODY


def cut_of_fuse(document, freecad):
    fuse = document.addObject("Part::Fuse", "Fuse")
    fuse.Base, fuse.Tool = box(document, "Plate", 40, 40, 5), box(document, "Rib", 4, 40, 20)
    fuse.Tool.Placement.Base.x = 18
    bore = document.addObject("Part::Cylinder", "Bore")
    bore.Radius, bore.Height = 2, 10
    bore.Placement.Base = freecad.Vector(8, 8, -2)
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = fuse, bore
    return cut


def test_what_a_cut_and_a_fuse_were_made_from(document, freecad):
    cut_of_fuse(document, freecad)
    found = made_by(document)
    assert found["Bore"] == 1 and set(found) == {"Plate", "Rib", "Bore"}
    assert found["Rib"] >= 3


def test_every_object_of_a_cut_may_be_moved_as_a_whole(document, freecad):
    cut = cut_of_fuse(document, freecad)
    before = made_by(document)
    cut.Base.Placement = place(freecad, 3, 1, 2, 10)
    cut.Placement = place(freecad, 30, 10, 20, 50)
    moved = made_by(document)
    assert moved["Bore"] == before["Bore"] and moved["Rib"] == before["Rib"]


def test_a_fillet_of_a_moved_box_is_told_from_the_box(document, freecad):
    base = box(document, "Box", 10, 20, 30)
    base.Placement = place(freecad, 4, 5, 6, 20)
    fillet = document.addObject("Part::Fillet", "Fillet")
    fillet.Base = base
    fillet.Edges = [(1, 1.0, 1.0)]
    fillet.Placement = place(freecad, 0, 50, 0, 60)
    assert made_by(document) == {"Box": 6, "Fillet": 1}


def test_a_link_as_the_tool_of_a_cut(document, freecad):
    bore = document.addObject("Part::Cylinder", "Bore")
    bore.Radius, bore.Height = 2, 30
    bore.Placement.Base = freecad.Vector(500, 0, 0)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = bore
    link.Placement = freecad.Placement(freecad.Vector(10, 10, -5), freecad.Rotation())
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = box(document, "Box", 20, 20, 20), link
    assert made_by(document, "Cut") == {"Box": 6, "Bore": 1}


def test_a_body_that_starts_from_another_object(document, freecad):
    base = box(document, "Block", 20, 20, 20)
    base.Placement = place(freecad, 50, 0, 0, 25)
    body = document.addObject("PartDesign::Body", "Body")
    body.BaseFeature = base
    document.recompute()
    fillet = body.newObject("PartDesign::Fillet", "Fillet")
    fillet.Base, fillet.Radius = (body.Tip if body.Tip != fillet else body.Group[0], ["Edge1"]), 2
    body.Tip = fillet
    body.Placement = place(freecad, 0, 0, 33, 40)
    assert made_by(document, "Body") == {"Block": 6, "Fillet": 1}


def test_a_boolean_of_two_bodies(document, freecad):
    first = document.addObject("PartDesign::Body", "First")
    block = first.newObject("PartDesign::AdditiveBox", "Block")
    block.Length = block.Width = block.Height = 20
    second = document.addObject("PartDesign::Body", "Second")
    bore = second.newObject("PartDesign::AdditiveCylinder", "Bore")
    bore.Radius, bore.Height = 2, 40
    second.Placement.Base = freecad.Vector(10, 10, -10)
    document.recompute()
    boolean = first.newObject("PartDesign::Boolean", "Boolean")
    boolean.setObjects([second])
    boolean.Type = "Cut"
    first.Tip = boolean
    assert made_by(document, "First") == {"Block": 6, "Bore": 1}


@pytest.mark.parametrize("shaped", [True, False])
def test_what_was_imported_has_no_features(document, shaped):
    import Part

    feature = document.addObject("Part::Feature", "Import")
    feature.Shape = Part.makeBox(1, 2, 3)
    if shaped:
        assert made_by(document) == {}
    else:
        cut = document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = feature, box(document, "Notch", 0.5, 0.5, 9)
        assert made_by(document) == {"Import": 6, "Notch": 2}


def test_a_history_that_is_cut_off_names_nothing_that_it_does_not_know(document, freecad, monkeypatch):
    cut_of_fuse(document, freecad)
    monkeypatch.setattr(history_module, "MOST_FEATURES", 2)
    made = made_by(document)
    part, = document_parts(document)
    assert made == {"": len(part.shape.Faces)}


def job_line(folder):
    return json.dumps({"folder": str(folder), "megabytes": 6000}).encode() + b"\n"


def in_worker(part, folder, shapes):
    """The features that the worker finds in a snapshot with so many shapes of the history."""
    steps = write_snapshot([part], str(folder), AnalysisSettings(), load_profile("paper").content, maps="ray")
    for _ in range(shapes):
        next(steps)
    run = subprocess.run([sys.executable, "-m", WORKER], input=job_line(folder),
                         env=dict(os.environ, PYTHONPATH=str(ROOT)), capture_output=True)
    line, = [each["map"] for each in map(json.loads, run.stdout.splitlines()) if "map" in each]
    mapped, = read_maps(line["file"])
    return Counter(mapped.features)


def test_the_worker_finds_the_features_of_a_snapshot(document, tmp_path):
    body_with_history(document)
    document.recompute()
    part, = document_parts(document)
    assert in_worker(part, tmp_path, 4) == IN_BODY


def test_a_snapshot_that_was_not_written_to_its_end_has_no_features(document, freecad, tmp_path):
    cut_of_fuse(document, freecad)
    document.recompute()
    part, = document_parts(document)
    assert in_worker(part, tmp_path, 2) == {}


def test_the_worker_waits_for_the_end_of_its_input(document, freecad, tmp_path):
    cut_of_fuse(document, freecad)
    document.recompute()
    part, = document_parts(document)
    steps = write_snapshot([part], str(tmp_path), AnalysisSettings(), load_profile("paper").content, maps="ray")
    worker = subprocess.Popen([sys.executable, "-m", WORKER], stdin=subprocess.PIPE,
                              env=dict(os.environ, PYTHONPATH=str(ROOT)), stdout=subprocess.PIPE)
    try:
        worker.stdin.write(job_line(tmp_path))
        worker.stdin.flush()
        while "record" not in json.loads(worker.stdout.readline()):
            pass
        list(steps)
        worker.stdin.close()
        line, = [each["map"] for each in map(json.loads, worker.stdout) if "map" in each]
    finally:
        worker.kill()
        worker.wait()
        worker.stdout.close()
    mapped, = read_maps(line["file"])
    assert set(mapped.features) == {"Plate", "Rib", "Bore"}
