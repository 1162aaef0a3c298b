# SPDX-License-Identifier: LGPL-2.1-or-later
"""Detect objects that should be solids but are not, and shapes that are older than their document."""

import io
import re
import zipfile
from dataclasses import dataclass
from html import unescape

from ...core.message import message


@dataclass(frozen=True)
class BrokenPart:
    """An object of a document that looks like a part but has no usable geometry.

    Attributes
    ----------
    name, label : str
        Unique name within the document, and the label that people see.
    kind : str
        A key of `core/errors.KINDS`.
    message : str
        One sentence.
    """

    name: str
    label: str
    kind: str
    message: str

    def failure(self):
        """dict: the entry of the info file's ``failures``."""
        return {"part": self.name, "label": self.label, "kind": self.kind, "message": self.message}


def defect_of(leaf, shape):
    """Why an object without a solid is a defect, or None if it is not meant to be a solid: tuple of (str, str) or None.

    Kind and message.

    Sketches, drawings, datums, binders, curves, points and flat faces made by a tool are construction geometry.
    An imported surface is a sheet body, and therefore a part.

    Parameters
    ----------
    leaf : FreeCAD.DocumentObject
        The object in the document, which may be a link.
    shape : Part.Shape
        Its shape, without solids.
    """
    source = leaf.getLinkedObject(True) or leaf
    if not source.isDerivedFrom("Part::Feature") or _is_construction(source):
        return None
    if shape.isNull() or not shape.Vertexes:
        return _without_shape(leaf, source)
    if not shape.Faces or _is_drawing(source, shape):
        return None
    if shape.Shells and all(shell.isClosed() for shell in shape.Shells):
        return "no_solid", message("'{object}' is a closed shell but not a solid: convert it to a solid first.",
                                   object=leaf.Label)
    return "no_solid", message("'{object}' is made of surfaces that bound no solid: close or thicken it first.",
                               object=leaf.Label)


def mesh_defect(leaf):
    """The defect of a mesh without triangles; see `defect_of`."""
    return "empty", message("'{object}' is a mesh without triangles: import it again or delete it.",
                            object=leaf.Label)


def recompute_warning(leaf):
    """Why the shape of a FreeCAD.DocumentObject may be older than its parameters; None if it is not.

    Returns a str or None: one sentence.

    FreeCAD keeps the last good shape of a failed feature and of everything made with it, and saves the failure
    with the document. A changed object alone proves nothing: a file does not show whether its length or only its
    placement was changed.
    """
    failed = _first_failed(leaf)
    if failed is None:
        return None
    if failed == (leaf.getLinkedObject(True) or leaf):
        return message("This may be an older shape of '{object}', because its last recompute failed ({reason}): "
                       "repair it and recompute the document.", object=leaf.Label, reason=_status_text(failed))
    return message("This may be an older shape of '{object}', because the last recompute of '{feature}', which it "
                   "is made with, failed ({reason}): repair it and recompute the document.",
                   object=leaf.Label, feature=failed.Label, reason=_status_text(failed))


def is_broken_link(candidate):
    """Whether an object is a link, or an assembly's link to another assembly, without a linked object."""
    is_link = candidate.hasExtension("App::LinkBaseExtension") or candidate.isDerivedFrom("Assembly::AssemblyLink")
    return is_link and "LinkedObject" in candidate.PropertiesList and candidate.LinkedObject is None


def broken_link_defect(leaf, link):
    """Why a link for which `is_broken_link` holds is a defect; None if the link was never set.

    Returns a tuple of (str, str) or None: kind and message.

    Parameters
    ----------
    leaf : FreeCAD.DocumentObject
        The object in the document.
    link : FreeCAD.DocumentObject
        The broken link: the object itself, or a link that it leads to.
    """
    file, name = _link_target(link)
    if not name and "Up-to-date" in link.State:
        return None  # it was never set; a link that lost its object would not be up to date
    if not file:
        return "missing", message("The link '{object}' leads to nothing: set its linked object again or delete it.",
                                  object=leaf.Label)
    return "missing", message("The link '{object}' leads to '{target}' in {file}, which cannot be found: put the "
                              "file back or set the linked object again.", object=leaf.Label, target=name, file=file)


def _link_target(link):
    """File and object name that a link refers to; FreeCAD exposes them only in the saved form of the property."""
    saved = bytes(link.dumpPropertyContent("LinkedObject", Compression=0))
    with zipfile.ZipFile(io.BytesIO(saved)) as archive:
        text = archive.read("Persistence.xml").decode("utf-8", "replace")
    values = dict(re.findall(r'\b(file|name|value)="([^"]*)"', text))
    file, name = values.get("file", ""), values.get("name", "") or values.get("value", "")
    return tuple(unescape(value) for value in (file, name))


def _is_construction(source):
    return (
        source.isDerivedFrom("Part::Part2DObject")
        or source.isDerivedFrom("Part::Datum")
        or "Binder" in source.TypeId
    )


def _is_drawing(source, shape):
    """Whether a surface is a plane or drawing made by a tool, and not a sheet body."""
    if source.TypeId == "Part::Feature" or source.isDerivedFrom("Part::BodyBase"):
        return False
    return shape.findPlane() is not None


def _without_shape(leaf, source):
    failed = _first_failed(leaf)
    if source.isDerivedFrom("Part::BodyBase"):
        features = [member for member in source.Group if member.isDerivedFrom("PartDesign::Feature")]
        if not features and source.BaseFeature is None:
            return None  # a body that holds sketches and datums for others
    elif failed is None and getattr(source, "Proxy", None) is not None:
        return None  # its own code ran and made no shape, as for a building, an axis or a site
    if failed is None:
        return "no_solid", message("'{object}' has an empty shape: recompute the document or delete it.",
                                   object=leaf.Label)
    if failed == source:
        return "no_solid", message("'{object}' has no shape, because its last recompute failed ({reason}): repair "
                                   "it and recompute the document.", object=leaf.Label, reason=_status_text(failed))
    return "no_solid", message("'{object}' has no shape, because the last recompute of '{feature}' failed "
                               "({reason}): repair it and recompute the document.",
                               object=leaf.Label, feature=failed.Label, reason=_status_text(failed))


def _first_failed(leaf):
    """The object whose last recompute failed: the object itself, or the first one that it is made with; or None."""
    pending, seen = [leaf.getLinkedObject(True) or leaf], set()
    while pending:
        candidate = pending.pop(0)
        if (candidate.Document.Name, candidate.Name) in seen:
            continue
        seen.add((candidate.Document.Name, candidate.Name))
        if "Invalid" in candidate.State:
            return candidate
        pending += _sources(candidate)
    return None


def _sources(candidate):
    if candidate.isDerivedFrom("Part::BodyBase"):
        # Features after its tip, and other objects in the body, do not contribute to its shape.
        return [candidate.Tip] if candidate.Tip is not None else []
    return [other for other in candidate.OutList if other is not None]


def _status_text(failed):
    """The first line of FreeCAD's message about a failure."""
    lines = failed.getStatusString().strip().splitlines()
    return lines[0].rstrip(".") if lines else message("no reason given")
