# SPDX-License-Identifier: LGPL-2.1-or-later
"""What shows that two parts are the same, or what differs, so that a person can check it."""

import numpy as np

from ...core.errors import ThinPartError
from ...core.figures import Length
from ...core.forms.face_surfaces import CYLINDER, SPHERE, TORUS
from ...core.message import joined, message
from ...core.record.face_names import face_name
from ...core.reuse.likeness import (
    ALIKE,
    FACE_SAME,
    IDENTICAL,
    MIRRORED,
    SCALED,
    has_same_measures,
    is_whole,
    kind_of,
)
from ...storage.info.stored_records import stored_records

GEOMETRY, OUTLINES, BYTES = "geometry", "outlines", "bytes"
"""What was compared: the geometry of both documents, the points that their records keep, or the documents byte by byte."""

MOST_DIFFERENCES = 12
"""Faces that are listed as different, the farthest first."""

LEAST_DIFFERENCE = 1e-3
"""Share by which a side of the box differs where that is said."""

SAME_RADIUS = 1e-3
"""Share by which radii of faces differ at most that two parts have in common."""

_MOST_SENTENCES, _LEAST_SAID = 4, 1e-4

_BENT = (CYLINDER, SPHERE, TORUS)


def judged(likeness, answer, compared, part, reference):
    """The kind of likeness by an answer as `comparison_task.ANSWER`; None where the two have too little in common."""
    laid = likeness.laid._replace(share=answer["part"]["share"], other_share=answer["reference"]["share"])
    if compared == BYTES:
        return IDENTICAL
    if compared == OUTLINES and None not in (part.topology, reference.topology):
        # Their points lie beside the surface: what is closer than they can tell is told by the measures of the faces.
        is_one = likeness.kind != ALIKE and _has_same_radii(part, reference, laid.motion.scale)
    else:
        is_one = is_whole(answer)
    return kind_of(laid, is_one and has_same_measures(part, reference, laid.motion.scale, answer["are_solids"]))


def _has_same_radii(part, reference, scale):
    """Whether each radius of a face of a part, scaled, is one of the other's, and the other way round."""
    own, other = (np.array(sorted({radius for _, radius in _surfaces(each).values() if radius}))
                  for each in (part, reference))
    own = own * scale
    if not len(own) or not len(other):
        return len(own) == len(other)
    apart = np.abs(own[:, None] - other) / np.maximum(own[:, None], other)
    return bool(max(apart.min(axis=0).max(), apart.min(axis=1).max()) <= SAME_RADIUS)


def evidence(kind, likeness, answer, compared, part, reference):
    """The ``evidence`` of a part of a group: dict, see docs/reuse.md.

    Parameters
    ----------
    kind : str
    likeness : Likeness
    answer : dict
        As `comparison_task.ANSWER`.
    compared : str
        `GEOMETRY`, `OUTLINES` or `BYTES`.
    part, reference : StoredPart
        Or, for the part, anything with its dimensions and with the ``faces`` of its record.
    """
    sides = [("part", answer["part"], part), ("reference", answer["reference"], reference)]
    differences = _differences(sides) if kind == ALIKE else []
    content = {
        "compared": compared,
        "points": answer["part"]["points"] + answer["reference"]["points"],
        "greatest_mm": _digits(max(side["greatest_mm"] for _, side, _ in sides)),
        "same_share": _digits(min(side["share"] for _, side, _ in sides)),
        "faces_same": [_same(answer["part"]), len(answer["part"]["faces"])],
        "reference_faces_same": [_same(answer["reference"]), len(answer["reference"]["faces"])],
        "scale": float(f"{1.0 / likeness.laid.motion.scale:.6g}"),
        "mirrored": likeness.laid.motion.is_mirrored,
        "volumes_mm3": [part.volume_mm3, reference.volume_mm3],
        "areas_mm2": [part.area_mm2, reference.area_mm2],
        "differences": differences,
    }
    return {**content, "says": _sentence(kind, content, answer, part, reference)}


def _same(side):
    return sum(face["share"] >= FACE_SAME for face in side["faces"])


def _differences(sides):
    found = []
    for name, side, stored in sides:
        surfaces = _surfaces(stored)
        for face in side["faces"]:
            if face["share"] < FACE_SAME:
                surface, radius = surfaces.get(face_name(face["face"]), (None, None))
                found.append({"of": name, "face": face_name(face["face"]), "surface": surface, "radius_mm": radius,
                              "place_mm": [_digits(value) for value in face["place"]],
                              "apart_mm": _digits(face["distance_mm"])})
    return sorted(found, key=lambda each: -each["apart_mm"])[:MOST_DIFFERENCES]


