# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which solids of a document are its parts, and where they stand."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from thinpart_workbench.freecad_adapter.reading.document_parts import document_parts, part_at


def names(document):
    document.recompute()
    return {(part.label, part.instances) for part in document_parts(document)}


def box(document, name, size=10):
    made = document.addObject("Part::Box", name)
    made.Length = made.Width = made.Height = size
    return made


def test_what_another_shape_was_made_from_is_no_part(document):
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = box(document, "Base", 20), box(document, "Tool", 5)
    assert names(document) == {("Cut", 1)}


def test_a_body_is_one_part_and_its_features_are_none(document):
    body = document.addObject("PartDesign::Body", "Body")
    body.newObject("PartDesign::AdditiveBox", "Block")
    body.newObject("PartDesign::SubtractiveCylinder", "Hole")
    assert names(document) == {("Body", 1)}


def test_a_sketch_on_a_face_and_a_binder_use_nothing_up(document):
    base = box(document, "Base", 20)
    document.recompute()
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    attachment = "AttachmentSupport" if hasattr(sketch, "AttachmentSupport") else "Support"
    setattr(sketch, attachment, (base, ["Face6"]))
    body = document.addObject("PartDesign::Body", "Body")
    body.newObject("PartDesign::AdditiveBox", "Block")
    binder = body.newObject("PartDesign::SubShapeBinder", "Binder")
    binder.Support = [(base, ("Face1",))]
    assert names(document) == {("Base", 1), ("Body", 1)}


def test_links_are_instances_of_one_part(document):
    source = box(document, "Bolt")
    for k in range(3):
        link = document.addObject("App::Link", f"Link{k}")
        link.LinkedObject = source
        link.Placement.Base.x = 50 * (k + 1)
    assert names(document) == {("Bolt", 4)}
    source.Visibility = False
    assert {instances for _, instances in names(document)} == {3}


def test_link_array(document):
    source = box(document, "Bolt")
    source.Visibility = False
    array = document.addObject("App::Link", "Array")
    array.LinkedObject = source
    array.ElementCount = 5
    assert {instances for _, instances in names(document)} == {5}


def test_placements_of_nested_containers_are_applied(document, freecad):
    inner = document.addObject("App::Part", "Inner")
    outer = document.addObject("App::Part", "Outer")
    inner.addObject(box(document, "Box"))
    outer.addObject(inner)
    inner.Placement.Base = freecad.Vector(0, 100, 0)
    outer.Placement.Base = freecad.Vector(1000, 0, 0)
    document.recompute()
    part, = document_parts(document)
    assert tuple(part.shape.BoundBox.Center) == pytest.approx((1005, 105, 5))
    place, = part.occurrences
    assert (place.root, place.path) == ("Outer", "Inner.Box.")
    assert part_at([part], "Outer", "Inner.Box.Face3") is part
    assert part_at([part], "Outer", "Inner.Other.") is None


def test_a_linked_container_gives_its_contents_again(document):
    container = document.addObject("App::Part", "Unit")
    container.addObject(box(document, "Box"))
    link = document.addObject("App::Link", "Second")
    link.LinkedObject = container
    link.Placement.Base.x = 77
    assert names(document) == {("Box", 2)}


def test_groups_are_looked_into(document):
    group = document.addObject("App::DocumentObjectGroup", "Group")
    group.addObject(box(document, "Box"))
    assert names(document) == {("Box", 1)}


def test_several_solids_of_one_object(document):
    import FreeCAD
    import Part

    feature = document.addObject("Part::Feature", "Pair")
    feature.Shape = Part.Compound([
        Part.makeBox(1, 2, 3), Part.makeBox(4, 5, 6, FreeCAD.Vector(20, 0, 0))])
    assert names(document) == {("Pair (1)", 1), ("Pair (2)", 1)}
    assert [part.name for part in document_parts(document)] == ["Pair.Solid1", "Pair.Solid2"]


def test_a_hidden_leftover_is_left_out_unless_nothing_else_is_there(document):
    hidden = box(document, "Old")
    hidden.Visibility = False
    assert names(document) == {("Old", 1)}
    box(document, "New", 7)
    assert names(document) == {("New", 1)}


def test_a_hidden_body_is_a_part_all_the_same(document):
    body = document.addObject("PartDesign::Body", "Body")
    body.newObject("PartDesign::AdditiveBox", "Block")
    body.Visibility = False
    box(document, "Box", 33)
    assert names(document) == {("Body", 1), ("Box", 1)}


def test_a_mirror_image_stands_beside_its_source(document):
    source = box(document, "Left")
    mirror = document.addObject("Part::Mirroring", "Right")
    mirror.Source = source
    assert {label for label, _ in names(document)} == {"Left", "Right"}


def test_a_mesh_in_a_document_is_a_part(document, freecad):
    import Mesh

    feature = document.addObject("Mesh::Feature", "Scan")
    feature.Mesh = Mesh.createBox(10, 10, 10)
    feature.Placement.Base = freecad.Vector(100, 0, 0)
    document.recompute()
    part, = document_parts(document)
    assert part.points[:, 0].min() > 90


def test_a_mesh_in_containers_and_links_stands_where_they_put_it(document, freecad):
    import Mesh

    feature = document.addObject("Mesh::Feature", "Scan")
    feature.Mesh = Mesh.createBox(10, 10, 10)
    feature.Placement.Base = freecad.Vector(0, 0, 7)
    container = document.addObject("App::Part", "Unit")
    container.addObject(feature)
    container.Placement.Base = freecad.Vector(1000, 0, 0)
    group = document.addObject("App::DocumentObjectGroup", "Group")
    group.addObject(container)
    document.recompute()
    part, = document_parts(document)
    assert part.points.mean(axis=0) == pytest.approx([1000, 0, 7], abs=1e-3)
    link = document.addObject("App::Link", "Second")
    link.LinkedObject = feature
    link.Placement.Base = freecad.Vector(0, 500, 0)
    document.recompute()
    middles = {tuple(part.points.mean(axis=0).round(3)) for part in document_parts(document)}
    assert (1000, 0, 7) in middles and any(abs(y - 500) < 1e-3 for _, y, _ in middles)


def test_null_shapes_and_surfaces_are_no_parts(document):
    import Part

    document.addObject("Part::Feature", "Null")
    document.addObject("Part::Feature", "Face").Shape = Part.makePlane(5, 5)
    assert names(document) == set()


@pytest.mark.parametrize("use_link", [False, True])
def test_an_array_of_draft_is_read_from_its_file(tmp_path, document, use_link):
    """In a process of its own: only there the module of the array is not loaded yet."""
    import Draft
    import FreeCAD

    source = box(document, "Bolt")
    document.recompute()
    step = FreeCAD.Vector
    Draft.make_ortho_array(source, v_x=step(30, 0, 0), v_y=step(0, 30, 0), v_z=step(0, 0, 30),
                           n_x=3, n_y=2, n_z=1, use_link=use_link)
    source.Visibility = False
    document.recompute()
    file = tmp_path / "array.FCStd"
    document.saveAs(str(file))
    root = Path(__file__).resolve().parents[2]
    run = subprocess.run(
        [sys.executable, "-m", "thinpart_workbench", "classify", str(file), "--json", "--no-info"],
        env=dict(os.environ, PYTHONPATH=str(root)), capture_output=True, encoding="utf-8")
    record, = map(json.loads, run.stdout.splitlines())
    assert (record["category"], record["instances"]) == ("normal", 6)
