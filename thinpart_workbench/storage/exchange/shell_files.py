# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes shells for other programs: CalculiX and Abaqus (.inp), Gmsh (.msh) and I-DEAS universal files (.unv)."""

import io
import os
from dataclasses import replace

import numpy as np

from ...core.foreign_text import head_text
from ...core.kinds.file_marks import SHELLS
from ..output_file import write_output

_UNV_ORDER = {3: (0, 1, 2), 6: (0, 3, 1, 4, 2, 5)}
"""Nodes of a triangle as universal files have them: along its outline."""


def write_shell(path, shell, label, overwrite=False, inputs=(), solid=None):
    """Write a ShellMesh as `write_output` does, in the format of `SHELL_FORMATS` that the ending of the path says.

    The label of the part, str, stands in the head of the file. A SolidMesh that is tied to the shell is written too where
    the format is one of `MIXED_FORMATS`.
    """
    about = f"Mid-surface of {head_text(label)} with the thickness of its walls, by ThinPart"
    ending = os.path.splitext(os.fspath(path))[1].lower()
    mark = SHELLS[ending]
    text = SHELL_FORMATS[ending](shell, about) if solid is None else MIXED_FORMATS[ending](shell, solid, about)
    write_output(path, mark.sealed(text.encode()), mark, overwrite, inputs)


def inp_text(shell, about):
    """Nodes, elements S3 or S6, and a section for each thickness, str.

    CalculiX CrunchiX user's manual 2.20, *NODE, *ELEMENT, *SHELL SECTION, *NODAL THICKNESS. Sections refer to a material
    that stands for any: steel, in mm, N and tonnes. Walls of which the thickness varies have it at their nodes: where
    neighbours have sections of their own, CalculiX makes a rigid knot of each node between them.
    """
    text, tapered = io.StringIO(), np.flatnonzero(shell.is_tapered)
    even = np.setdiff1d(np.arange(len(shell.triangles)), tapered)
    section, thickness = replace(shell, triangles=shell.triangles[even], wall=shell.wall[even],
                                 thickness=shell.thickness[even]).sections()
    text.write(f"** {about}\n** mm, N, t. The material is steel: replace it by that of the part.\n*NODE, NSET=SHELL\n")
    np.savetxt(text, np.column_stack([np.arange(1, len(shell.points) + 1), shell.points]), fmt="%d,%.9g,%.9g,%.9g")
    width = shell.triangles.shape[1]
    sets = [(f"SECTION{number + 1}", even[section == number]) for number in range(len(thickness))]
    for name, rows in [*sets, ("TAPERED", tapered)] if len(tapered) else sets:
        text.write(f"*ELEMENT, TYPE=S{width}, ELSET={name}\n")
        np.savetxt(text, np.column_stack([rows + 1, shell.triangles[rows] + 1]), fmt="%d", delimiter=",")
    for number in np.unique(shell.wall):
        text.write(f"*ELSET, ELSET=WALL{number + 1}\n")
        np.savetxt(text, np.flatnonzero(shell.wall == number) + 1, fmt="%d,")
    text.write("*MATERIAL, NAME=STEEL\n*ELASTIC\n210000,0.3\n*DENSITY\n7.85e-9\n")
    for number, value in enumerate(thickness):
        text.write(f"*SHELL SECTION, ELSET=SECTION{number + 1}, MATERIAL=STEEL\n{value:.6g}\n")
    if len(tapered):
        node, value = shell.node_thickness(tapered)
        text.write(f"*SHELL SECTION, ELSET=TAPERED, MATERIAL=STEEL, NODAL THICKNESS\n{np.median(value):.6g}\n"
                   "*NODAL THICKNESS\n")
        np.savetxt(text, np.column_stack([node + 1, value]), fmt="%d,%.6g")
    return text.getvalue()


def mixed_text(shell, solid, about):
    """The shell as of `inp_text`, tetrahedra C3D10 of the same material, and a tie between them, str.

    CalculiX CrunchiX user's manual 2.20, *SURFACE and *TIE: the nodes of the solid on the cut follow the sides 3 to 5 of
    the elements of the shell, which CalculiX makes wedges of. They are not moved: a joint of walls is no plane.

    Parameters
    ----------
    shell : ShellMesh
        Of second order.
    solid : SolidMesh
    about : str
    """
    text, nodes, elements = io.StringIO(), len(shell.points), len(shell.triangles)
    text.write(inp_text(shell, about))
    text.write("*NODE, NSET=SOLIDNODES\n")
    rows = np.arange(len(solid.points)) + nodes + 1
    np.savetxt(text, np.column_stack([rows, solid.points]), fmt="%d,%.9g,%.9g,%.9g")
    text.write("*ELEMENT, TYPE=C3D10, ELSET=SOLID\n")
    # Gmsh has the last two nodes of a tetrahedron the other way round.
    tetrahedra = solid.tetrahedra[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]] + nodes + 1
    np.savetxt(text, np.column_stack([np.arange(len(tetrahedra)) + elements + 1, tetrahedra]), fmt="%d", delimiter=",")
    text.write("*SOLID SECTION, ELSET=SOLID, MATERIAL=STEEL\n*NSET, NSET=CUT\n")
    np.savetxt(text, solid.tied + nodes + 1, fmt="%d,")
    text.write("*SURFACE, NAME=SOLIDCUT, TYPE=NODE\nCUT\n*SURFACE, NAME=SHELLEND\n")
    text.write("".join(f"{row + 1},S{side + 3}\n" for row, side in solid.sides.tolist()))
    tolerance = float(shell.thickness[solid.sides[:, 0]].max())
    text.write(f"*TIE, NAME=WALLS, POSITION TOLERANCE={tolerance:.6g}, ADJUST=NO\nSOLIDCUT,SHELLEND\n")
    return text.getvalue()