def _surfaces(part):
    """By the name of a face: kind and radius of its surface."""
    try:
        faces = part.faces if hasattr(part, "faces") else [
            face for record in stored_records(part.info_file) if record["name"] == part.name for face in record["faces"]]
    except ThinPartError:
        return {}
    return {face["face"]: (face.get("surface"), face.get("radius_mm")) for face in faces}


def _sentence(kind, content, answer, part, reference):
    apart = Length(max(content["greatest_mm"], _LEAST_SAID))
    if content["compared"] == BYTES:
        return message("The documents are the same, byte by byte.")
    if content["compared"] == OUTLINES and kind != ALIKE:
        return _of_outlines(kind, content["scale"])
    if not answer["are_solids"] and kind != ALIKE and content["compared"] == GEOMETRY:
        return _of_triangles(kind, apart)
    if kind == IDENTICAL:
        return message("The same form: its surfaces are at most {apart:.2g} apart.", apart=apart)
    if kind == MIRRORED:
        return message("The mirror image: its surfaces are at most {apart:.2g} apart.", apart=apart)
    if kind == SCALED:
        return message("The same form, {scale:.6g} times as large: in the size of the other, its surfaces are at most "
                       "{apart:.2g} apart.", scale=content["scale"], apart=apart)
    percent = min(99.0, 100.0 * content["same_share"])
    # Points of outlines that have nothing like them near by are at no distance that is known.
    alike = (message("Alike: {percent:.0f} % of the surface is the same.", percent=percent)
             if content["compared"] == OUTLINES else
             message("Alike: {percent:.0f} % of the surface is the same, the rest up to {apart:.2g} apart.", percent=percent,
                     apart=apart))
    return joined([alike,
                   *_of_sides(part, reference), *_of_faces(content["differences"])][:_MOST_SENTENCES])


def _of_outlines(kind, scale):
    if kind == MIRRORED:
        return message("The mirror image, by the points that info files keep, by volume and by area.")
    if kind == SCALED:
        return message("The same form, {scale:.6g} times as large, by the points that info files keep, by volume and by "
                       "area.", scale=scale)
    return message("The same form, by the points that info files keep, by volume and by area.")


def _of_triangles(kind, apart):
    if kind == MIRRORED:
        return message("The mirror image: triangles lie at most {apart:.2g} from the other surface.", apart=apart)
    if kind == SCALED:
        return message("The same form, scaled: triangles lie at most {apart:.2g} from the other surface.", apart=apart)
    return message("The same form: triangles lie at most {apart:.2g} from the other surface.", apart=apart)


def _of_sides(part, reference):
    for key, more, less in (("d1_mm", _longer, _shorter), ("d2_mm", _wider, _narrower), ("d3_mm", _higher, _lower)):
        own, other = getattr(part, key), getattr(reference, key)
        if abs(own - other) > LEAST_DIFFERENCE * reference.d1_mm:
            yield (more if own > other else less)(Length(abs(own - other)))


def _longer(length):
    return message("It is {length:.4g} longer.", length=length)


def _shorter(length):
    return message("It is {length:.4g} shorter.", length=length)


def _wider(length):
    return message("It is {length:.4g} wider.", length=length)


def _narrower(length):
    return message("It is {length:.4g} narrower.", length=length)


def _higher(length):
    return message("It is {length:.4g} higher.", length=length)


def _lower(length):
    return message("It is {length:.4g} lower.", length=length)


def _of_faces(differences):
    """Sentences about round faces that only one of the two has: holes, pins, fillets."""
    here, there = ([each["radius_mm"] for each in differences if each["of"] == name and each["surface"] in _BENT]
                   for name in ("part", "reference"))
    for radius in sorted(set(here))[:1]:
        yield message("Only this one has round faces of radius {radius:.3g} ({count}).", radius=Length(radius),
                      count=here.count(radius))
    for radius in sorted(set(there))[:1]:
        yield message("Only the other has round faces of radius {radius:.3g} ({count}).", radius=Length(radius),
                      count=there.count(radius))


def _digits(value):
    return float(f"{value:.4g}")
