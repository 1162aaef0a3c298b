# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part record: the result that info files, colours, panels and tables use.

It is a plain dict with the keys of the info file, because it is passed between processes and stored on disk unchanged.
`record_types` defines it, docs/info-file.md explains the keys.
"""

import math
from dataclasses import fields, replace
from typing import Optional

import numpy as np

from ..descriptors.descriptor_table import Descriptors
from ..descriptors.distribution import Distribution, MiddleDistribution
from ..descriptors.local_distribution import LocalDistribution
from ..descriptors.local_quantiles import QUANTILES
from ..descriptors.precision import Precision
from ..descriptors.recorded_descriptors import recorded_descriptors
from ..forms.form import form_of
from ..forms.recorded_form import recorded_form
from ..forms.topology import topology
from ..mesh.bounds import OrientedBox
from ..mesh.resolution import error_to_judge_with, smallest_side
from .face_names import face_name
from .record_types import EvidenceRow, MeshRiskRecord, PartRecord, ThinnestRecord, VerdictRecord
from .region_groups import recorded_ridge_ratio

SIGNIFICANT_DIGITS = 9
"""Number of digits that are written. Further ones are rounding errors and differ between processors."""


def part_record(part, mesh, measurement, classification, paper, faces, errors, deflection,
                risk=None) -> PartRecord:
    """Assemble the record of one part: PartRecord.

    Parameters
    ----------
    part : object with name, label, instances, warnings, face_surfaces
    mesh : SurfaceMesh
    measurement : Measurement
    classification, paper : Classification
        By the active profile, and by the paper's own thresholds.
    faces : list of FaceThickness
    errors : WallErrors
    deflection : float, mm
    risk : MeshRiskRecord, optional
    """
    return _rounded({
        "name": part.name,
        "label": part.label,
        "instances": part.instances,
        **verdict(classification),
        "reason": classification.reason,
        "evidence": evidence(classification),
        "paper": {"category": paper.category, "criteria": list(paper.criteria)},
        "descriptors": recorded_descriptors(
            measurement.descriptors, measurement.wall_range, errors.thinnest, _has_teeth(paper), mesh.watertight),
        "thinnest": None if measurement.thinnest is None else _thinnest(measurement, errors),
        "thin_limit_mm": classification.thin_limit_x * measurement.descriptors.box.diagonal,
        "faces": [_face(part, measurement, face) for face in faces],
        "regions": _regions(measurement.regions),
        "form": {**recorded_form(form_of(measurement.field)), "topology": _topology(part, mesh)},
        **({} if risk is None else {"mesh_risk": risk}),
        "notes": "",
        "warnings": [*part.warnings, *mesh.warnings],
        "triangles": mesh.count,
        "samples": len(measurement.field.distance),
        "deflection_mm": deflection,
        **_probabilities(classification),
    })


def verdict(classification) -> VerdictRecord:
    """The verdict of a profile on a part, without the evidence: the first keys of its record, VerdictRecord."""
    return {
        "category": classification.category,
        "criteria": list(classification.criteria),
        "margin": _rounded(classification.margin),
        "borderline": classification.borderline,
    }


def judge_again(record: PartRecord, classification, risk: Optional[MeshRiskRecord] = None):
    """Replace the verdict in a stored record; the measurements stay.

    Parameters
    ----------
    record : PartRecord
        Modified in place.
    classification : Classification
    risk : MeshRiskRecord, optional
        Where it is not given, that of before stays.
    """
    record.update(verdict(classification))
    if risk is not None:
        record["mesh_risk"] = risk
    record["reason"] = classification.reason
    record["evidence"] = _rounded(evidence(classification))
    record.pop("probabilities", None)
    record.update(_rounded(_probabilities(classification)))


def _probabilities(classification):
    """The key ``probabilities`` of a record, the most probable category first; empty where there are none."""
    if classification.probabilities is None:
        return {}
    ordered = sorted(classification.probabilities.items(), key=lambda item: -item[1])
    return {"probabilities": [{"category": category, "probability": share} for category, share in ordered]}


def evidence(classification) -> list[EvidenceRow]:
    """list of EvidenceRow: one row per criterion, with every quantity that it compared."""
    return [
        {
            "criterion": checked.criterion.id,
            "category": checked.criterion.category,
            "title": checked.criterion.title,
            "holds": checked.holds,
            "margin": checked.margin,
            "conditions": [
                {
                    "quantity": condition.condition.quantity.symbol,
                    "value": _finite(condition.value),
                    "comparison": condition.condition.comparison,
                    "threshold": condition.threshold,
                    "holds": condition.holds,
                    "margin": condition.margin,
                    "error": _finite(condition.error),
                }
                for condition in checked.conditions
            ],
        }
        for checked in classification.checked
    ]


def descriptors_of(record: PartRecord):
    """Restore the `Descriptors` from a record: all that a new verdict needs, without geometry."""
    content = record["descriptors"]
    parallel, slanted = content["distribution"], content["nonparallel"]
    shares = content["shares"]
    box = OrientedBox(np.array(content["box_mm"], float), np.array(content["box_axes"], float))
    wall = _parallel_wall(record)
    measured = Descriptors(
        content["volume_mm3"], content["area_mm2"], box,
        Distribution(
            np.array(parallel["bins"], int), np.array(parallel["area"], float),
            np.array(slanted["bins"], int), np.array(slanted["angles"], int),
            np.array(slanted["area"], float),
            shares["parallel"], shares["nonparallel"], shares["unmeasured"], shares["unmet"],
            _middle_of(content.get("middle")),
        ),
        content["min_nonparallel"],
        content.get("plate_share"),  # records of earlier versions lack it
        _region_counts(record),
        _hazards_of(content.get("hazards")),
        precision=_precision_of(content.get("precision")),
        local=_local_of(content.get("local")),
    )
    of_side = max(wall["error_bound"], 2.0 * record.get("deflection_mm", 0.0))
    error = error_to_judge_with([(smallest_side(measured), of_side), (wall["min"], wall["error_bound"])])
    return replace(measured, length_error=error)


def _region_counts(record):
    """``regions`` of a record's ``descriptors``; None where the record has none. Earlier versions counted no ridges."""
    counts = record["descriptors"].get("regions")
    return counts if counts is None or "ridge_ratio" in counts else {**counts, "ridge_ratio": recorded_ridge_ratio(record)}


