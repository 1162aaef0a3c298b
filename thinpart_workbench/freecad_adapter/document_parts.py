"""The distinct parts of an open FreeCAD document."""

import re
from dataclasses import dataclass, field

import numpy as np

from .bootstrap import load_freecad
from .broken_parts import BrokenPart, dead_link, defect_of, leads_nowhere, mesh_defect, recompute_warning
from .equal_solids import equal_part
from .part import MeshedPart, Occurrence, SolidPart
from .solids import loose_faces_warning

# A mirror image or a copy stands beside its source; the source is consumed only where it is hidden.
_STANDS_BESIDE_SOURCE = ("Part::Mirroring", "Part::FeaturePython")

# References that place an object and do not use up its shape.
_PLACING_PROPERTIES = ("Support", "AttachmentSupport")


@dataclass
class DocumentContent:
    """What a document holds.

    Attributes
    ----------
    parts : list of SolidPart or MeshedPart
    broken : list of BrokenPart
        What should be a part as well and has no solid.
    """

    parts: list = field(default_factory=list)
    broken: list = field(default_factory=list)


def document_parts(document):
    """The parts alone of `document_content`."""
    return document_content(document).parts


def document_content(document):
    """Distinct solids and meshes of a document, each with the places where it stands.

    Parameters
    ----------
    document : FreeCAD.Document

    Returns
    -------
    DocumentContent
        In the order of the document. Placements of containers and links are applied.

    Notes
    -----
    Copies of one shape are one part, made by links, by placement or drawn twice. What another shape was
    made from is not a part, nor are the features of a body, nor is a hidden object of which links are shown. A
    hidden shape that is no body is a leftover of modelling unless nothing else is there.
    """
    load_freecad()
    roots = [root for root in document.Objects if _stands_alone(root)]
    leftovers = [root for root in roots if _is_leftover(root)]
    content = _content_under([root for root in roots if root not in leftovers])
    if content.parts:
        return content
    hidden = _content_under(leftovers, with_hidden=True)
    return DocumentContent(hidden.parts, content.broken or hidden.broken)


def _content_under(roots, with_hidden=False):
    content, known = DocumentContent(), set()
    for root in roots:
        for path in _leaf_paths(root):
            leaf = root.getSubObject(path, retType=1) if path else root
            defect = _add_leaf(content.parts, root, path, leaf)
            if defect is None or (_is_leftover(leaf) and not with_hidden):
                continue
            source = leaf.getLinkedObject(True) or leaf
            key = source.Document.Name, source.Name
            if key not in known:  # a broken thing is told once, however often it is linked
                known.add(key)
                name = _unique(content.parts + content.broken, leaf.Name)
                content.broken.append(BrokenPart(name, leaf.Label, *defect))
    return content


def _is_leftover(root):
    return (
        not getattr(root, "Visibility", True)
        and not root.isDerivedFrom("Part::BodyBase")
        and not _holds_others(root)
    )


def part_at(parts, root, path):
    """The part that stands at a place of the document, or None.

    Parameters
    ----------
    parts : list
        From `document_parts`.
    root : str
        Name of the top object.
    path : str
        Sub-object path, with or without the name of a face at its end.
    """
    for part in parts:
        for place in part.occurrences:
            if place.root == root and path.startswith(place.path):
                return part
    return None


def _stands_alone(candidate):
    """Whether an object is at the top of the document and not used up by another."""
    if candidate.isDerivedFrom("App::LinkElement"):
        return False  # its array of links is what stands there
    if _is_plain_group(candidate):
        return False  # it places nothing: what is in it stands for itself
    if candidate.getParentGeoFeatureGroup() is not None:
        return False
    if any(_uses_up(user, candidate) for user in candidate.InList):
        return False
    return getattr(candidate, "Visibility", True) or not _has_links(candidate)


def _is_plain_group(candidate):
    return candidate.hasExtension("App::GroupExtension") and not candidate.hasExtension(
        "App::GeoFeatureGroupExtension"
    )


def _is_link(candidate):
    return candidate.hasExtension("App::LinkBaseExtension")


def _is_container(candidate):
    """App::Part, groups and assemblies; a body is one part, not a container of its features."""
    if candidate.isDerivedFrom("Part::BodyBase"):
        return False
    return candidate.hasExtension("App::GroupExtension")


