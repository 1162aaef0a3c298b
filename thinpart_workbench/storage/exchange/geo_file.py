# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes element sizes as a script for Gmsh."""

import io

import numpy as np

from ...core.foreign_text import gmsh_text
from ...core.kinds.file_marks import SCRIPT
from ..output_file import write_output


def geo_text(global_size, boxes, part_file=None, order=1, options=()):
    """The script: the geometry, if Gmsh can open it, a background field, and the settings that belong to it, str.

    Gmsh reference manual, 1.4.8 and 6.3.2: sizes of the background field alone count where those of points, of curvature
    and of the boundary are switched off.

    Parameters
    ----------
    global_size : float, mm
    boxes : SizeBoxes or None
        None for a uniform size.
    part_file : str, optional
        Path of the geometry, as the script says it; see `gmsh_shape.is_opened_as_shape`.
    order : int
        Of the elements.
    options : iterable of (str, number)
        Further options of Gmsh, such as ``Mesh.Algorithm``.
    """
    text = io.StringIO()
    text.write("// Element sizes in mm, by ThinPart: open this file in Gmsh.\n")
    if part_file is None:
        text.write("// Open the part first, in mm, and then merge this file.\n")
    else:
        text.write(f"Merge {gmsh_text(part_file)};\n")
    if boxes is not None:
        text.write('View "element size, mm" {\n')
        rows = np.concatenate([boxes.corners.reshape(-1, 24), boxes.sizes], axis=1)
        form = "SH(" + ",".join(["%.9g"] * 24) + "){" + ",".join(["%.5g"] * 8) + "};"
        np.savetxt(text, rows, fmt=form)
        text.write("};\nView[PostProcessing.NbViews - 1].Visible = 0;\n")
        text.write("Field[1] = PostView;\nField[1].ViewIndex = PostProcessing.NbViews - 1;\nBackground Field = 1;\n")
        for name in ("FromPoints", "FromCurvature", "ExtendFromBoundary"):
            text.write(f"Mesh.MeshSize{name} = 0;\n")
    text.write(f"Mesh.MeshSizeMax = {global_size:.9g};\nMesh.ElementOrder = {order};\n")
    for name, value in options:
        text.write(f"{name} = {value:g};\n")
    return text.getvalue()


def faces_text(part_file, sizes):
    """The script for a mesh of faces, each of a size of its own, str.

    The sizes hold at the corners of the faces, from where edges take theirs; within, a face has the largest triangles that
    its edges allow: those extended from the boundary would be as small as the shortest edge of a large face, all over it.

    Parameters
    ----------
    part_file : str
        BREP file, as the script says it.
    sizes : ndarray of shape (number of faces,), mm
    """
    lines = ['SetFactory("OpenCASCADE");', f"Merge {gmsh_text(part_file)};", "Mesh.MeshSizeExtendFromBoundary = 0;",
             f"Mesh.MeshSizeMax = {max(sizes):.9g};"]
    # The last one counts where faces share a corner: the smallest.
    lines += [f"MeshSize {{ PointsOf{{ Surface{{{row + 1}}}; }} }} = {sizes[row]:.9g};"
              for row in np.argsort(-np.asarray(sizes), kind="stable")]
    return "\n".join(lines) + "\n"


def write_geo(path, global_size, boxes, part_file=None, order=1, options=(), overwrite=False, inputs=()):
    """Write the script, with `overwrite` and `inputs` as in `write_output`; an OSError leaves what was there."""
    text = geo_text(global_size, boxes, part_file, order, options)
    write_output(path, SCRIPT.sealed(text.encode()), SCRIPT, overwrite, inputs)
