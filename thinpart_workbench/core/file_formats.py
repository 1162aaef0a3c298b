# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one table of file formats that ThinPart reads."""

import os
from dataclasses import dataclass

DOCUMENT, SHAPE, MESH = "document", "shape", "mesh"
"""Kinds of files: FreeCAD documents, exact shapes (B-Rep), and triangles."""


@dataclass(frozen=True)
class FileFormat:
    """A format.

    Attributes
    ----------
    name : str
        Shown to people; for documents, the name of the program.
    kind : str
        `DOCUMENT`, `SHAPE` or `MESH`.
    endings : tuple of str
        In lower case, with the dot.
    has_text : bool
        Whether some or all files of the format hold numbers as text.
    is_recent : bool
        Whether FreeCAD 0.20 cannot read it, only later versions.
    gmsh_spellings : tuple of str
        Spellings of the endings with which Gmsh opens a file as a shape. Whatever is in such a file, none of it is run;
        files with other spellings, such as ``.Step`` and ``.BREP``, are scripts for it (tried with Gmsh 4.8 and 4.15).
    """

    name: str
    kind: str
    endings: tuple
    has_text: bool = False
    is_recent: bool = False
    gmsh_spellings: tuple = ()

    @property
    def choice(self):
        """str: the key of `CHOICES` that includes this format; all meshes are one choice."""
        return "Mesh" if self.kind == MESH else self.name


FORMATS = (
    FileFormat("FreeCAD", DOCUMENT, (".fcstd",)),
    FileFormat("STEP", SHAPE, (".step", ".stp"), has_text=True, gmsh_spellings=(".step", ".STEP", ".stp", ".STP")),
    FileFormat("IGES", SHAPE, (".iges", ".igs"), has_text=True, gmsh_spellings=(".iges", ".IGES", ".igs", ".IGS")),
    FileFormat("BREP", SHAPE, (".brep", ".brp"), has_text=True, gmsh_spellings=(".brep", ".brp")),
    FileFormat("STL", MESH, (".stl",), has_text=True),
    FileFormat("OBJ", MESH, (".obj",), has_text=True),
    FileFormat("PLY", MESH, (".ply",), has_text=True),
    FileFormat("OFF", MESH, (".off",), has_text=True),
    FileFormat("3MF", MESH, (".3mf",), is_recent=True),
)

ENDINGS = tuple(ending for file_format in FORMATS for ending in file_format.endings)
"""Endings of all formats."""

INFO_ENDING = ".thinpart.json"
"""Ending of info files, behind the name of their document."""

CHOICES = {
    name: tuple(ending for file_format in FORMATS if file_format.choice == name for ending in file_format.endings)
    for name in dict.fromkeys(file_format.choice for file_format in FORMATS)}
"""The formats that a user can choose for a folder, with the file name endings of each choice."""


def format_of(path):
    """Find the format of a file by its name; None where there is none."""
    name = os.fspath(path).lower()
    return next((file_format for file_format in FORMATS if name.endswith(file_format.endings)), None)


def is_document(path):
    """Whether a file is a FreeCAD document, by its name."""
    found = format_of(path)
    return found is not None and found.kind == DOCUMENT


def is_shape(path):
    """Whether a file has exact shapes, by its name; mesh generators open these as geometry."""
    found = format_of(path)
    return found is not None and found.kind == SHAPE