def _parallel_wall(record):
    """Thickness and error bound of the thinnest parallel wall: dict with ``min`` and ``error_bound``."""
    thinnest = record.get("thinnest")
    if thinnest is None:  # records of earlier versions knew no other walls
        return record["descriptors"]["thickness_mm"]
    return {"min": thinnest["parallel_mm"], "error_bound": thinnest["parallel_error_mm"]}


def _thinnest(measurement, errors) -> ThinnestRecord:
    place, parallel = measurement.thinnest, measurement.thinnest_wall
    return {
        "kind": place.kind, "face": face_name(place.witness.face), "witness": _witness(place.witness),
        "walls_mm": None if place.wall is None else place.wall.distance, "walls_error_mm": errors.walls,
        "parallel_mm": None if parallel is None else parallel.distance, "parallel_error_mm": errors.parallel,
        "depth_mm": place.depth, "edges_mm": place.edges_mm, "places": place.places, "below_mm": place.below_mm,
    }


def _hazards_of(content):
    """``hazards`` of a record; None where it has none, or only says that there are no faces."""
    return None if content is None or content["faces"] is None else content


def _precision_of(content):
    """`Precision` of a record's ``precision``; None where the record has none."""
    # Earlier versions searched for slanted walls to the end.
    return None if content is None else Precision(**{
        each.name: content[each.name] for each in fields(Precision) if each.name != "slanted" or each.name in content})


def _middle_of(content):
    """`MiddleDistribution` of a record's ``middle``; None where the record has none."""
    if content is None:
        return None
    return MiddleDistribution(
        np.array(content["bins"], int), np.array(content["parallel"], float), np.array(content["nonparallel"], float))


def _local_of(content):
    """`LocalDistribution` of a record's ``local``; None where the record has none, or an empty one."""
    if content is None or not content["bins"]:
        return None
    return LocalDistribution(np.array(content["bins"], int), np.array(content["area"], float),
                             {name: content[name] for name in QUANTILES})


def _has_teeth(paper):
    """The paper's indicator of teeth-like features: whether its non-parallel criterion holds."""
    return any(
        checked.holds and any(row.condition.quantity.is_wall_distance for row in checked.conditions)
        for checked in paper.checked
    )


def _topology(part, mesh):
    return None if part.face_surfaces is None else topology(mesh, [kind for kind, _ in part.face_surfaces])


def _surface_of(part, face):
    """On which kind of surface a face lies, and its radius."""
    surfaces = part.face_surfaces
    return (None, None) if surfaces is None else surfaces[face]


def _equal_to(measurement, face):
    """Name of the first face that is equal to a face; None where that is the face itself, or is not known."""
    equal = measurement.equal_faces
    return None if equal is None or equal[face] == face else face_name(int(equal[face]))


def _ball_at(measurement, face):
    """Median diameter of the largest balls that reach a face, mm; None where it is not known."""
    balls = measurement.balls_at_faces
    return None if balls is None or not math.isfinite(balls[face]) else float(balls[face])


def _face(part, measurement, face):
    surface, radius = _surface_of(part, face.face)
    return {
        "face": face_name(face.face),
        "area_mm2": face.area,
        "min": face.minimum,
        "median": face.median,
        "max": face.maximum,
        "thin_share": face.thin_share,
        "unmeasured_share": face.unmeasured_share,
        "witness": _witness(face.witness),
        "wedge": _witness(face.wedge),
        "surface": surface,
        "radius_mm": radius,
        "equal_to": _equal_to(measurement, face.face),
        "ball_mm": _ball_at(measurement, face.face),
    }


def _regions(regions):
    return {
        "listed": [{
            "kind": region.kind,
            "area_mm2": region.area,
            "min": region.least,
            "median": region.median,
            "length_mm": region.length,
            "width_mm": region.width,
            "volume_share": region.volume_share,
            "place": region.place.tolist(),
            "faces": [face_name(face) for face in region.faces],
            "witness": _witness(region.witness),
        } for region in regions.listed],
        "others": regions.others,
        "others_share": regions.others_share,
    }


def _witness(witness):
    if witness is None:
        return None
    return {
        "distance": witness.distance,
        "points": [witness.point.tolist(), witness.opposite.tolist()],
        "opposite_face": face_name(witness.opposite_face),
    }


def _finite(value):
    return value if value is None or math.isfinite(value) else None


def _rounded(content):
    """The same content with every float rounded to `SIGNIFICANT_DIGITS`."""
    if isinstance(content, bool) or content is None:
        return content
    if isinstance(content, float):
        return float(f"{content:.{SIGNIFICANT_DIGITS}g}") + 0.0
    if isinstance(content, dict):
        return {key: _rounded(value) for key, value in content.items()}
    if isinstance(content, list):
        return [_rounded(value) for value in content]
    return content
