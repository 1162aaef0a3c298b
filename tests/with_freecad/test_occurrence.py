# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where something occurs: the way to it, what it leads through, what stands there and where."""

import numpy as np
import pytest

from thinpart_workbench.freecad_adapter.occurrence import (
    Occurrence,
    matrix_at,
    object_at,
    objects_along,
    shape_at,
    split_at_element,
)
from thinpart_workbench.freecad_adapter.reading.document_parts import document_parts
from thinpart_workbench.freecad_adapter.shapes.placements import matrix_array, placement_matrix


@pytest.fixture
def nested(document, freecad):
    """A plate within a container within another one, links to both, and an array of links."""
    import Part

    plate = document.addObject("Part::Feature", "Plate")
    plate.Shape = Part.makeBox(40, 30, 4)
    plate.Placement.Base = freecad.Vector(1, 2, 3)
    inner, outer = document.addObject("App::Part", "Inner"), document.addObject("App::Part", "Outer")
    inner.addObject(plate)
    outer.addObject(inner)
    inner.Placement.Base = freecad.Vector(100, 0, 0)
    outer.Placement = freecad.Placement(freecad.Vector(0, 200, 0), freecad.Rotation(freecad.Vector(0, 0, 1), 90))
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = outer
    link.Placement.Base = freecad.Vector(0, 0, 500)
    array = document.addObject("App::Link", "Array")
    array.LinkedObject = plate
    array.ElementCount = 2
    array.PlacementList = [freecad.Placement(freecad.Vector(x, 0, 900), freecad.Rotation()) for x in (0, 70)]
    document.recompute()
    return document


def test_every_way_leads_to_the_plate(nested):
    part, = document_parts(nested)
    names = []
    for place in part.occurrences:
        top = place.top(nested)
        way, end = objects_along(top, place.path), object_at(top, place.path)
        assert way[0] == top and way[-1] == end
        assert (end.getLinkedObject(True) or end).Name == "Plate"
        shape = shape_at(top, place.path)
        assert shape.Solids[place.solid].isPartner(part.shape)
        assert np.allclose(placement_matrix(shape.Placement), matrix_array(matrix_at(top, place.path)))
        names.append([each.Name for each in way][:2])
    assert names[:2] == [["Outer", "Inner"], ["Link", "Inner"]] and [top for top, *_ in names[2:]] == ["Array", "Array"]


def test_a_place_is_within_its_containers_and_around_its_faces():
    place = Occurrence("Outer", "Inner.Plate.", 0)
    for path in ("Inner.Plate.", "Inner.Plate.Face3"):
        assert place.is_around("Outer", path) and not place.is_around("Link", path)
    assert not place.is_around("Outer", "Inner.") and not place.is_around("Outer", "Inner.Plate001.")
    assert place.is_within("Outer", "Inner.") and place.is_within("Outer", "") and not place.is_within("Link", "")
    assert not place.is_within("Outer", "Inner.Plate.Face3")


def test_what_is_gone(nested):
    assert Occurrence("Gone", "", 0).top(nested) is None
    outer = nested.getObject("Outer")
    assert object_at(outer, "Inner.Gone.") is None
    assert objects_along(outer, "") == [outer] and object_at(outer, "") == outer


@pytest.mark.parametrize("path, way, element", [
    ("Inner.Plate.Face3", "Inner.Plate.", "Face3"), ("Inner.Plate.", "Inner.Plate.", ""),
    ("Face3", "", "Face3"), ("", "", ""),
])
def test_the_name_of_a_face_ends_a_path(path, way, element):
    assert split_at_element(path) == (way, element)
