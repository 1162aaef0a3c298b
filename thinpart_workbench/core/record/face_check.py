# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces with limits of their own, and what a check of the walls leaves to compare without them."""

from dataclasses import dataclass
from typing import Optional

from ..figures import Length
from ..message import message
from .face_limits import limited_faces

NEAR = 0.02
"""Share of a limit by which a wall may be over or under it: facets lie inside of round faces."""

_MOST_NAMED = 4


@dataclass(frozen=True)
class FaceCheck:
    """A face compared with its own limits.

    Attributes
    ----------
    face : str
        Its name now, or the one that it had where it is gone.
    min_mm, max_mm : float or None
    reason : str
    wall_mm, ball_mm : float or None
        The thinnest wall of the face, and the median of the largest balls that reach it.
    holds : bool or None
        None where the face is gone, or nothing is known of it.
    is_gone : bool
    """

    face: str
    min_mm: Optional[float]
    max_mm: Optional[float]
    reason: str
    wall_mm: Optional[float] = None
    ball_mm: Optional[float] = None
    holds: Optional[bool] = None
    is_gone: bool = False

    @property
    def is_over(self):
        """bool: whether it is thicker than its own limit."""
        return self.max_mm is not None and self.ball_mm is not None and self.ball_mm > (1.0 + NEAR) * self.max_mm

    def content(self):
        """dict for JSON."""
        return {"face": self.face, "min_mm": self.min_mm, "max_mm": self.max_mm, "reason": self.reason,
                "thinnest_mm": self.wall_mm, "ball_mm": self.ball_mm, "passes": self.holds, "is_gone": self.is_gone}


def check_faces(record):
    """Compare the faces of a part record that have limits of their own: list of FaceCheck."""
    return [_checked(limit, face) for limit, face in limited_faces(record)]


def least_elsewhere(record, checks):
    """The thinnest wall apart from those of faces with a least wall of their own, mm; None where there is no other.

    A wall that is thinnest on the face opposite counts for the face that it lies opposite of.

    Parameters
    ----------
    record : PartRecord
    checks : list of FaceCheck
    """
    own = {check.face for check in checks if check.min_mm is not None and not check.is_gone}
    walls = [face["min"] for face in record["faces"] if face["face"] not in own and not (
        face["witness"] is not None and face["witness"]["opposite_face"] in own)]
    return min((wall for wall in walls if wall is not None), default=None)


def face_sentences(checks):
    """The results in sentences, those of one reason together: list of Message."""
    groups: dict = {}
    for number, check in enumerate(checks):
        alone = number if check.holds is False else None
        groups.setdefault((check.is_gone, check.holds, check.reason, alone), []).append(check)
    return [_sentence(equal) for equal in groups.values()]


def _sentence(equal):
    check, faces = equal[0], ", ".join(each.face for each in equal[:_MOST_NAMED])
    if len(equal) > _MOST_NAMED:
        faces += f", \u2026 ({len(equal)})"
    if check.is_gone:
        return message("Not found any more, though with a limit of its own ({reason}): {faces}: set it anew, or remove it.",
                       reason=check.reason, faces=faces)
    if check.holds is None:
        return message("With a limit of its own ({reason}), but without a wall that could be measured: {faces}.",
                       reason=check.reason, faces=faces)
    if check.holds:
        return message("Within a limit of its own ({reason}): {faces}.", reason=check.reason, faces=faces)
    if _is_under(check):
        return message("{face} fails its own limit: {wall}, at least {least} ({reason}).", face=check.face,
                       wall=Length(check.wall_mm), least=Length(check.min_mm), reason=check.reason)
    return message("{face} fails its own limit: {ball}, at most {most} ({reason}).", face=check.face,
                   ball=Length(check.ball_mm), most=Length(check.max_mm), reason=check.reason)


def _checked(limit, face):
    least, most = limit.get("min_mm"), limit.get("max_mm")
    if face is None:
        return FaceCheck(limit["face"], least, most, limit["reason"], is_gone=True)
    check = FaceCheck(face["face"], least, most, limit["reason"], face["min"], face.get("ball_mm"))
    unknown = (least is not None and check.wall_mm is None) or (most is not None and check.ball_mm is None)
    holds = None if unknown else not _is_under(check) and not check.is_over
    return FaceCheck(check.face, least, most, check.reason, check.wall_mm, check.ball_mm, holds)


def _is_under(check):
    return check.min_mm is not None and check.wall_mm is not None and check.wall_mm < (1.0 - NEAR) * check.min_mm
