"""Objects that should be a solid and are none, and shapes that are older than their document."""

import io
import re
import zipfile
from dataclasses import dataclass
from html import unescape


@dataclass(frozen=True)
class BrokenPart:
    """An object of a document that people take for a part and that cannot be one.

    Attributes
    ----------
    name, label : str
        Unique name within the document, and what people call it.
    kind : str
        A key of `core.errors.KINDS`.
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
    """Why an object without a solid is a defect, or None where it is not meant to be a solid.

    Parameters
    ----------
    leaf : FreeCAD.DocumentObject
        The object as it stands in the document, which may be a link.
    shape : Part.Shape
        Its shape, without solids.

    Returns
    -------
    tuple of (str, str) or None
        Kind and message.

    Notes
    -----
    Sketches, drawings, datums, binders, curves and points are what parts are made with; so is a
    flat face that a tool made. A surface that was imported is a sheet body, and so a part.
    """
    source = leaf.getLinkedObject(True) or leaf
    if not source.isDerivedFrom("Part::Feature") or _is_construction(source):
        return None
    if shape.isNull() or not shape.Vertexes:
        return _without_shape(leaf, source)
    if not shape.Faces or _is_drawn(source, shape):
        return None
    if shape.Shells and all(shell.isClosed() for shell in shape.Shells):
        return "no_solid", (
            f"'{leaf.Label}' is a closed shell but no solid: convert it to a solid first."
        )
    return "no_solid", (
        f"'{leaf.Label}' is made of surfaces that bound no solid: close or thicken it first."
    )


def mesh_defect(leaf):
    """The same for a mesh without triangles."""
    return "empty", f"'{leaf.Label}' is a mesh without triangles: import it again or delete it."


def recompute_warning(leaf):
    """Why the shape of an object may be older than its parameters; None where it is not.

    Parameters
    ----------
    leaf : FreeCAD.DocumentObject

    Returns
    -------
    str or None
        One sentence.

    Notes
    -----
    FreeCAD keeps the last good shape of a feature that fails, and of all that is made with it, and
    stores with the document that it failed. That an object was only changed is no sign: in a file
    a new length and a new place look alike.
    """
    failed = _failed(leaf)
    if failed is None:
        return None
    if failed == (leaf.getLinkedObject(True) or leaf):
        return (f"This may be an older shape of '{leaf.Label}', because its last recompute failed "
                f"({_status(failed)}): repair it and recompute the document.")
    return (f"This may be an older shape of '{leaf.Label}', because the last recompute of "
            f"'{failed.Label}', which it is made with, failed ({_status(failed)}): repair it and "
            "recompute the document.")


def leads_nowhere(candidate):
    """Whether an object is a link, or an assembly's link to another assembly, without anything at its end."""
    is_link = candidate.hasExtension("App::LinkBaseExtension") or candidate.isDerivedFrom("Assembly::AssemblyLink")
    return is_link and "LinkedObject" in candidate.PropertiesList and candidate.LinkedObject is None


def dead_link(leaf, link):
    """Why a link that `leads_nowhere` is a defect; None where it was never set.

    Parameters
    ----------
    leaf : FreeCAD.DocumentObject
        The object as it stands in the document.
    link : FreeCAD.DocumentObject
        The link that ends there, which may be another one.

    Returns
    -------
    tuple of (str, str) or None
        Kind and message.
    """
    file, name = _link_target(link)
    if not name and "Up-to-date" in link.State:
        return None  # it was never set; one that lost its object cannot be recomputed
    if not file:
        return "missing", (f"The link '{leaf.Label}' leads to nothing: set its linked object again "
                           "or delete it.")
    return "missing", (f"The link '{leaf.Label}' leads to '{name}' in {file}, which cannot be "
                       "found: put the file back or set the linked object again.")


def _link_target(link):
    """File and object to which a link leads; FreeCAD tells them only in what it would save."""
    saved = bytes(link.dumpPropertyContent("LinkedObject", Compression=0))
    with zipfile.ZipFile(io.BytesIO(saved)) as archive:
        text = archive.read("Persistence.xml").decode("utf-8", "replace")
    values = dict(re.findall(r'\b(file|name|value)="([^"]*)"', text))
    file, name = values.get("file", ""), values.get("name", "") or values.get("value", "")
    return tuple(unescape(each) for each in (file, name))


def _is_construction(source):
    return (
        source.isDerivedFrom("Part::Part2DObject")
        or source.isDerivedFrom("Part::Datum")
        or "Binder" in source.TypeId
    )


def _is_drawn(source, shape):
    """Whether a surface is a plane or a drawing that a tool made, and not a sheet body."""
    if source.TypeId == "Part::Feature" or source.isDerivedFrom("Part::BodyBase"):
        return False
    return shape.findPlane() is not None


def _without_shape(leaf, source):
    failed = _failed(leaf)
    if source.isDerivedFrom("Part::BodyBase"):
        features = [each for each in source.Group if each.isDerivedFrom("PartDesign::Feature")]
        if not features and source.BaseFeature is None:
            return None  # a body that holds sketches and datums for others
    elif failed is None and getattr(source, "Proxy", None) is not None:
        return None  # its own code ran and made no shape: a building, an axis, a site
    if failed is None:
        return "no_solid", f"'{leaf.Label}' has an empty shape: recompute the document or delete it."
    if failed == source:
        return "no_solid", (f"'{leaf.Label}' has no shape, because its last recompute failed "
                            f"({_status(failed)}): repair it and recompute the document.")
    return "no_solid", (f"'{leaf.Label}' has no shape, because the last recompute of '{failed.Label}' "
                        f"failed ({_status(failed)}): repair it and recompute the document.")


def _failed(leaf):
    """The first of all that an object is made with, itself first, whose last recompute failed."""
    waiting, seen = [leaf.getLinkedObject(True) or leaf], set()
    while waiting:
        each = waiting.pop(0)
        if (each.Document.Name, each.Name) in seen:
            continue
        seen.add((each.Document.Name, each.Name))
        if "Invalid" in each.State:
            return each
        waiting += _made_with(each)
    return None


def _made_with(each):
    if each.isDerivedFrom("Part::BodyBase"):
        # What comes after its tip, or is in it beside, does not shape it.
        return [each.Tip] if each.Tip is not None else []
    return [other for other in each.OutList if other is not None]


def _status(failed):
    """What FreeCAD says about a failure, its first line."""
    return (failed.getStatusString().strip().splitlines() or ["no reason given"])[0].rstrip(".")
