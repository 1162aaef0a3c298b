# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of an open document that is to be meshed, and its FEM mesh."""

from dataclasses import dataclass
from typing import Any

from ...freecad_adapter.objects.fem_mesh import meshed_object, set_fem_mesh
from ...freecad_adapter.objects.fem_shell import set_fem_shell
from ...freecad_adapter.occurrence import object_at
from ...freecad_adapter.shapes.equal_solids import motion


@dataclass(frozen=True)
class PartToMesh:
    """A part as the document shows it, and as it lies in the object that FEM meshes.

    Attributes
    ----------
    document : FreeCAD.Document
    whole, part : SolidPart
        As shown; and with the shape of the owner.
    owner : FreeCAD.DocumentObject
    faces : list of int
        Number of each face of the part among those of the owner, from 0.
    """

    document: Any
    whole: Any
    owner: Any
    part: Any
    faces: list

    @classmethod
    def of(cls, document, whole):
        """The part of a document.

        Raises
        ------
        ThinPartError
            kind ``no_solid`` if there is no object whose FEM mesh would be that of the part.
        """
        return cls(document, whole, *meshed_object(document, whole))

    @property
    def is_unchanged(self):
        """Whether the object is there, with the shape that was measured."""
        owner = self.document.getObject(self.owner.Name)
        return owner is not None and self.owner.Shape.Solids[0].isPartner(self.part.shape)

    @property
    def shown_at(self):
        """ndarray of shape (4, 4), mm: from the coordinates of the part to those of the document."""
        return motion(self.part.shape, self.whole.shape)

    def covering(self):
        """The objects that hide the shell of the part in the view: set of (name of the document, name)."""
        occurrence = self.part.occurrences[0]
        leaf = object_at(occurrence.top(self.document), occurrence.path)
        return {(each.Document.Name, each.Name) for each in (leaf, self.owner)}

    def set_mesh(self, meshed, settings, sizes, label, analysis):
        """Make or update the FEM mesh of the part; to be called in a transaction.

        Parameters
        ----------
        meshed : dict
            From `PartSizes.mesh`.
        settings, sizes
            With which it was made; see `PartSizes.proposed`.
        label : callable
            Gives a wall its label: a row of ``regions`` of `meshed`.
        analysis : FreeCAD.DocumentObject or None

        Raises
        ------
        ThinPartError
            kind ``unreadable`` if the mesh cannot be read.
        """
        walls = [(label(row), row["size"], [self.faces[face] for face in row["faces"]])
                 for row in meshed["regions"] if row["size"] is not None]
        set_fem_mesh(self.document, self.owner, meshed["mesh"], {**settings, "walls": sizes}, meshed["global_size"],
                     settings["order"], walls, analysis)

    def set_shell(self, shell, files, settings, labels, label, analysis):
        """Make or update the mid-surface of the part and its FEM mesh; to be called in a transaction.

        Parameters
        ----------
        shell : dict
            From `PartSizes.shell`.
        files : pair of str
            See `shell_files`.
        settings : dict
            With which it was made.
        labels : pair of str
            Of the mid-surface and of its mesh.
        label : callable
            Gives the elements of one thickness, mm, their label.
        analysis : FreeCAD.DocumentObject or None

        Raises
        ------
        ThinPartError
            kind ``unreadable`` if a file cannot be read.
        """
        thicknesses = [(label(group["thickness"]), group["thickness"], group["faces"]) for group in shell["groups"]]
        shape, mesh = files
        set_fem_shell(self.document, self.owner, labels, shape, mesh, settings, shell["size"], settings["order"],
                      thicknesses, analysis)
