# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of a part as its record keeps it: few numbers as such, and the outline packed."""

import base64
import binascii
import zlib
from itertools import permutations

import numpy as np

from ..errors import ThinPartError
from ..message import message
from .form import Form
from .moments import SurfaceMoments
from .outline import MOST_POINTS, Outline

NUMBERS = 21
"""Of a packed form."""

_STEPS = 32767
_PAIRS = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
_TRIPLES = ((0, 0, 0), (0, 0, 1), (0, 0, 2), (0, 1, 1), (0, 1, 2), (0, 2, 2), (1, 1, 1), (1, 1, 2), (1, 2, 2), (2, 2, 2))


def recorded_form(form):
    """The ``form`` of a part record: FormRecord."""
    moments, outline = form.moments, form.outline
    return {
        "centroid": moments.centroid.tolist(),
        "second_mm2": [float(moments.second[pair]) for pair in _PAIRS],
        "third_mm3": [float(moments.third[triple]) for triple in _TRIPLES],
        "points": outline.count,
        "reach_mm": float(np.abs(outline.points).max()),
        "outline": base64.b64encode(packed_outline(outline)).decode("ascii"),
    }


def packed_form(record):
    """The form of a part record as two bytes objects, its numbers and its outline; None and None where it has none."""
    content = record.get("form")
    if content is None:
        return None, None
    numbers = (record["descriptors"]["area_mm2"], *content["centroid"], *content["second_mm2"], *content["third_mm3"],
               content["reach_mm"])
    return np.array(numbers, dtype="<f8").tobytes(), base64.b64decode(content["outline"])


def unpacked_numbers(packed):
    """The numbers of many packed forms: ndarray of shape (n, NUMBERS).

    Area, centroid, second moments, third moments, reach. Raises a ValueError if one of them is damaged.
    """
    return np.frombuffer(b"".join(packed), dtype="<f8").reshape(len(packed), NUMBERS)


def unpacked_form(numbers, outline):
    """The `Form` of a row of `unpacked_numbers` and its packed outline; raises as `form_of_record`."""
    return restored_form(float(numbers[0]), numbers[1:4], numbers[4:10], numbers[10:20], float(numbers[20]), outline)


def second_moments(numbers):
    """ndarray of shape (n, 3, 3), mm2: second moments of rows of `unpacked_numbers`."""
    found = np.empty((len(numbers), 3, 3))
    for column, (i, j) in enumerate(_PAIRS):
        found[:, i, j] = found[:, j, i] = numbers[:, 4 + column]
    return found


def third_moments(numbers):
    """ndarray of shape (n, 3, 3, 3), mm3: third moments of rows of `unpacked_numbers`."""
    found = np.empty((len(numbers), 3, 3, 3))
    for column, triple in enumerate(_TRIPLES):
        for place in set(permutations(triple)):
            found[:, place[0], place[1], place[2]] = numbers[:, 10 + column]
    return found


def form_of_record(record):
    """The `Form` of a part record; None where an earlier version wrote it.

    Raises ThinPartError, kind ``info_file``, where the outline is damaged.
    """
    content = record.get("form")
    if content is None:
        return None
    try:
        packed = base64.b64decode(content["outline"], validate=True)
    except binascii.Error:
        raise _damaged() from None
    return restored_form(record["descriptors"]["area_mm2"], content["centroid"], content["second_mm2"], content["third_mm3"],
                         content["reach_mm"], packed)


def restored_form(area, centroid, second, third, reach, packed):
    """The `Form` of its numbers and its packed outline; raises as `form_of_record`."""
    square, cube = np.empty((3, 3)), np.empty((3, 3, 3))
    for value, (i, j) in zip(second, _PAIRS):
        square[i, j] = square[j, i] = value
    for value, (i, j, k) in zip(third, _TRIPLES):
        cube[i, j, k] = cube[i, k, j] = cube[j, i, k] = cube[j, k, i] = cube[k, i, j] = cube[k, j, i] = value
    outline = _unpacked_outline(packed, reach)
    if not len(outline.points):
        raise _damaged()
    return Form(SurfaceMoments(area, np.array(centroid), square, cube), outline)


def packed_outline(outline):
    """Pack an outline into bytes: points and normals in steps of their greatest coordinate by 32767, faces, and areas."""
    reach = max(float(np.abs(outline.points).max()), np.finfo(float).tiny)
    columns = (np.round(outline.points.T / reach * _STEPS).astype("<i2"), np.round(outline.normals.T * _STEPS).astype("<i2"),
               outline.face.astype("<i4"), outline.area.astype("<f4"))
    return zlib.compress(b"".join(np.ascontiguousarray(column).tobytes() for column in columns), 6)


def _unpacked_outline(packed, reach):
    bytes_each = 20
    try:
        unpacking = zlib.decompressobj()
        content = unpacking.decompress(packed, bytes_each * 4 * MOST_POINTS)
    except zlib.error:
        raise _damaged() from None
    count, rest = divmod(len(content), bytes_each)
    if rest or not unpacking.eof:
        raise _damaged()
    integers = np.frombuffer(content, "<i2", 6 * count).reshape(6, count).astype(float) / _STEPS
    face = np.frombuffer(content, "<i4", count, 12 * count).astype(np.int64)
    area = np.frombuffer(content, "<f4", count, 16 * count).astype(float)
    if not (np.isfinite(area).all() and (area > 0.0).all() and (face >= 0).all()):
        raise _damaged()
    return Outline(np.ascontiguousarray(integers[:3].T) * reach, np.ascontiguousarray(integers[3:].T), face, area)


def _damaged():
    return ThinPartError(message("The outline in an info file is damaged: classify its document again."), "info_file")
