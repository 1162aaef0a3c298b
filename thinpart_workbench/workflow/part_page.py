"""The page of a report about one part."""

import base64
import json

from .. import __version__
from ..core.criteria import profile_from
from ..core.descriptors import quantity_named
from ..core.distribution import BINS
from ..core.distribution_bars import bars, round_up
from ..core.part_record import face_number
from ..core.part_views import HEIGHT, WIDTH, thinnest_wall
from ..core.verdict_reasons import deciding_criteria, nearest_other
from ..storage.png import png_bytes
from .page_templates import fill_in

SHOWN_FACES = 12
"""Faces that are in sight; the others are folded away."""

_LEFT, _RIGHT, _TOP, _BOTTOM = 90.0, 880.0, 40.0, 530.0
"""Plot of the chart, in the units of its template."""

_BAR_LEFT, _BAR_RIGHT = 20.0, 740.0
_STOPS, _TICKS = 16, 4


def part_page(record, pictures, features, about, file, overview):
    """Make a page that needs nothing but itself.

    Parameters
    ----------
    record : dict
        Part record.
    pictures : PartPictures
    features : list of str
        What made each face; may be empty.
    about : dict
        ``source``, ``settings``, ``profile`` as in an info file, and ``kept``: ``notes``, ``mesh``,
        ``link`` of the part.
    file : str
        How the document is named.
    overview : str
        Address of the overview, as seen from the page.

    Returns
    -------
    bytes
    """
    profile = profile_from(about["profile"])
    titles = {each.name: each.title for each in profile.categories}
    meanings = {each.name: each.meaning for each in profile.categories}
    return fill_in(
        "part.html", part=record, file=file, overview=overview, software=__version__,
        titles=titles, meaning=meanings.get(record["category"], ""), profile=about["profile"],
        deciding=deciding_criteria(record), other=nearest_other(record),
        thickness=record["descriptors"]["thickness_mm"], shares=record["descriptors"]["shares"],
        source=about["source"], settings=about["settings"], kept=_kept(about["kept"]),
        views=[_view(each) for each in pictures.views()], width=WIDTH, height=HEIGHT,
        thinnest=_thinnest(record), scale=_scale(pictures.scale, record), chart=_chart(record),
        evidence=_evidence(record), faces=_faces(record, features), features=features,
        shown_faces=SHOWN_FACES,
    )


def _kept(kept):
    mesh = kept.get("mesh")
    return {"notes": kept.get("notes"), "link": kept.get("link"),
            "mesh": None if mesh is None else json.dumps(mesh, indent=1, ensure_ascii=False)}


def _view(view):
    content = {"name": view.name, "png": base64.b64encode(png_bytes(view.pixels)).decode(), "ends": None}
    if view.thinnest is not None:
        ends = [[round(value, 1) for value in end] for end in (view.thinnest.point, view.thinnest.opposite)]
        content["ends"] = ends
        content["label"] = _beside(ends)
    return content


def _beside(ends):
    """Where the length of the line between two places can be written without covering it."""
    (x0, y0), (x1, y1) = ends
    steep = abs(y1 - y0) > abs(x1 - x0)
    x, y = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
    return (round(x + 95.0, 1), round(y + 9.0, 1)) if steep else (round(x, 1), round(y - 32.0, 1))


def _thinnest(record):
    wall = thinnest_wall(record)
    if wall is None:
        return None
    face = next(each["face"] for each in record["faces"] if each["witness"] is wall)
    return {**wall, "face": face}


def _scale(scale, record):
    if scale is None:
        return None
    span = scale.high - scale.low
    shares = [stop / _STOPS for stop in range(_STOPS + 1)]
    limit = record["thin_limit_mm"]
    inside = span > 0.0 and scale.low <= limit <= scale.high
    thickest = record["descriptors"]["thickness_mm"]["max"]
    width = _BAR_RIGHT - _BAR_LEFT
    limit_at = round(_BAR_LEFT + width * (limit - scale.low) / span, 1) if inside else None
    return {
        "low": scale.low, "high": scale.high,
        "stops": [(round(share, 4), _hexadecimal(colour))
                  for share, colour in zip(shares, scale.bar(shares))],
        "ticks": [(round(_BAR_LEFT + width * tick / _TICKS, 1), scale.low + span * tick / _TICKS)
                  for tick in range(_TICKS + 1 if span > 0.0 else 1)],
        "more": thickest is not None and thickest > scale.high * (1.0 + 1e-3),
        "limit": limit_at, "limit_text": None if limit_at is None else max(limit_at, _BAR_LEFT + 60.0),
        "unmeasured": _hexadecimal(round(255 * value) for value in scale.unmeasured),
    }


def _hexadecimal(colour):
    return "#" + "".join(f"{int(value):02x}" for value in colour)


def _chart(record):
    """The distribution in the units of its picture."""
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
            height = max(3.0, bar.area * up)  # what is there must be seen, small as it is
            left, right = x(bar.low / BINS), x(bar.high / BINS)
            shown.append({
                "x": left, "width": round(max(1.0, right - left - 2.0), 1), "y": round(_BOTTOM - height, 1),
                "height": round(height, 1), "low": bar.low / BINS * diagonal,
                "high": bar.high / BINS * diagonal, "share": bar.area,
                "is_thin": bar.high <= round(limit * BINS),
            })
    step = round_up(span * diagonal / 5.0)
    return {
        "bars": shown, "end": span * diagonal, "limit": x(limit),
        "limit_text": min(max(x(limit), _LEFT + 90.0), _RIGHT - 110.0),
        "heights": [(round(_BOTTOM - share * top * up, 1), share * top) for share in (0.0, 0.5, 1.0)],
        "widths": [(x(count * step / diagonal), count * step)
                   for count in range(int(span * diagonal / step) + 1)],
    }


def _evidence(record):
    return [{**row, "conditions": [_condition(each) for each in row["conditions"]]}
            for row in record["evidence"]]


def _condition(condition):
    quantity = quantity_named(condition["quantity"])
    meaning = quantity.meaning
    if quantity.bounds:
        meaning += f" (a = {quantity.bounds[0]:g}, b = {quantity.bounds[1]:g})"
    return {**condition, "symbol": quantity.symbol, "meaning": meaning,
            "is_absent": condition["value"] is None and quantity.absent_means is not None}


def _faces(record, features):
    """The thinnest first, those without a wall last."""
    # Faces without triangles have no entry.
    faces = [{**face, "feature": dict(enumerate(features)).get(face_number(face), "")}
             for face in record["faces"]]
    return sorted(faces, key=lambda face: (face["min"] is None, face["min"] or 0.0))
