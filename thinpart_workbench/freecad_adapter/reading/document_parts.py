# SPDX-License-Identifier: LGPL-2.1-or-later
"""The distinct parts of an open FreeCAD document."""

import re
from dataclasses import dataclass, field

from ...core.rigid_transform import transform_points
from ..bootstrap import load_freecad
from ..mesh_arrays import mesh_arrays
from ..occurrence import Occurrence, matrix_at, object_at, shape_at
from ..shapes.equal_solids import equal_part
from ..shapes.part import MeshedPart, SolidPart
from ..shapes.placements import matrix_array
from ..shapes.solids import has_surface, lines_warning, loose_faces_warning
from .broken_parts import BrokenPart, broken_link_defect, defect_of, is_broken_link, mesh_defect, recompute_warning
from .instance_names import telling_label

# A mirror image or a copy exists beside its source; the source counts as consumed only if it is hidden.
_COEXISTS_WITH_SOURCE = ("Part::Mirroring", "Part::FeaturePython")

# References that place an object and do not consume its shape.
_PLACING_PROPERTIES = ("Support", "AttachmentSupport")


@dataclass
class DocumentContent:
    """The parts and broken parts of a document.

    Attributes
    ----------
    parts : list of SolidPart or MeshedPart
    broken : list of BrokenPart
        Objects that should be parts but have no solid.
    """

    parts: list = field(default_factory=list)
    broken: list = field(default_factory=list)


def document_parts(document):
    """The parts of `document_content` without the broken ones."""
    return document_content(document).parts


def document_content(document):
    """Distinct solids and meshes of a FreeCAD.Document, each with its occurrences: DocumentContent.

    In the order of the document. Placements of containers and links are applied.

    Copies of one shape are one part, whether made by links, by placement or drawn twice. Not parts are: a shape that
    another shape was made from, the features of a body, and a hidden object with visible links to it. A hidden shape
    that is not a body is a leftover of modelling, unless the document holds nothing else.
    """
    load_freecad()
    roots = [root for root in document.Objects if _is_top_level(root)]
    leftovers = [root for root in roots if _is_leftover(root)]
    content = _content_under([root for root in roots if root not in leftovers])
    if content.parts:
        return content
    hidden = _content_under(leftovers, with_hidden=True)
    return DocumentContent(hidden.parts, content.broken or hidden.broken)


def object_content(candidate):
    """What one FreeCAD.DocumentObject is or holds, even if it is hidden or consumed by another object: DocumentContent.

    Placed in the object's own container. Empty if the object has neither solids nor triangles.
    """
    load_freecad()
    return _content_under([candidate], with_hidden=True)


def _content_under(roots, with_hidden=False):
    content, known = DocumentContent(), set()
    for root in roots:
        for path in _leaf_paths(root):
            leaf = object_at(root, path)
            defect = _add_leaf(content.parts, root, path, leaf)
            if defect is None or (_is_leftover(leaf) and not with_hidden):
                continue
            source = leaf.getLinkedObject(True) or leaf
            key = source.Document.Name, source.Name
            if key not in known:  # report a broken object once, however often it is linked
                known.add(key)
                name = _unique_name(content.parts + content.broken, leaf.Name)
                content.broken.append(BrokenPart(name, leaf.Label, *defect))
    return content


def _is_leftover(root):
    return (
        not getattr(root, "Visibility", True)
        and not root.isDerivedFrom("Part::BodyBase")
        and not _has_children(root)
    )


