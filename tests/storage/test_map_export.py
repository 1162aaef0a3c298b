# SPDX-License-Identifier: LGPL-2.1-or-later
"""Maps for other programs: read back as the formats are defined."""

import base64
import os
import xml.etree.ElementTree as ElementTree

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.maps.mapped_part import MappedPart
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rendering.colour_scale import ColourScale
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.storage.exchange.map_export import PLY, VTP, write_map_file


@pytest.fixture(scope="module")
def parts():
    """A ribbed block at two places."""
    shown = thickness_map(measure(surface_mesh(*made_meshes.ribbed_block()), AnalysisSettings()))
    moved = np.eye(4)
    moved[:3, 3] = 200.0, 0.0, 0.0
    return [MappedPart({}, shown, [], np.stack([np.eye(4), moved]))]


def arrays_of(path):
    root = ElementTree.parse(path).getroot()
    assert root.get("type") == "PolyData" and root.get("byte_order") == "LittleEndian"
    found = {}
    for section in root.find("PolyData/Piece"):
        for array in section:
            data = base64.b64decode(array.text)
            assert int(np.frombuffer(data, "<u4", 1)[0]) == len(data) - 4
            values = np.frombuffer(data, {"Float32": "<f4", "Int32": "<i4"}[array.get("type")], offset=4)
            found[section.tag, array.get("Name")] = values.reshape(-1, int(array.get("NumberOfComponents")))
    return root.find("PolyData/Piece").attrib, found


def test_polydata_has_points_facets_and_values(parts, tmp_path):
    write_map_file(tmp_path / "map.vtp", VTP, parts, None)
    sizes, arrays = arrays_of(tmp_path / "map.vtp")
    shown, count = parts[0].map, 2 * parts[0].map.count
    assert int(sizes["NumberOfPolys"]) == count and int(sizes["NumberOfPoints"]) == 3 * count
    points = arrays["Points", "Points"]
    assert points[:3 * shown.count] == pytest.approx((shown.corners + shown.origin).reshape(-1, 3), abs=1e-4)
    assert np.ptp(points[:, 0]) == pytest.approx(260.0, rel=1e-4)
    assert (arrays["Polys", "connectivity"].ravel() == np.arange(3 * count)).all()
    assert (arrays["Polys", "offsets"].ravel() == 3 * np.arange(1, count + 1)).all()
    assert arrays["PointData", "thickness_mm"].ravel()[:3 * shown.count] == pytest.approx(
        shown.corner_thickness.ravel(), nan_ok=True)
    assert set(np.unique(arrays["CellData", "face"])) == {int(face) + 1 for face in np.unique(shown.face)}
    assert set(np.unique(arrays["CellData", "part"])) == {1}


def test_ply_has_colours_and_thickness(parts, tmp_path):
    scale = ColourScale(0.0, 60.0)
    write_map_file(tmp_path / "map.ply", PLY, parts, scale.of_corners)
    head, body = (tmp_path / "map.ply").read_bytes().split(b"end_header\n", 1)
    lines = head.decode("ascii").splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"]
    count = 2 * parts[0].map.count
    assert f"element vertex {3 * count}" in lines and f"element face {count}" in lines
    vertex = np.dtype([("point", "<f4", 3), ("colour", "u1", 3), ("thickness", "<f4")])
    vertices = np.frombuffer(body, vertex, 3 * count)
    assert (vertices["colour"] == scale.colours(vertices["thickness"])).all()
    faces = np.frombuffer(body, np.dtype([("number", "u1"), ("corners", "<i4", 3)]), count, vertex.itemsize * 3 * count)
    assert (faces["number"] == 3).all() and (faces["corners"].ravel() == np.arange(3 * count)).all()


def test_what_was_there_stays_where_it_cannot_be_written(parts, tmp_path):
    (tmp_path / "folder.vtp").mkdir()
    with pytest.raises(ThinPartError, match="cannot be written"):
        write_map_file(tmp_path / "folder.vtp", VTP, parts, None)
    with pytest.raises(OSError):
        write_map_file(tmp_path / "no such folder" / "map.ply", PLY, parts, ColourScale(0.0, 1.0).of_corners)
    assert os.listdir(tmp_path) == ["folder.vtp"]
