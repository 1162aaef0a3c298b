# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes thickness maps for other programs: VTK PolyData (.vtp) and Stanford PLY, both with the values."""

import base64
import struct
from typing import Callable, NamedTuple

import numpy as np

from ...core.file_formats import FORMATS
from ...core.kinds.file_marks import MAPS, PLY_COMMENT, VTP_COMMENT
from ...core.message import Message, message
from ..output_file import write_output

VTP = ".vtp"
PLY, = next(each.endings for each in FORMATS if each.name == "PLY")
"""Endings of the formats."""


class MapFormat(NamedTuple):
    """A format for triangles with values.

    Attributes
    ----------
    title : Message
        Its name in the window, with its ending as file dialogs want it.
    use : str
        What it is for, in the help of the command line.
    content : callable
        Gives the bytes of a file, of a list of MappedPart and `colours` as of `ply_bytes`.
    """

    title: Message
    use: str
    content: Callable


def write_map_file(path, ending, parts, colours, overwrite=False):
    """Write maps as one of `MAP_FORMATS`; see there, and `write_output`."""
    write_output(path, MAP_FORMATS[ending].content(parts, colours), MAPS[ending], overwrite)


def vtp_bytes(parts, _colours=None):
    """Maps, list of MappedPart, as VTK PolyData: bytes, with the thickness at points and cells, face and part of each cell.

    VTK File Formats, XML PolyData, inline binary (base64) data. Facets share no points: the thickness may jump between them.
    """
    corners, at_corners, of_facet, face, part = _joined(parts)
    count = len(of_facet)
    offsets = 3 * np.arange(1, count + 1, dtype=np.int32)
    return "\n".join([
        '<?xml version="1.0"?>',
        '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" header_type="UInt32">',
        VTP_COMMENT, "<PolyData>",
        f'<Piece NumberOfPoints="{3 * count}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" '
        f'NumberOfPolys="{count}">',
        '<PointData Scalars="thickness_mm">', _array("thickness_mm", at_corners.ravel()), "</PointData>",
        "<CellData>", _array("thickness_mm", of_facet), _array("face", face), _array("part", part), "</CellData>",
        "<Points>", _array("Points", corners.reshape(-1, 3), 3), "</Points>",
        "<Polys>", _array("connectivity", np.arange(3 * count, dtype=np.int32)), _array("offsets", offsets), "</Polys>",
        "</Piece>", "</PolyData>", "</VTKFile>", ""]).encode("ascii")


def ply_bytes(parts, colours):
    """Maps as binary PLY, with thickness and colour at vertices: bytes.

    G. Turk, The PLY Polygon File Format, 1994. The thickness is nan where nothing was measured.

    Parameters
    ----------
    parts : list of MappedPart
    colours : callable
        Gives the colours at the corners of the facets, ndarray of shape (m, 3, 3), uint8, of the number of a part among
        these and its ThicknessMap.
    """
    corners, at_corners, _, _, _ = _joined(parts)
    count = len(corners)
    vertices = np.empty(3 * count, dtype=[("point", "<f4", 3), ("colour", "u1", 3), ("thickness", "<f4")])
    vertices["point"], vertices["thickness"] = corners.reshape(-1, 3), at_corners.ravel()
    vertices["colour"] = np.concatenate([np.tile(colours(number, part.map).reshape(-1, 3), (len(part.matrices), 1))
                                         for number, part in enumerate(parts)])
    faces = np.empty(count, dtype=[("number", "u1"), ("corners", "<i4", 3)])
    faces["number"], faces["corners"] = 3, np.arange(3 * count).reshape(-1, 3)
    head = "\n".join([
        "ply", "format binary_little_endian 1.0", PLY_COMMENT, f"element vertex {3 * count}",
        *(f"property float {axis}" for axis in "xyz"), *(f"property uchar {name}" for name in ("red", "green", "blue")),
        "property float thickness", f"element face {count}", "property list uchar int vertex_indices", "end_header", ""])
    return head.encode("ascii") + vertices.tobytes() + faces.tobytes()


MAP_FORMATS = {
    VTP: MapFormat(message("VTK PolyData with thickness (*.vtp)"),
                   "triangles with the thickness at every corner, for ParaView and VTK", vtp_bytes),
    PLY: MapFormat(message("PLY with thickness and colours (*.ply)"),
                   "the same with colours, for MeshLab, Blender and others", ply_bytes),
}
"""By ending. Each has a mark in `core.kinds.file_marks.MAPS`, by which its files are known as ThinPart's own."""


def _joined(parts):
    """Corners, thickness at corners, of facets, face from 1 and part from 1, of all occurrences."""
    columns = []
    for number, part in enumerate(parts):
        shown = part.map
        corners = shown.corners + shown.origin
        for matrix in part.matrices:
            placed = corners @ matrix[:3, :3].T + matrix[:3, 3]
            columns.append((placed.astype("<f4"), shown.corner_thickness.astype("<f4"), shown.thickness.astype("<f4"),
                            shown.face.astype("<i4") + 1, np.full(shown.count, number + 1, dtype="<i4")))
    return tuple(np.concatenate(column) for column in zip(*columns))


def _array(name, values, components=1):
    kind = {"f": "Float32", "i": "Int32"}[values.dtype.kind]
    content = np.ascontiguousarray(values).tobytes()
    data = base64.b64encode(struct.pack("<I", len(content)) + content).decode("ascii")
    return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="binary">{data}</DataArray>'