def part_at(parts, root, path):
    """The part at a sub-object path of the document, or None.

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
        for occurrence in part.occurrences:
            if occurrence.is_around(root, path):
                return part
    return None


def _is_top_level(candidate):
    """Whether an object is at the top level of the document and not consumed by another."""
    if candidate.isDerivedFrom("App::LinkElement"):
        return False  # the link array that it belongs to is the top object
    if _is_plain_group(candidate):
        return False  # it places nothing, so its members are top objects themselves
    if candidate.getParentGeoFeatureGroup() is not None:
        return False
    if any(_consumes(user, candidate) for user in candidate.InList):
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


def _consumes(user, source):
    if not user.isDerivedFrom("Part::Feature") or user.isDerivedFrom("Part::Part2DObject"):
        return False
    if user.isDerivedFrom("Part::BodyBase") or _is_link(user) or _is_binder(user):
        return False
    if not any(_refers_to(user, name, source) for name in user.PropertiesList):
        return False
    if user.TypeId in _COEXISTS_WITH_SOURCE:
        return not getattr(source, "Visibility", True)
    return True


def _is_binder(candidate):
    return "Binder" in candidate.TypeId or "Datum" in candidate.TypeId


def _refers_to(user, name, source):
    if name in _PLACING_PROPERTIES or "PropertyLink" not in user.getTypeIdOfProperty(name):
        return False
    value = getattr(user, name, None)
    targets = value if isinstance(value, (list, tuple)) else [value]
    return any(
        (target[0] if isinstance(target, (list, tuple)) and target else target) == source
        for target in targets
    )


def _leaf_paths(root):
    """Sub-object paths from `root` to all objects with a shape of their own."""
    if not _has_children(root):
        return [""]
    paths = []
    for path in root.getSubObjects():
        child = object_at(root, path)
        if child is None or child == root:
            continue
        if not getattr(child, "Visibility", True) and _has_links(child):
            continue
        if any(_consumes(user, child) for user in child.InList):
            continue
        paths += [path + rest for rest in _leaf_paths(child)]
    return paths


def _has_links(candidate):
    return any(
        _is_link(user) and user.getLinkedObject(False) == candidate for user in candidate.InList
    )


def _has_children(candidate):
    if is_broken_link(candidate):
        return False  # an array or assembly whose linked object is missing is reported once as a whole
    if _is_link(candidate):
        if getattr(candidate, "ElementCount", 0) > 0:
            return True
        target = candidate.getLinkedObject(True)
        return target is not None and target != candidate and _has_children(target)
    return _is_container(candidate)


def _add_leaf(parts, root, path, leaf):
    """Add the object at a path to the parts. Returns kind and message if it is a broken part, else None."""
    source = leaf.getLinkedObject(True) or leaf
    if source.isDerivedFrom("Mesh::Feature"):
        return _add_mesh(parts, root, path, leaf, source)
    if is_broken_link(source):
        return broken_link_defect(leaf, source)
    if hasattr(source, "Shape") or _is_link(leaf):
        return _add_solids(parts, root, path, leaf)
    return None


def _add_solids(parts, root, path, leaf):
    shape = shape_at(root, path)
    if leaf.isDerivedFrom("Part::Part2DObject"):
        return None
    whose = f"'{leaf.Label}'"
    solids = [] if shape.isNull() else [(index, solid) for index, solid in enumerate(shape.Solids) if has_surface(solid)]
    if not solids:
        return defect_of(leaf, shape)
    warnings = tuple(filter(None, (
        recompute_warning(leaf), lines_warning(shape, whose), loose_faces_warning(shape, whose))))
    alike = all(solid.isPartner(solids[0][1]) for _, solid in solids)
    for index, solid in solids:
        known = equal_part(parts, solid)
        if known is None:
            name, label = leaf.Name, telling_label(root, path, leaf)
            if not alike:
                name, label = f"{name}.Solid{index + 1}", f"{label} ({index + 1})"
            known = SolidPart(_unique_name(parts, name), label, warnings=warnings, shape=solid)
            parts.append(known)
        known.occurrences.append(Occurrence(root.Name, path, index, root.Document.Name))
    return None


def _add_mesh(parts, root, path, leaf, source):
    points, triangles = mesh_arrays(source.Mesh)
    if not len(triangles):
        return mesh_defect(leaf)
    # The points include the placement of the mesh object; only those of containers and links are missing.
    matrix = matrix_at(root, path) * source.Placement.toMatrix().inverse()
    points = transform_points(matrix_array(matrix), points)
    part = MeshedPart(_unique_name(parts, leaf.Name), telling_label(root, path, leaf), points=points, triangles=triangles)
    part.occurrences.append(Occurrence(root.Name, path, 0, root.Document.Name))
    parts.append(part)
    return None


def _unique_name(parts, name):
    taken = {part.name for part in parts}
    if name not in taken:
        return name
    stem = re.sub(r"#\d+$", "", name)
    number = 2
    while f"{stem}#{number}" in taken:
        number += 1
    return f"{stem}#{number}"
