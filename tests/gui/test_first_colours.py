# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first, coarse colours: before the map, in its place, and what becomes of them where there is no map."""

import contextlib
import os
import signal

import FreeCAD as App
import FreeCADGui as Gui
import Part
import thickness_window
import window_actions as window
from window_actions import V

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.view3d.picking import add_probe

HOLES = 2
"""Each way: measured in less than a second, so that the first colours are seen before."""

COARSE = "The colours in the view are the first, coarse ones"


def first_colours(document):
    """The FirstColours in a document, or None."""
    return lifelong.map_events.first_colours.get(document.Name)


def wait_for_first_colours(document, drawn=1):
    """Wait until as many parts are coloured coarsely and have taken the place of their objects."""
    window.wait_until(lambda: first_colours(document) is not None and len(first_colours(document).coloured) == drawn,
                      "the first colours")
    window.settle(50)
    return first_colours(document)


@contextlib.contextmanager
def stopped_worker():
    """The worker does nothing more until the end, so that the first colours are there as long as a test looks at them."""
    worker, = window.workers()
    os.kill(worker, signal.SIGSTOP)
    try:
        yield worker
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.kill(worker, signal.SIGCONT)


def is_covered(source):
    """Whether an object is left out of the view although it is switched on."""
    return source.ViewObject.Visibility and source.ViewObject.SwitchNode.whichChild.getValue() == -1


def add_sieve(document):
    """A part that takes a second to measure, seen from a corner."""
    sieve = window.add(document, "Sieve", window.slow_shape(HOLES))
    thickness_window.look_at(document)
    return sieve


def camera_of(view):
    """Where the camera is and looks."""
    camera = view.getCameraNode()
    return camera.position.getValue().getValue(), camera.orientation.getValue().getValue()


def coloured_pixels(document, folder):
    """How many pixels of the view have the colours of a map: most of the red is thin, and FreeCAD's part is grey."""
    image = thickness_window.picture(thickness_window.view_of(document), folder, 300, 200, "White")
    found = 0
    for x in range(0, 300, 3):
        for y in range(0, 200, 3):
            colour = image.pixelColor(x, y)
            found += max(colour.red(), colour.green(), colour.blue()) - min(
                colour.red(), colour.green(), colour.blue()) > 60
    return found


def test_coarse_colours_come_first_and_the_map_takes_their_place(document, tmp_path):
    sieve = add_sieve(document)
    Gui.Selection.addSelection(document.Name, "Sieve", "Face3")
    view = thickness_window.view_of(document)
    camera = camera_of(view)
    assert coloured_pixels(document, tmp_path) < 20
    window.press("ThinPart_ShowThickness")
    first = wait_for_first_colours(document)
    with stopped_worker():
        assert thickness_objects(document) == [] and document.UndoNames == []
        assert is_covered(sieve) and coloured_pixels(document, tmp_path) > 100
        assert first.bar.is_coarse and camera_of(view) == camera
        assert window.text("ThinPart_FirstColours").startswith("First, coarse colours; finer ones follow")
        assert not window.is_shown("ThinPart_ThicknessVerdict"), "nothing is judged by coarse colours"
    window.wait_until(window.is_thickness_told)
    thickness, = thickness_objects(document)
    window.wait_until(lambda: first_colours(document) is None)
    window.settle(50)
    assert thickness.ViewObject.Proxy.is_complete and is_covered(sieve)
    assert coloured_pixels(document, tmp_path) > 100 and camera_of(view) == camera
    assert Gui.Selection.getSelectionEx(document.Name)[0].SubElementNames == ("Face3",)
    assert not window.is_shown("ThinPart_FirstColours") and COARSE not in window.text("ThinPart_Message")
    mapped, = parts_of(thickness)
    assert mapped.map.count > 10_000 and mapped.record["category"]


def test_there_is_never_a_moment_without_colours(document):
    sieve = add_sieve(document)
    window.press("ThinPart_ShowThickness")
    wait_for_first_colours(document)
    seen = []

    def look():
        maps = [each for each in thickness_objects(document) if each.ViewObject.Proxy.is_drawn]
        seen.append((first_colours(document) is not None) + len(maps))
        return window.is_thickness_told() and first_colours(document) is None

    window.wait_until(look)
    assert set(seen) == {1}, "neither none of the two nor both in the same place"
    assert is_covered(sieve)


def test_cancel_keeps_the_coarse_colours_and_says_so_at_once(document, tmp_path):
    sieve = add_sieve(document)
    window.press("ThinPart_ShowThickness")
    wait_for_first_colours(document)
    with stopped_worker():  # one that does nothing is not waited for either
        window.click("ThinPart_CancelButton")
        assert window.text("ThinPart_Message").startswith("Cancelled. Nothing was changed.")
        assert COARSE in window.text("ThinPart_Message") and not window.is_shown("ThinPart_Progress")
    window.wait_until(lambda: window.workers() == [])
    assert first_colours(document) is not None and is_covered(sieve) and coloured_pixels(document, tmp_path) > 100
    assert thickness_objects(document) == [] and document.UndoNames == []
    window.mouse_click(window.close_button())
    window.wait_until(lambda: first_colours(document) is None and not is_covered(sieve))
    assert coloured_pixels(document, tmp_path) < 20


def test_after_cancel_measuring_again_makes_the_map(document):
    add_sieve(document)
    window.press("ThinPart_ShowThickness")
    wait_for_first_colours(document)
    window.click("ThinPart_CancelButton")
    window.click("ThinPart_AgainButton")
    window.wait_until(window.is_thickness_told)
    window.wait_until(lambda: first_colours(document) is None)
    assert len(thickness_objects(document)) == 1 and window.text("ThinPart_Message") == ""