def msh_text(shell, about):
    """Nodes and elements with a physical group for each wall, and the thickness as element data, str.

    Gmsh reference manual, 10.2: MSH file format version 2, as text.
    """
    text, count = io.StringIO(), len(shell.triangles)
    walls = np.unique(shell.wall)
    text.write(f"$Comments\n{about}\n$EndComments\n$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{len(walls)}\n")
    text.write("".join(f'2 {number + 1} "wall {number + 1}"\n' for number in walls))
    text.write(f"$EndPhysicalNames\n$Nodes\n{len(shell.points)}\n")
    np.savetxt(text, np.column_stack([np.arange(1, len(shell.points) + 1), shell.points]), fmt="%d %.12g %.12g %.12g")
    text.write(f"$EndNodes\n$Elements\n{count}\n")
    kind = {3: 2, 6: 9}[shell.triangles.shape[1]]
    numbers = np.arange(1, count + 1)
    np.savetxt(text, np.column_stack([numbers, np.full(count, kind), np.full(count, 2), shell.wall + 1, shell.wall + 1,
                                      shell.triangles + 1]), fmt="%d")
    text.write(f'$EndElements\n$ElementData\n1\n"thickness, mm"\n1\n0\n3\n0\n1\n{count}\n')
    np.savetxt(text, np.column_stack([numbers, shell.thickness]), fmt="%d %.6g")
    text.write("$EndElementData\n")
    return text.getvalue()


def unv_text(shell, about):
    """Nodes, thin shell elements, and a group for each thickness that is named after it, str.

    I-DEAS universal file datasets 2411, 2412 (91: linear, 92: parabolic thin shell triangle) and 2467, as the SDRC
    documents of the University of Cincinnati describe them. The number of an element's physical property is that of its
    group, since there is no common dataset for the thickness. Lengths are in mm, as the head says. Dataset 164 would say so
    too, but with its documented factor of 1000, FreeCAD reads millimetres as metres.
    """
    text, (section, thickness) = io.StringIO(), shell.sections()
    text.write(f"    -1\n   151\n{about[:80]}\nLengths in mm, by ThinPart\nThinPart\n\n\n\n\n    -1\n")
    text.write("    -1\n  2411\n")
    for number, point in enumerate(shell.points):
        text.write(f"{number + 1:10d}{1:10d}{1:10d}{11:10d}\n" + "".join(f"{value:25.16E}" for value in point).replace(
            "E", "D") + "\n")
    text.write("    -1\n    -1\n  2412\n")
    width = shell.triangles.shape[1]
    kind, ordered = {3: 91, 6: 92}[width], shell.triangles[:, _UNV_ORDER[width]] + 1
    for number, (own, nodes) in enumerate(zip(section, ordered)):
        text.write("".join(f"{value:10d}" for value in (number + 1, kind, own + 1, 1, 7, width)) + "\n"
                   + "".join(f"{node:10d}" for node in nodes) + "\n")
    text.write("    -1\n    -1\n  2467\n")
    for number, value in enumerate(thickness):
        rows = np.flatnonzero(section == number) + 1
        text.write("".join(f"{each:10d}" for each in (number + 1, 0, 0, 0, 0, 0, 0, len(rows))) + "\n"
                   + f"thickness_{value:.4g}_mm\n")
        entries = [f"{8:10d}{row:10d}{0:10d}{0:10d}" for row in rows]
        text.write("\n".join("".join(entries[start:start + 2]) for start in range(0, len(entries), 2)) + "\n")
    text.write("    -1\n")
    return text.getvalue()


SHELL_FORMATS = {".inp": inp_text, ".msh": msh_text, ".unv": unv_text}
"""What writes each format, by the ending."""

MIXED_FORMATS = {".inp": mixed_text}
"""The same for a shell with solids that are tied to it."""
