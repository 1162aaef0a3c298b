# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two parts whose documents are read again, so that their own geometry is compared. Most of it runs in a worker process."""

import os
from dataclasses import dataclass

import numpy as np

from ...core.errors import ThinPartError
from ...core.forms.comparison import GEOMETRY_SAME, Side, compared
from ...core.forms.face_match import face_match
from ...core.forms.form import Form
from ...core.forms.laying import share_of
from ...core.kinds.compound_kinds import ListOf, Record
from ...core.kinds.value_kinds import Flag, Number, Whole
from ...core.message import message
from ...core.reuse.likeness import is_whole
from ..workers.preparation import require_preparation

VERSION = 6
"""Of what a comparison is; results of another one are not taken from the cache."""


@dataclass(frozen=True)
class ComparedPart:
    """One of two parts.

    Attributes
    ----------
    file : str
        Its document.
    sha256 : str
        Of that.
    name : str
    form : Form
    """

    file: str
    sha256: str
    name: str
    form: Form


@dataclass(frozen=True)
class ComparisonTask:
    """Compare a part with another.

    Attributes
    ----------
    part, reference : ComparedPart
    motions : tuple of Motion
        That lay the part upon the other, nearly: the first that makes them one form is taken, or the best one.
    """

    part: ComparedPart
    reference: ComparedPart
    motions: tuple

    @property
    def file(self):
        """Document of the part."""
        return self.part.file

    @property
    def key(self):
        """A text that says what is compared."""
        motions = [(round(motion.scale, 4), np.round(motion.turn, 2).tolist()) for motion in self.motions]
        return f"{VERSION} {self.part.sha256} {self.part.name} {self.reference.sha256} {self.reference.name} {motions}"


TRIANGLES_SAME = 1e-2
"""Distance up to which triangles are the same as a surface, as a share of the extent."""

_FACE = Record({"face": Whole(0), "share": Number(0.0, 1.0), "place": ListOf(Number(), most=3), "distance_mm": Number(0.0)})
_SIDE = Record({"share": Number(0.0, 1.0 + 1e-9), "greatest_mm": Number(0.0), "points": Whole(1), "faces": ListOf(_FACE)})

ANSWER = Record({"are_solids": Flag(), "extent_mm": Number(0.0), "motion": Whole(0), "part": _SIDE, "reference": _SIDE})
"""Kind of the answer to a `ComparisonTask`: which of its motions was taken, and what of each of the two lies on the other,
face by face."""


def compare(task):
    """Compare the geometry of two parts: dict as `ANSWER`. Raises ThinPartError where one of them cannot be read."""
    part, reference = part_of(task.part), part_of(task.reference)
    side, other = Side(task.part.form, part.nearest_points()), Side(task.reference.form, reference.nearest_points())
    are_solids, best = part.can_be_finer and reference.can_be_finer, None
    for number, motion in enumerate(task.motions):
        found = _answer(compared(side, other, motion), task, are_solids, number)
        if best is None or _least_share(found) > _least_share(best):
            best = found
        if is_whole(found) or not are_solids:
            break
    return best


def comparison_by_worker(task):
    """As `compare`, in a worker process."""
    require_preparation()
    return compare(task)


def checked_comparison(task, answer):
    """The answer to a task, as `ANSWER`. Raises ValueError where it is none; the text says why, in a few words."""
    fault = ANSWER.fault(answer, "")
    if fault or answer["motion"] >= len(task.motions):
        raise ValueError(fault or message("it has no such motion"))
    return answer


def _least_share(answer):
    return min(answer["part"]["share"], answer["reference"]["share"])


def _answer(found, task, are_solids, number):
    extent = task.reference.form.extent
    same = (GEOMETRY_SAME if are_solids else TRIANGLES_SAME) * extent
    return {
        "are_solids": are_solids,
        "extent_mm": extent,
        "motion": number,
        "part": side_answer(found.form, found.laid.distance, same),
        "reference": side_answer(found.other, found.laid.other_distance, same),
    }


def side_answer(form, distance, same):
    """What of a form lies on another, as in `ANSWER`.

    Parameters
    ----------
    form : Form
    distance : ndarray of shape (k,), mm
        Of the points of its outline from the other.
    same : float, mm
        Distance up to which surfaces are the same.
    """
    distance = np.minimum(distance, 2.0 * form.extent)  # where there is nothing like it near by
    match = face_match(form.outline, distance, same)
    return {
        "share": share_of(form, distance <= same), "greatest_mm": float(distance.max()), "points": form.outline.count,
        "faces": [{"face": int(face), "share": float(part), "place": place.tolist(), "distance_mm": float(away)}
                  for face, part, place, away in zip(match.faces, match.share, match.place + form.moments.centroid,
                                                     match.distance)],
    }


def part_of(compared_part):
    """The part of its document, SolidPart or MeshedPart.

    Raises ThinPartError, kind ``missing`` where the document is gone, and ``info_file`` where it has no part of this name
    any more.
    """
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.reading.part_files import read_parts

    if not os.path.exists(compared_part.file):
        raise ThinPartError(message("The file {file} no longer exists.", file=compared_part.file), "missing")
    for part in read_parts(compared_part.file).parts:
        if part.name == compared_part.name:
            return part
    raise ThinPartError(message("{file} has no part {part} any more: classify it again.",
                                file=compared_part.file, part=compared_part.name), "info_file")
