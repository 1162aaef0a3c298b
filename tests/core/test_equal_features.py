# SPDX-License-Identifier: LGPL-2.1-or-later
"""Equal features of a part look the same: one row, one kind, one colour."""

from collections import Counter

import made_library
import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.equal_walls import WallSize, are_equal, are_on_equal_faces
from thinpart_workbench.core.forms.equal_faces import equal_faces
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.record.region_groups import region_groups
from thinpart_workbench.core.record.thin_faces import thin_face_colours
from thinpart_workbench.core.sizing.size_groups import size_groups
from thinpart_workbench.core.sizing.size_proposal import propose_sizes
from thinpart_workbench.core.sizing.sizing_settings import SizingSettings
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.workflow.meshing.part_sizing import PartSizing

FULL = AnalysisSettings()
PLACES = {"as made": {}, "turned": {"rotation": Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()}}


def comb(ribs=24, rib=2.0, gap=4.0, height=15.0, base=20.0, length=50.0):
    """A block with ribs."""
    pitch = rib + gap
    outline = [(0.0, 0.0), (ribs * pitch - gap, 0.0)]
    for number in reversed(range(ribs)):
        left, right = number * pitch, number * pitch + rib
        outline += [(right, base), (right, base + height), (left, base + height), (left, base)]
    return made_meshes.prism([outline[0], outline[1], *outline[3:-1]], length)


def gear(teeth=24, radius=40.0, height=9.0, width=10.0):
    """A disc with teeth that narrow to half of their width."""
    turns = [((number + share) * 2.0 * np.pi / teeth, far) for number in range(teeth) for share, far in (
        (-0.25, radius), (-0.125, radius + height), (0.125, radius + height), (0.25, radius))]
    return made_meshes.prism([(far * np.cos(angle), far * np.sin(angle)) for angle, far in turns], width)


def perforated(columns=8, rows=3, pitch=8.0, radius=2.5, thickness=1.5, beside=30.0, steps=32):
    """A sheet with round holes, more of it beside one end: points, triangles and the face of each triangle.

    The holes are the faces from 6 on; the first ones are the sides of the sheet.
    """
    angle = (np.arange(steps) + 0.5) * 2.0 * np.pi / steps + np.pi / 4.0 - np.pi / steps
    around = np.column_stack([np.cos(angle), np.sin(angle)])
    square = around * (0.5 * pitch / np.abs(around).max(axis=1))[:, None]
    points, triangles, faces = [], [], []
    for column in range(columns):
        for row in range(rows):
            middle, border = np.array([column * pitch, row * pitch]), square.copy()
            if column == columns - 1:
                border[np.isclose(border[:, 0], 0.5 * pitch), 0] += beside
            flat = np.concatenate([middle + radius * around, middle + border])
            start = sum(map(len, points))
            points.append(np.column_stack([np.tile(flat, (2, 1)), np.repeat([0.0, thickness], 2 * steps)]))
            here = np.arange(steps)
            there = (here + 1) % steps
            for low, high, face in ((0, steps, 0), (2 * steps, 3 * steps, 1), (2 * steps, 0, 6 + column * rows + row)):
                a, b, c, d = here + low, here + high, there + high, there + low
                found = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
                triangles.append(start + (found if face == 1 else found[:, ::-1]))
                faces.append(np.full(len(found), face))
            ends = [(column == 0, 2, 0, -1.0), (column == columns - 1, 3, 0, 1.0), (row == 0, 4, 1, -1.0),
                    (row == rows - 1, 5, 1, 1.0)]
            for is_end, face, axis, side in ends:
                at_end = np.abs(square[:, axis] - side * 0.5 * pitch) < 1e-9
                pairs = here[at_end & at_end[there]] if is_end else here[:0]
                a, b = pairs + steps, there[pairs] + steps
                c, d = b + 2 * steps, a + 2 * steps
                triangles.append(start + np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]))
                faces.append(np.full(2 * len(pairs), face))
    return np.concatenate(points), np.concatenate(triangles), np.concatenate(faces)


@pytest.mark.parametrize("place", PLACES)
def test_all_ribs_are_one_row(place):
    groups = region_groups(made_library.measured_record("comb", made_meshes.moved(comb(), **PLACES[place]), FULL))
    assert [(group.kind, group.count) for group in groups] == [("plate", 24), ("bar", 1)]
    assert groups[0].least == pytest.approx(2.0, rel=0.01)