def test_a_second_click_begins_anew_with_one_set_of_colours(document):
    add_sieve(document)
    window.press("ThinPart_ShowThickness")
    before = wait_for_first_colours(document)
    children = thickness_window.view_of(document).getSceneGraph().getNumChildren()
    window.press("ThinPart_ShowThickness")
    window.wait_until(lambda: first_colours(document) not in (None, before), "the colours of the second click")
    window.settle(50)
    assert thickness_window.view_of(document).getSceneGraph().getNumChildren() == children
    window.wait_until(window.is_thickness_told)
    assert len(thickness_objects(document)) == 1


def test_closing_the_document_ends_them(document):
    name = document.Name
    add_sieve(document)
    window.press("ThinPart_ShowThickness")
    wait_for_first_colours(document)
    App.closeDocument(name)
    window.wait_until(lambda: not Gui.Control.activeDialog() and window.workers() == [])
    assert lifelong.map_events.first_colours == {}


def test_a_part_that_changes_loses_them_and_is_seen_as_it_is(document):
    sieve = add_sieve(document)
    window.press("ThinPart_ShowThickness")
    wait_for_first_colours(document)
    with stopped_worker():
        sieve.Shape = Part.makeBox(40, 30, 7)
        document.recompute()
        window.wait_until(lambda: first_colours(document) is None and not is_covered(sieve))
    window.wait_until(window.is_thickness_told)
    assert "changed while it was measured" in window.text("ThinPart_Message")
    assert COARSE not in window.text("ThinPart_Message") and thickness_objects(document) == []


def test_a_part_that_is_moved_loses_them(document):
    sieve = add_sieve(document)
    window.press("ThinPart_ShowThickness")
    wait_for_first_colours(document)
    with stopped_worker():
        sieve.Placement.Base.x = 20
        window.wait_until(lambda: first_colours(document) is None and not is_covered(sieve))


def test_a_fine_stage_that_fails_leaves_the_coarse_colours(document):
    sieve = add_sieve(document)
    window.press("ThinPart_ShowThickness")
    wait_for_first_colours(document)
    with stopped_worker() as worker:
        os.kill(worker, signal.SIGKILL)
    window.wait_until(window.is_thickness_told)
    assert "ended unexpectedly" in window.text("ThinPart_Message") and COARSE in window.text("ThinPart_Message")
    assert first_colours(document) is not None and is_covered(sieve) and thickness_objects(document) == []


def test_an_assembly_is_coloured_wherever_its_parts_stand(document):
    both = window.add(document, "Both", Part.makeCompound([window.slow_shape(HOLES), Part.makeBox(40, 30, 9, V(0, 0, 60))]))
    plate = window.add(document, "Plate", Part.makeBox(40, 30, 4, V(-60, 0, 0)))
    link = document.addObject("App::Link", "Copy")
    link.LinkedObject = plate
    link.Placement.Base.x = -60
    document.recompute()
    thickness_window.look_at(document)
    window.press("ThinPart_ShowThickness")
    first = wait_for_first_colours(document, drawn=3)
    with stopped_worker():
        assert first.covered == {"Both", "Plate", "Copy"} and all(map(is_covered, (both, plate, link)))
        assert sorted(len(part.matrices) for part in first.coloured) == [1, 1, 2]
    window.wait_until(window.is_thickness_told)
    window.wait_until(lambda: first_colours(document) is None)
    assert len(parts_of(thickness_objects(document)[0])) == 3


def test_triangles_are_coloured_too(document):
    import Mesh
    import MeshPart

    soup = document.addObject("Mesh::Feature", "Soup")
    soup.Mesh = Mesh.Mesh(MeshPart.meshFromShape(Shape=window.slow_shape(HOLES), LinearDeflection=0.05))
    document.recompute()
    window.press("ThinPart_ShowThickness")
    first = wait_for_first_colours(document)
    with stopped_worker():
        assert first.covered == {"Soup"} and is_covered(soup)
    window.wait_until(window.is_thickness_told)
    assert len(thickness_objects(document)) == 1


def test_a_map_that_is_up_to_date_is_not_replaced_by_a_coarser_one(document):
    window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.show_thickness()
    window.wait_until(lambda: first_colours(document) is None)
    Gui.Selection.clearSelection()
    window.press("ThinPart_ShowThickness")
    seen = []
    window.wait_until(lambda: seen.append(first_colours(document)) or window.is_thickness_told())
    assert set(seen) == {None} and len(thickness_objects(document)) == 1


def test_an_outdated_map_gives_way_and_keeps_its_pins_and_its_scale(document):
    plate = window.add(document, "Plate", Part.makeBox(70, 70, 4))
    window.show_thickness()
    thickness, = thickness_objects(document)
    add_probe(thickness, (20, 15, 0), (20, 15, 4), 4.0)
    thickness.AutomaticRange, thickness.Low, thickness.High, thickness.ColourMap = False, 1.0, 9.0, "magma"
    plate.Shape = window.slow_shape(HOLES)
    document.recompute()
    window.settle(100)
    assert thickness.Stale
    window.click("ThinPart_AgainButton")
    first = wait_for_first_colours(document)
    with stopped_worker():
        assert not thickness.ViewObject.Proxy.is_drawn and is_covered(plate)
        assert (first.colours.scale.low, first.colours.scale.high, first.colours.scale.colour_map) == (1.0, 9.0, "magma")
        assert thickness.ProbeValues == [4.0]
    window.wait_until(lambda: not thickness.Stale)
    window.wait_until(lambda: first_colours(document) is None)
    assert thickness.ViewObject.Proxy.is_drawn and not lifelong.map_events.first_colours
    assert (thickness.Low, thickness.High) == (1.0, 9.0)
