"""The part record: the one result that info file, colours, panels and tables consume.

It is a plain dict with the keys of the info file (see docs/info-file.md and the schema beside it),
because it crosses process boundaries and is kept on disk as it is.
"""

import math

import numpy as np

from .bounds import OrientedBox
from .descriptors import REPORTED_SHARES, Descriptors
from .distribution import Distribution

SIGNIFICANT_DIGITS = 9
"""Digits that are written. Those below are rounding and differ between processors."""


def face_name(number):
    """FreeCAD's name of a face, from its number from 0."""
    return f"Face{number + 1}"


def face_number(entry):
    """The face, from 0, that an entry of a record's ``faces`` is about; faces without triangles have none."""
    return int(entry["face"][len("Face"):]) - 1


def part_record(part, mesh, measurement, classification, paper, faces, error_bound, deflection):
    """Assemble the record of one part.

    Parameters
    ----------
    part : object with name, label, instances, warnings
    mesh : SurfaceMesh
    measurement : Measurement
    classification, paper : Classification
        By the active profile, and by the paper's own thresholds.
    faces : list of FaceThickness
    error_bound, deflection : float, mm

    Returns
    -------
    dict
    """
    return _rounded({
        "name": part.name,
        "label": part.label,
        "instances": part.instances,
        **verdict(classification),
        "reason": classification.reason,
        "evidence": evidence(classification),
        "paper": {"category": paper.category, "criteria": list(paper.criteria)},
        "descriptors": _descriptors(mesh, measurement, paper, error_bound),
        "thin_limit_mm": classification.thin_limit * measurement.descriptors.box.diagonal,
        "faces": [_face(face) for face in faces],
        "notes": "",
        "warnings": [*part.warnings, *mesh.warnings],
        "triangles": mesh.count,
        "samples": len(measurement.field.distance),
        "deflection_mm": deflection,
    })


def verdict(classification):
    """What a profile decides of a part: the first keys of its record, without the evidence.

    Parameters
    ----------
    classification : Classification

    Returns
    -------
    dict
    """
    return {
        "category": classification.category,
        "criteria": list(classification.criteria),
        "margin": _rounded(classification.margin),
        "borderline": classification.borderline,
    }


def judge_again(record, classification):
    """Put another verdict into a stored record; what was measured stays.

    Parameters
    ----------
    record : dict
        Changed.
    classification : Classification
    """
    record.update(verdict(classification))
    record["reason"] = classification.reason
    record["evidence"] = _rounded(evidence(classification))


def evidence(classification):
    """One row per criterion, with every quantity that it compared: list of dict."""
    return [
        {
            "criterion": each.criterion.id,
            "category": each.criterion.category,
            "title": each.criterion.title,
            "holds": each.holds,
            "margin": each.margin,
            "conditions": [
                {
                    "quantity": condition.condition.quantity.symbol,
                    "value": _finite(condition.value),
                    "comparison": condition.condition.comparison,
                    "threshold": condition.threshold,
                    "holds": condition.holds,
                    "margin": condition.margin,
                }
                for condition in each.conditions
            ],
        }
        for each in classification.checked
    ]


def descriptors_of(record):
    """The `Descriptors` that a record holds: all that a new verdict needs, without geometry."""
    content = record["descriptors"]
    parallel, slanted = content["distribution"], content["nonparallel"]
    shares = content["shares"]
    box = OrientedBox(np.array(content["box_mm"], float), np.array(content["box_axes"], float))
    return Descriptors(
        content["volume_mm3"], content["area_mm2"], box,
        Distribution(
            np.array(parallel["bins"], int), np.array(parallel["area"], float),
            np.array(slanted["bins"], int), np.array(slanted["angles"], int),
            np.array(slanted["area"], float),
            shares["parallel"], shares["nonparallel"], shares["unmeasured"], shares["unmet"],
        ),
        content["min_nonparallel"],
    )


def _descriptors(mesh, measurement, paper, error_bound):
    measured = measurement.descriptors
    shares = measured.distribution
    thinnest, median, thickest = measurement.wall_range
    return {
        "volume_mm3": measured.volume,
        "area_mm2": measured.area,
        "box_mm": measured.box.dimensions.tolist(),
        "box_axes": measured.box.axes.tolist(),
        "diagonal_mm": measured.box.diagonal,
        "volume_ratio": measured.value("volume_ratio"),
        "d1_d2": measured.value("d1_d2"),
        "d2_d3": measured.value("d2_d3"),
        "F": {f"{low:g}:{high:g}": shares.share(low, high) for low, high in REPORTED_SHARES},
        "teeth": int(_has_teeth(paper)),
        "min_nonparallel": measured.min_nonparallel,
        "thickness_mm": {
            "min": thinnest, "median": median, "max": thickest, "error_bound": error_bound,
        },
        "shares": {
            "parallel": shares.parallel,
            "nonparallel": shares.nonparallel,
            "unmeasured": shares.unmeasured,
            "unmet": shares.unmet,
        },
        "distribution": {"bins": shares.bins.tolist(), "area": shares.area.tolist()},
        "nonparallel": {
            "bins": shares.nonparallel_bins.tolist(),
            "angles": shares.nonparallel_angles.tolist(),
            "area": shares.nonparallel_area.tolist(),
        },
        "watertight": mesh.watertight,
    }


def _has_teeth(paper):
    """The paper's indicator of teeth-like features: whether its non-parallel criterion holds."""
    return any(
        each.holds and any(c.condition.quantity.name == "min_nonparallel" for c in each.conditions)
        for each in paper.checked
    )


def _face(face):
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
    """The same content with every float cut to `SIGNIFICANT_DIGITS`."""
    if isinstance(content, bool) or content is None:
        return content
    if isinstance(content, float):
        return float(f"{content:.{SIGNIFICANT_DIGITS}g}") + 0.0
    if isinstance(content, dict):
        return {key: _rounded(value) for key, value in content.items()}
    if isinstance(content, list):
        return [_rounded(value) for value in content]
    return content