@pytest.mark.parametrize("place", PLACES)
def test_all_teeth_are_one_row_and_one_colour(place):
    record = made_library.measured_record("gear", made_meshes.moved(gear(), **PLACES[place]), FULL)
    assert [(group.kind, group.count) for group in region_groups(record)] == [("tooth", 24), ("plate", 1)]
    assert [group.word for group in region_groups(record)] == ["tooth", "plate"]
    assert record["descriptors"]["regions"]["tooth"] == 24
    equal = Counter(face["equal_to"] or face["face"] for face in record["faces"])
    # Flanks, of which both of a tooth are alike, crests and roots, and both sides of the disc.
    assert sorted(equal.values()) == [2, 24, 24, 48]
    for limit in np.linspace(1.0, 20.0, 8):
        shown = {**record, "faces": [{**face, "thin_share": 1.0 if (face["median"] or 99.0) < limit else 0.0}
                                     for face in record["faces"]]}
        colours = thin_face_colours(shown, "red", "orange")
        of_class = {(face["equal_to"] or face["face"], colours.get(int(face["face"][4:]) - 1)) for face in record["faces"]}
        assert len(of_class) == len(equal)


LAYERED = SizingSettings(order=1)


@pytest.mark.parametrize("settings", [SizingSettings(), LAYERED])
@pytest.mark.parametrize("made, kind", [(comb, "plate"), (gear, "tooth")])
def test_equal_walls_have_one_row_of_sizes_and_one_size(made, kind, settings):
    measured = measure(surface_mesh(*made()), FULL)
    rows = PartSizing(measured, 10.0).proposed(settings, {})["regions"]
    row, = (row for row in rows if len(row["regions"]) > 1)
    assert row["kind"] == kind and len(row["regions"]) == 24 and row["region"] == row["regions"][0]
    listed = measured.regions.listed
    assert set(row["faces"]) == {face for number in row["regions"] for face in listed[number].faces}
    proposal = propose_sizes(measured, 10.0, settings)
    own = [each for each in proposal.regions if each.number in row["regions"]]
    assert min(each.size for each in own) <= row["size"] <= max(each.size for each in own)
    assert row["elements"] == sum(each.elements for each in own)
    assert sorted(number for each in rows for number in each["regions"]) == sorted(
        each.number for each in proposal.regions)


def test_a_size_for_a_row_holds_for_all_of_its_walls_and_one_with_another_size_is_apart():
    measured = measure(surface_mesh(*comb()), FULL)
    sizing = PartSizing(measured, 10.0)
    row, = (row for row in sizing.proposed(LAYERED, {})["regions"] if row["kind"] == "plate")
    wanted = dict.fromkeys(row["regions"], 0.5)
    row, = (row for row in sizing.proposed(LAYERED, wanted)["regions"] if row["kind"] == "plate")
    assert row["size"] == pytest.approx(0.5) and row["regions"] == list(wanted)
    proposal = propose_sizes(measured, 10.0, LAYERED, wanted)
    assert {round(each.size, 9) for each in proposal.regions if each.number in wanted} == {0.5}
    other = row["regions"][3]
    rows = [row for row in sizing.proposed(LAYERED, {**wanted, other: None})["regions"] if row["kind"] == "plate"]
    assert [(len(row["regions"]), row["size"] is None) for row in rows] == [(23, False), (1, True)]
    assert rows[1]["regions"] == [other] and rows[1]["proposed_size"] is not None
    groups = size_groups(measured, proposal)
    assert sum(len(group.numbers) for group in groups) == len(measured.regions.listed)


def test_rows_of_sizes_are_called_what_the_rows_of_walls_are():
    measured = measure(surface_mesh(*made_meshes.ribbed_block()), FULL)
    group, *_ = size_groups(measured, propose_sizes(measured, 10.0, LAYERED))
    assert (group.word, group.kind, group.count) == ("rib", "plate", 1)
    row, = PartSizing(measured, 10.0).proposed(LAYERED, {})["regions"]
    assert (row["word"], row["count"]) == ("rib", 1)


def test_rows_of_ribs_are_listed_beyond_twenty_and_none_is_left_out():
    found = measure(surface_mesh(*comb(ribs=40)), FULL).regions
    assert len(found.listed) == 41 and (found.others, found.others_share) == (0, 0.0)
    assert found.counts["plate"] == 40


@pytest.mark.parametrize("place", PLACES)
def test_holes_of_a_sheet_are_equal_also_beside_an_edge(place):
    points, triangles, face = perforated()
    mesh = surface_mesh(*made_meshes.moved((points, triangles), **PLACES[place]), face, of_solid=True)
    assert mesh.watertight
    measured = measure(mesh, FULL)
    assert set(measured.equal_faces[6:].tolist()) == {6}
    assert len(set(measured.equal_faces[:6].tolist())) == 3, "each is equal to the one opposite"


