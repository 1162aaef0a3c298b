# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report page of one part."""

import base64
from types import SimpleNamespace

from ...core.categories import UNKNOWN
from ...core.descriptors.bins import BINS
from ...core.descriptors.descriptor_table import quantity_named
from ...core.descriptors.distribution_bars import bars, round_up
from ...core.foreign_text import json_text
from ...core.judging.criteria import profile_from
from ...core.judging.paper_verdict import paper_sentence
from ...core.judging.verdict_reasons import deciding_criteria, nearest_other, reason_of
from ...core.judging.verdict_sentence import verdict_sentence
from ...core.judging.wall_check import check_sentence, check_walls
from ...core.length_unit import MILLIMETRE
from ...core.record.face_names import face_number
from ...core.record.region_groups import region_groups
from ...core.record.verdict_chances import named_between, verdict_chances
from ...core.rendering.part_views import thinnest_wall
from ...core.risk.risk_sentence import risk_sentence
from ...storage.png import png_bytes
from .html_elements import page_bytes
from .page_language import ENGLISH, page_language
from .page_words import PageWords
from .part_sections import part_document

_LEFT, _RIGHT, _TOP, _BOTTOM = 90.0, 880.0, 40.0, 530.0
"""The plot area of the chart, in the units of its drawing."""

_BAR_LEFT, _BAR_RIGHT = 20.0, 660.0
_STOP_COUNT, _TICK_COUNT = 16, 4

_POWERS = {"mm": (1, ""), "mm2": (2, "\u00b2"), "mm3": (3, "\u00b3")}
"""Of the length, as a number and after the symbol, by the unit of a quantity."""


def part_page(record, pictures, features, about, file, overview, language=ENGLISH, unit=MILLIMETRE):
    """Create a self-contained page: bytes.

    Parameters
    ----------
    record : PartRecord
    pictures : PartPictures
    features : list of str
        The feature that made each face; may be empty.
    about : dict
        ``source``, ``settings``, ``profile`` as in an info file, and ``kept``: the annotations ``notes``,
        ``mesh``, ``link``, ``labels``, ``region_notes`` of the part; ``limits``, the WallLimits that its walls are checked
        against.
    file : str
        Name of the document in the report.
    overview : str
        URL of the overview, relative to the page.
    language : str, optional
        One of `LANGUAGES`.
    unit : LengthUnit, optional
        Of all lengths on the page.
    """
    profile = profile_from(about["profile"])
    titles = {category.name: category.title for category in profile.categories}
    meanings = {category.name: category.meaning for category in profile.categories}
    words = PageWords(page_language(language, unit), titles)
    return page_bytes(part_document(words, SimpleNamespace(
        part=record, file=file, overview=overview,
        meaning=meanings.get(record["category"], ""), profile=about["profile"],
        reason=_reason(record), deciding=deciding_criteria(record), other=nearest_other(record),
        chances=verdict_chances(record), between=named_between(record),
        paper=paper_sentence(record, profile),
        source=about["source"], settings=about["settings"], kept=_annotations(about["kept"]),
        views=[_view(view) for view in pictures.views()],
        thinnest=_thinnest_wall(record), scale=_scale(pictures, record), shown=pictures.measure,
        chart=_chart(record, unit), evidence=_evidence(record, unit), faces=_faces(record, features), features=features,
        regions=region_groups(record, about["kept"].get("region_notes") or ()), other_regions=record.get("regions"),
        checks=_checks(record, about), risk=risk_sentence(record),
    )))


def _reason(record):
    """What decided, in one sentence, or an empty text where the titles of the criteria have to say it."""
    if record["category"] == UNKNOWN:
        return reason_of(record)
    return verdict_sentence(record) or ""


def _checks(record, about):
    """The checks of the walls, each with its sentence and the source of its limits."""
    found = [check_walls(record, each) for each in about["limits"]]
    return [{"title": check.limits.full_title, "holds": check.holds, "min": check.limits.min_mm, "max": check.limits.max_mm,
             "sentence": check_sentence(check), "faces": check.faces, "note": check.limits.note,
             "source": check.limits.source} for check in found]


def _annotations(part):
    mesh = part.get("mesh")
    return {"notes": part.get("notes"), "link": part.get("link"), "labels": part.get("labels") or [],
            "mesh": None if mesh is None else json_text(mesh, indent=1)}


def _view(view):
    height, width, _ = view.pixels.shape
    png = png_bytes(view.pixels.tobytes(), width, height)
    content = {"name": view.name, "png": base64.b64encode(png).decode(), "ends": None}
    if view.thinnest is not None:
        ends = [[round(value, 1) for value in end] for end in (view.thinnest.point, view.thinnest.opposite)]
        content["ends"] = ends
        content["label"] = _label_position(ends)
    return content