def _uses_up(user, source):
    if not user.isDerivedFrom("Part::Feature") or user.isDerivedFrom("Part::Part2DObject"):
        return False
    if user.isDerivedFrom("Part::BodyBase") or _is_link(user) or _is_binder(user):
        return False
    if not any(_refers(user, name, source) for name in user.PropertiesList):
        return False
    if user.TypeId in _STANDS_BESIDE_SOURCE:
        return not getattr(source, "Visibility", True)
    return True


def _is_binder(candidate):
    return "Binder" in candidate.TypeId or "Datum" in candidate.TypeId


def _refers(user, name, source):
    if name in _PLACING_PROPERTIES or "PropertyLink" not in user.getTypeIdOfProperty(name):
        return False
    value = getattr(user, name, None)
    targets = value if isinstance(value, (list, tuple)) else [value]
    return any(
        (target[0] if isinstance(target, (list, tuple)) and target else target) == source
        for target in targets
    )


def _leaf_paths(root):
    """Sub-object paths from `root` to everything that has a shape of its own."""
    if not _holds_others(root):
        return [""]
    paths = []
    for path in root.getSubObjects():
        child = root.getSubObject(path, retType=1)
        if child is None or child == root:
            continue
        if not getattr(child, "Visibility", True) and _has_links(child):
            continue
        if any(_uses_up(user, child) for user in child.InList):
            continue
        paths += [path + rest for rest in _leaf_paths(child)]
    return paths


def _has_links(candidate):
    return any(
        _is_link(user) and user.getLinkedObject(False) == candidate for user in candidate.InList
    )


def _holds_others(candidate):
    if leads_nowhere(candidate):
        return False  # an array of what is gone, or an assembly whose document is: one sentence tells of all of it
    if _is_link(candidate):
        if getattr(candidate, "ElementCount", 0) > 0:
            return True
        target = candidate.getLinkedObject(True)
        return target is not None and target != candidate and _holds_others(target)
    return _is_container(candidate)


def _add_leaf(parts, root, path, leaf):
    """Add what stands at a place to the parts; kind and message where that is a broken part."""
    source = leaf.getLinkedObject(True) or leaf
    if source.isDerivedFrom("Mesh::Feature"):
        return _add_mesh(parts, root, path, leaf, source)
    if leads_nowhere(source):
        return dead_link(leaf, source)
    if hasattr(source, "Shape") or _is_link(leaf):
        return _add_solids(parts, root, path, leaf)
    return None


def _add_solids(parts, root, path, leaf):
    import Part

    shape = Part.getShape(root, path, needSubElement=False, transform=True)
    if leaf.isDerivedFrom("Part::Part2DObject"):
        return None
    solids = [] if shape.isNull() else shape.Solids
    if not solids:
        return defect_of(leaf, shape)
    warnings = tuple(filter(None, (recompute_warning(leaf),
                                   loose_faces_warning(shape, f"'{leaf.Label}'"))))
    alike = all(solid.isPartner(solids[0]) for solid in solids)
    for index, solid in enumerate(solids):
        known = equal_part(parts, solid)
        if known is None:
            name, label = leaf.Name, leaf.Label
            if not alike:
                name, label = f"{name}.Solid{index + 1}", f"{label} ({index + 1})"
            known = SolidPart(_unique(parts, name), label, warnings=warnings, shape=solid)
            parts.append(known)
        known.occurrences.append(Occurrence(root.Name, path, index, root.Document.Name))
    return None


def _add_mesh(parts, root, path, leaf, source):
    points, triangles = source.Mesh.Topology
    if not triangles:
        return mesh_defect(leaf)
    # The points are placed as the mesh itself is; containers and links come on top of that.
    placed = root.getSubObject(path, retType=4) * source.Placement.toMatrix().inverse()
    matrix = np.array(placed.A).reshape(4, 4)
    points = np.array([(p.x, p.y, p.z) for p in points]) @ matrix[:3, :3].T + matrix[:3, 3]
    part = MeshedPart(_unique(parts, leaf.Name), leaf.Label, points=points,
                      triangles=np.array(triangles))
    part.occurrences.append(Occurrence(root.Name, path, 0, root.Document.Name))
    parts.append(part)
    return None


def _unique(parts, name):
    taken = {part.name for part in parts}
    if name not in taken:
        return name
    stem = re.sub(r"#\d+$", "", name)
    number = 2
    while f"{stem}#{number}" in taken:
        number += 1
    return f"{stem}#{number}"