def test_walls_of_one_outline_and_another_thickness_are_not_equal():
    """A box of which one wall is thicker than the others: outside, its sides cannot be told apart."""
    hollow = made_meshes.inverted(made_meshes.moved(made_meshes.box(90, 94, 94), shift=(8, 3, 3)))
    measured = measure(surface_mesh(*made_meshes.joined(made_meshes.box(100, 100, 100), hollow)), FULL)
    equal, mesh = measured.equal_faces, measured.field.mesh
    outside = {face: mesh.normals[mesh.face_of_triangle == face][0] for face in range(int(mesh.face_of_triangle.max()) + 1)
               if np.abs(mesh.corners[mesh.face_of_triangle == face]).max() > 49.9}
    assert len(outside) == 6
    thick = [face for face, normal in outside.items() if normal[0] < -0.9]
    assert len(thick) == 1 and sum(equal == equal[thick[0]]) == 1


def test_a_spring_is_one_row_with_one_colour():
    turn = np.linspace(0, 2 * np.pi * 6, 360)
    coil = made_meshes.wire(np.column_stack([15 * np.cos(turn), 15 * np.sin(turn), 6.0 * turn / (2 * np.pi)]), 1.0)
    record = made_library.measured_record("spring", coil)
    group, = region_groups(record)
    assert (group.kind, group.count) == ("bar", 1)


def test_a_sliver_of_a_face_does_not_colour_it():
    record = {"descriptors": {"area_mm2": 300.0}, "faces": [
        {"face": "Face1", "thin_share": 0.011, "area_mm2": 100.0}, {"face": "Face2", "thin_share": 0.03, "area_mm2": 100.0}]}
    assert thin_face_colours(record, "red", "orange") == {1: "orange"}


def test_equal_faces_have_the_colour_of_all_of_them():
    faces = [("Face1", 1.0, None), ("Face2", 0.0, "Face1"), ("Face4", 0.8, "Face1"), ("Face5", 0.0, None)]
    record = {"descriptors": {"area_mm2": 50.0}, "faces": [
        {"face": name, "thin_share": share, "equal_to": equal, "area_mm2": 10.0} for name, share, equal in faces]}
    assert thin_face_colours(record, "red", "orange") == {0: "red", 1: "red", 3: "red"}


def test_an_open_surface_has_equal_faces_too():
    points, triangles = made_meshes.box(10, 10, 2)
    mesh = surface_mesh(points, triangles[2:])
    assert len(equal_faces(mesh)) == 5


PIN = WallSize("block", 0.48, 0.48, 1.10, 0.52, 1.15, (0.5, 12.0))


@pytest.mark.parametrize("other, equal", [
    (PIN, True),
    (WallSize("bar", 0.48, 0.485, 1.13, 0.50, 1.10, (0.501, 12.0)), True),  # a threshold of the kind away
    (WallSize("block", 0.48, 0.48, 1.30, 0.42, 1.10, (0.5, 12.0)), True),  # another way along it was found
    (WallSize("block", 0.48, 0.48, 1.10, 0.52, 1.15, (0.7, 13.0)), True),  # other faces, the same measures
    (WallSize("bar", 0.48, 0.48, 1.10, 0.52, 1.15, (0.7, 13.0)), False),
    (WallSize("block", 0.48, 0.48, 1.30, 0.42, 1.10, (0.7, 13.0)), False),
    (WallSize("block", 0.48, 0.52, 1.10, 0.52, 1.15, (0.5, 12.0)), False),  # thicker
    (WallSize("block", 0.30, 0.48, 1.10, 0.52, 1.15, (0.5, 12.0)), False),  # thinner at a place
    (WallSize("block", 0.48, 0.48, 1.40, 0.60, 1.60, (0.5, 12.0)), False),  # larger
    (WallSize("tooth", 0.40, 0.46, 1.10, 0.52, 1.15, (0.5, 12.0)), True),
    (WallSize("tooth", 0.48, 0.48, 1.10, 0.52, 1.15, (0.7, 13.0)), False)])
def test_which_walls_are_equal(other, equal):
    assert are_equal(PIN, other) is equal and are_equal(other, PIN) is equal


@pytest.mark.parametrize("one, other, equal", [
    ((), (), False), ((1.0, 2.0), (1.0, 2.0), True), ((1.0, 2.0), (1.005, 2.01), True), ((1.0, 2.0), (1.0, 3.0), False),
    ((1.0, 1.0, 1.0, 2.0), (1.0, 1.0, 2.0), True), ((1.0, 1.0, 5.0), (1.0, 1.0, 2.0), False)])
def test_faces_at_the_border_may_be_missing(one, other, equal):
    assert are_on_equal_faces(one, other) is equal


def test_faces_of_one_facet_each_are_compared():
    corners = np.array([[0.0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]])
    mesh = surface_mesh(corners, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]), np.arange(4))
    assert equal_faces(mesh).tolist() == [0, 0, 2, 0]
