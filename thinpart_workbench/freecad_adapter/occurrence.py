# SPDX-License-Identifier: LGPL-2.1-or-later
"""Occurrences of parts in a document, and the objects, shapes and matrices at a sub-object path.

FreeCAD's sub-object path lists the names of the objects below a top object, each followed by a dot. It is empty for
the top object itself and may end with the name of a face.
"""

from dataclasses import dataclass


@dataclass
class Occurrence:
    """One occurrence of a part in a document.

    Attributes
    ----------
    root : str
        Name of the top object.
    path : str
        Sub-object path below it, empty for the object itself.
    solid : int
        Index of the solid within the object's shape.
    document : str
        Name of the open document that holds the top object; empty for parts of other files.
    """

    root: str
    path: str
    solid: int
    document: str = ""

    def is_around(self, root, path):
        """Whether a selected path, as FreeCAD's selection gives it, is this occurrence or lies within it."""
        return self.root == root and path.startswith(self.path)

    def is_within(self, root, path):
        """Whether this occurrence is at a selected path, as FreeCAD's selection gives it, or lies within it."""
        return self.root == root and self.path.startswith(path)

    def top(self, document):
        """The top object; None if it was removed from the document."""
        return document.getObject(self.root)


def objects_along(top, path):
    """The objects along a path, from the top object to the one at its end: list of App.DocumentObject, at least one."""
    chain = top.getSubObjectList(path) if path else []
    return [entry for entry in chain if entry is not None] or [top]


def object_at(top, path):
    """The App.DocumentObject at the end of a path; None if there is none."""
    return top.getSubObject(path, retType=1) if path else top


def shape_at(top, path):
    """The Part.Shape of the object at the end of a path, in global coordinates."""
    import Part

    return Part.getShape(top, path, needSubElement=False, transform=True)


def matrix_at(top, path):
    """The global App.Matrix of the object at the end of a path, which may scale."""
    return top.getSubObject(path, retType=4)


def split_at_element(path):
    """Split a path into the path of the object and the name of its face, edge or corner, empty if there is none."""
    object_path, dot, element = path.rpartition(".")
    return object_path + dot, element