def _label_position(ends):
    """Position of the label of the line between two points, so that it does not cover the line."""
    (x0, y0), (x1, y1) = ends
    steep = abs(y1 - y0) > abs(x1 - x0)
    x, y = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
    return (round(x + 95.0, 1), round(y + 9.0, 1)) if steep else (round(x, 1), round(y - 32.0, 1))


def _thinnest_wall(record):
    wall = thinnest_wall(record)
    if wall is None:
        return None
    face = next(face["face"] for face in record["faces"] if face["witness"] is wall)
    return {**wall, "face": face}


def _scale(pictures, record):
    scale = pictures.scale
    if scale is None:
        return None
    span = scale.high - scale.low
    shares = [stop / _STOP_COUNT for stop in range(_STOP_COUNT + 1)]
    limit = record["thin_limit_mm"]
    inside = span > 0.0 and scale.low <= limit <= scale.high
    width = _BAR_RIGHT - _BAR_LEFT
    limit_at = round(_BAR_LEFT + width * (limit - scale.low) / span, 1) if inside else None
    return {
        "low": scale.low, "high": scale.high,
        "stops": [(round(share, 4), _hexadecimal(colour))
                  for share, colour in zip(shares, scale.bar(shares))],
        "ticks": [(round(_BAR_LEFT + width * tick / _TICK_COUNT, 1), scale.low + span * tick / _TICK_COUNT)
                  for tick in range(_TICK_COUNT + 1 if span > 0.0 else 1)],
        "more": pictures.greatest > scale.high * (1.0 + 1e-3),
        "limit": limit_at, "limit_text": None if limit_at is None else max(limit_at, _BAR_LEFT + 60.0),
        "unmeasured": _hexadecimal(round(255 * value) for value in scale.unmeasured),
    }


def _hexadecimal(colour):
    return "#" + "".join(f"{int(value):02x}" for value in colour)


def _chart(record, unit):
    """The distribution in the units of the chart; its ticks are round numbers in the unit of the page."""
    measured = record["descriptors"]
    diagonal = measured["diagonal_mm"]
    limit = record["thin_limit_mm"] / diagonal
    found = bars(measured["distribution"]["bins"], measured["distribution"]["area"], limit)
    top = round_up(max(bar.area for bar in found) or 1.0)
    span = found[-1].high / BINS
    across, up = (_RIGHT - _LEFT) / span, (_BOTTOM - _TOP) / top

    def x(share):
        return round(_LEFT + share * across, 1)

    shown = []
    for bar in found:
        if bar.area > 0.0:
            height = max(3.0, bar.area * up)  # small bars must be visible too
            left, right = x(bar.low / BINS), x(bar.high / BINS)
            shown.append({
                "x": left, "width": round(max(1.0, right - left - 2.0), 1), "y": round(_BOTTOM - height, 1),
                "height": round(height, 1), "low": bar.low / BINS * diagonal,
                "high": bar.high / BINS * diagonal, "share": bar.area,
                "is_thin": bar.high <= round(limit * BINS),
            })
    step = unit.millimetres * round_up(unit.value(span * diagonal) / 5.0)
    return {
        "bars": shown, "end": span * diagonal, "limit": x(limit),
        "limit_text": min(max(x(limit), _LEFT + 90.0), _RIGHT - 110.0),
        "heights": [(round(_BOTTOM - share * top * up, 1), share * top) for share in (0.0, 0.5, 1.0)],
        "widths": [(x(count * step / diagonal), count * step)
                   for count in range(int(span * diagonal / step) + 1)],
    }


def _evidence(record, unit):
    return [{**row, "conditions": [_condition(condition, unit) for condition in row["conditions"]]}
            for row in record["evidence"]]


def _condition(condition, unit):
    quantity = quantity_named(condition["quantity"])
    power, sign = _POWERS.get(quantity.unit, (0, ""))
    return {**condition, "value": unit.value(condition["value"], power),
            "threshold": unit.value(condition["threshold"], power), "unit": unit.symbol + sign if power else "",
            "symbol": quantity.symbol, "meaning": quantity.meaning, "bounds": quantity.bounds,
            "is_absent": condition["value"] is None and quantity.absent_means is not None}


def _faces(record, features):
    """Faces with the thinnest first, those without a wall last."""
    # Faces without triangles have no entry.
    faces = [{**face, "feature": dict(enumerate(features)).get(face_number(face), "")}
             for face in record["faces"]]
    return sorted(faces, key=lambda face: (face["min"] is None, face["min"] or 0.0))
