# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the walls of a part lie within the limits of a process, from its record alone. Nothing is measured here.

Command lines list and check stored parts without numpy, so neither is it imported here.
"""

import math
from dataclasses import dataclass, replace
from functools import reduce
from typing import NamedTuple, Optional

from ..descriptors.bins import BINS, MIDDLE_BINS
from ..descriptors.descriptor_table import STATED_FLOOR
from ..descriptors.wall_kinds import EDGE
from ..figures import Length, Share
from ..message import message
from ..record.face_check import check_faces, face_sentences, least_elsewhere
from ..tolerances import TOLERANCES
from .wall_limits import WallLimits

TOO_COARSE = 0.5
"""Error of a wall, as a share of the limit, from which on a wall near the limit cannot be told."""

THICK_FROM, THIN_UP_TO = 0.25, 0.05
"""Share of the volume outside walls of the greatest thickness from which on a part is too thick, and up to which it is not,
where the largest balls are not known. What lies between may be where walls meet: there a ray runs along one of them."""

WHERE_WALLS_MEET, THICK_SHARE = 1.5, 0.01
"""The largest ball where walls of one thickness meet is 1.17 times as thick in a corner, 1.25 where one ends on another and
1.41 where they cross. Up to the first of these, a part is too thick only if that share of the surface sees such a wall."""

NEAR = 0.02
"""Share of the least wall by which the thinnest may be thinner where its error bound allows for that: limits of guides are
no more precise."""

LEAST_SHARE = 1e-6
"""Share that is said of a place that has no area in the distribution."""

CLOSE = 0.05
"""Greatest difference between bounds of a share that is given as one figure."""


@dataclass(frozen=True)
class MeasuredWalls:
    """What a check needs of a part. Areas are shares of the surface, by bins of x as in `Distribution`.

    Attributes
    ----------
    thinnest, error : float or None, mm
        The thinnest wall at any angle, and how far it may be off.
    volume, area : float or None, mm3 and mm2
    diagonal : float, mm
    walls, slanted : tuple of (sequence of int, sequence of float)
        Bins and areas of parallel walls and of those at 10 to 60 degrees.
    unmeasured, unmet : float
        Shares of the surface without a wall that could be measured, and whose rays met nothing.
    thickest : float or None, mm
        The largest ball inside that reaches a hundredth of the surface; None where balls were not looked for.
    """

    thinnest: Optional[float]
    error: float
    volume: Optional[float]
    area: float
    diagonal: float
    walls: tuple
    slanted: tuple
    unmeasured: float
    unmet: float
    thickest: Optional[float] = None

    @classmethod
    def of_record(cls, record):
        """Those of a part record."""
        content = record["descriptors"]
        wall, shares = content["thickness_mm"], content["shares"]
        walls, slanted = content["distribution"], content["nonparallel"]
        ball = content.get("local", {}).get("T99")
        return cls(wall["min"], wall["error_bound"], content["volume_mm3"], content["area_mm2"], content["diagonal_mm"],
                   (walls["bins"], walls["area"]), (slanted["bins"], slanted["area"]),
                   shares["unmeasured"], shares["unmet"], ball and ball * content["box_mm"][1])

    def share_under(self, limit):
        """Least and greatest share of the surface over walls, parallel or not, thinner than a limit in mm: two floats.

        They differ by what lies in the bin that the limit cuts.
        """
        cut = self._bin_of(limit)
        rows = [row for table in (self.walls, self.slanted) for row in zip(*table)]
        return sum(area for bin_, area in rows if bin_ < cut), sum(area for bin_, area in rows if bin_ <= cut)

    def share_over(self, limit):
        """Share of the surface over walls, parallel or not, that are surely thicker than a limit in mm: float."""
        return self.share_between(limit, math.inf)

    def share_between(self, low, high):
        """The same up to a thickness."""
        cut, end = self._bin_of(low), math.inf if math.isinf(high) else self._bin_of(high)
        return sum(area for table in (self.walls, self.slanted) for bin_, area in zip(*table) if cut < bin_ <= end)

    def tapered_under(self, limit):
        """Share of the surface over walls at 10 to 60 degrees that are surely thinner than a limit in mm: float."""
        cut = self._bin_of(limit)
        return sum(area for bin_, area in zip(*self.slanted) if bin_ < cut)

    def volume_outside(self, limit):
        """Least share of the volume that no wall up to a limit, mm, encloses: float, or None where there is no volume.

        A wall of thickness t under an area a on either side holds a t / 2 for each of them. Where all walls up to the
        limit, taken at the upper ends of their bins, and the surface without a wall, taken at the limit, together hold
        less than the part, the rest lies deeper than the limit allows.
        """
        if not self.volume:
            return None
        cut = self._bin_of(limit)
        reach = self.unmeasured * limit + sum(
            area * min((bin_ + 1) / BINS * self.diagonal, limit)
            for table in (self.walls, self.slanted) for bin_, area in zip(*table) if bin_ <= cut)
        return max(0.0, 1.0 - 0.5 * self.area * reach / self.volume)

    def _bin_of(self, millimetres):
        return int(math.floor((millimetres / self.diagonal + TOLERANCES.bin_edge) * BINS))


@dataclass(frozen=True)
class WallCheck:
    """The result of a check.

    Attributes
    ----------
    limits : WallLimits
    holds : bool or None
        None where it cannot be told.
    within_tolerance : bool
        Whether the error bound of the thinnest wall spans the least wall, so that the result might just be the other.
    thin_holds, thick_holds : bool or None
        For the least and the greatest wall alone; true where the process has no such limit.
    thinnest_mm : float or None, mm
    error_mm : float, mm
    thinnest_face : str
        Empty where it is not known.
    thin_share : tuple of float
        Least and greatest share of the surface under the least wall.
    thick_share : float
        Share of the surface where the part is thicker than the greatest: a larger ball inside reaches it.
    tapered_share : float
        Share of the surface over tapered walls thinner than the least.
    faces : tuple of str
        Faces with a wall under the least one, the thinnest first.
    thickest_mm : float or None, mm
        The largest ball inside that reaches a hundredth of the surface.
    thick_faces : tuple of str
        Faces half of which balls larger than the greatest wall reach, the thickest first.
    own : tuple of FaceCheck
        Faces with limits of their own, which the others are compared without.
    edge_mm : float or None, mm
        How far from a sharp edge the thinnest wall is, where that ends in one; see `ThinnestPlace`.
    walls_mm : float or None, mm
        The thinnest wall that does not, in that case.
    """

    limits: WallLimits
    holds: Optional[bool]
    within_tolerance: bool
    thin_holds: Optional[bool]
    thick_holds: Optional[bool]
    thinnest_mm: Optional[float]
    error_mm: float
    thinnest_face: str = ""
    thin_share: tuple = (0.0, 0.0)
    thick_share: float = 0.0
    tapered_share: float = 0.0
    faces: tuple = ()
    thickest_mm: Optional[float] = None
    thick_faces: tuple = ()
    own: tuple = ()
    edge_mm: Optional[float] = None
    walls_mm: Optional[float] = None

    @property
    def is_only_at_edges(self):
        """bool: whether nothing fails but walls that end in sharp edges."""
        least = self.limits.min_mm
        if least is None or self.edge_mm is None or self.thin_holds is not False or self.thick_holds is False:
            return False
        return self.walls_mm is None or self.walls_mm >= (1.0 - NEAR) * least

    @property
    def thick_from(self):
        """Balls of which diameter are too thick: float, mm, infinite for none, and a dict of the same by name for the faces
        with a greatest wall of their own."""
        own = {each.face: (1.0 + NEAR) * each.max_mm if each.is_over else math.inf
               for each in self.own if each.max_mm is not None and not each.is_gone}
        return math.inf if self.thick_holds or self.limits.max_mm is None else (1.0 + NEAR) * self.limits.max_mm, own

    def content(self):
        """dict for JSON."""
        return {
            "process": self.limits.name, "min_mm": self.limits.min_mm, "max_mm": self.limits.max_mm,
            "passes": self.holds, "within_tolerance": self.within_tolerance,
            "thinnest_mm": self.thinnest_mm, "error_bound_mm": self.error_mm, "thinnest_face": self.thinnest_face or None,
            "thin_share": [round(share, 9) for share in self.thin_share], "thick_share": round(self.thick_share, 9),
            "tapered_share": round(self.tapered_share, 9),
            "faces": list(self.faces), "thickest_mm": self.thickest_mm, "thick_faces": list(self.thick_faces),
            "face_limits": [each.content() for each in self.own], "sentence": check_sentence(self),
        }


def wall_verdict(measured, limits):
    """Compare the walls of a part with the limits of a process.

    Parameters
    ----------
    measured : MeasuredWalls
    limits : WallLimits

    Returns
    -------
    thin_holds, thick_holds : bool or None
        Whether no wall is thinner, and none thicker, than it may be; None where it cannot be told.
    within_tolerance : bool
    """
    thin_holds, within = _is_thick_enough(measured, limits.min_mm)
    return thin_holds, _is_thin_enough(measured, limits.max_mm), within


def check_walls(record, limits):
    """Check a part: WallCheck.

    The least wall is compared with the part's thinnest wall, at any angle, which has an extent (`thin_places`), so that
    stray rays decide nothing. A wall that ends in a sharp edge is as thin as it is at the stated depth beside that. The
    greatest wall is compared with the largest balls inside, whichever way rays run: a ray from the edge of a
    plate runs along it, and would call every plate thick.

    Parameters
    ----------
    record : PartRecord
        It may lack its faces, which make shares of the surface more precise.
    limits : WallLimits
    """
    return _check(record, limits, judged_walls(record, MeasuredWalls.of_record(record), limits))


class JudgedWalls(NamedTuple):
    """What decides a check; see `WallCheck` for ``holds``, ``thin_holds``, ``thick_holds``, ``within`` and ``own``.

    ``measured`` is what was measured, apart from faces with a least wall of their own, ``thick`` the names of the faces that
    are thicker than the process allows, the thickest first.
    """

    holds: Optional[bool]
    thin_holds: Optional[bool]
    thick_holds: Optional[bool]
    within: bool
    measured: MeasuredWalls
    thick: tuple
    own: tuple


def judged_walls(limited, measured, limits):
    """Compare the walls of a part with the limits of a process, and faces that have limits of their own with these.

    Returns JudgedWalls.

    Parameters
    ----------
    limited : dict
        ``faces`` and ``face_limits`` of a part record; see `limited_part`. Either may be missing.
    measured : MeasuredWalls
    limits : WallLimits
    """
    own = tuple(check_faces(limited))
    measured = _without(own, limited, measured)
    thin_holds, thick_holds, within = wall_verdict(measured, limits)
    if measured.thinnest is None and any(each.min_mm is not None and not each.is_gone for each in own):
        thin_holds = True  # all walls have limits of their own
    apart = {each.face for each in own if each.max_mm is not None and not each.is_gone}
    over = () if limits.max_mm is None else _faces_over(limited, limits.max_mm)
    thick = tuple(face for face in over if face not in apart)
    if thick_holds is False and apart and not thick:
        thick_holds = True
    verdicts = (thin_holds, thick_holds, *(False for each in own if each.holds is False))
    holds = False if False in verdicts else None if None in verdicts else True
    return JudgedWalls(holds, thin_holds, thick_holds, within, measured, thick, own)


def _without(own, limited, measured):
    """What was measured, with the thinnest wall apart from those of faces with a least wall of their own."""
    if not any(each.min_mm is not None and not each.is_gone for each in own) or measured.thinnest is None:
        return measured
    least = least_elsewhere(limited, own)
    return replace(measured, thinnest=None if least is None else max(least, measured.thinnest))


def _check(record, limits, judged):
    """The result: WallCheck."""
    holds, thin_holds, thick_holds, within, measured, thick, own = judged
    apart = {each.face for each in own if each.min_mm is not None}
    least = [(face["min"], face["face"]) for face in record.get("faces", ()) if face["face"] not in apart]
    place = record.get("thinnest")
    is_of_all = place is not None and measured.thinnest == record["descriptors"]["thickness_mm"]["min"]
    is_at_edge = is_of_all and place["kind"] == EDGE
    faces = sorted((wall, face) for wall, face in least if wall is not None)
    named = place["face"] if is_of_all and place["face"] not in apart else faces[0][1] if faces else ""
    failing = thin_holds is False
    return WallCheck(
        limits, holds, within, thin_holds, thick_holds, measured.thinnest, measured.error, named,
        _thin_share(record, measured, limits.min_mm) if failing else (0.0, 0.0),
        0.0 if limits.max_mm is None else _thick_share(record, measured, limits.max_mm, thick_holds),
        0.0 if limits.min_mm is None else measured.tapered_under(limits.min_mm),
        tuple(face for wall, face in faces if failing and wall < limits.min_mm),
        measured.thickest, thick if thick_holds is False else (), own,
        place["depth_mm"] if is_at_edge else None, place["walls_mm"] if is_at_edge else None,
    )


def check_sentence(check):
    """The result in sentences with figures: Message.

    Those on faces with limits of their own come last, unless these are all that fails.
    """
    process, own = check.limits.full_title, face_sentences(check.own)
    of_others = check.thin_holds, check.thick_holds
    if check.holds is not False or False in of_others:
        return _together([_process_sentence(check), *own])
    if None in of_others:
        return message("{process}: fails: {faces} Of all other faces it cannot be told.", process=process,
                       faces=_together(own))
    return message("{process}: fails: {faces} All other faces pass.", process=process, faces=_together(own))


def _together(sentences):
    """Sentences one after the other: Message."""
    return reduce(lambda check, faces: message("{check} {faces}", check=check, faces=faces), sentences)


def _process_sentence(check):
    limits, thinnest, error = check.limits, Length(check.thinnest_mm), Length(check.error_mm)
    process, least, most = limits.full_title, Length(limits.min_mm), Length(limits.max_mm)
    if check.is_only_at_edges:
        return message("{process}: fails, but only where walls end in sharp edges: {findings}.", process=process,
                       findings=_findings(check))
    if False in (check.thin_holds, check.thick_holds):
        return message("{process}: fails: {findings}.", process=process, findings=_findings(check))
    if check.thinnest_mm is None and check.thin_holds and check.own:
        return message("{process}: all walls have limits of their own.", process=process)
    if check.thin_holds is None and check.thinnest_mm is None:
        return message("{process}: cannot be told: no wall could be measured.", process=process)
    if check.thin_holds is None and check.error_mm > TOO_COARSE * limits.min_mm:
        return message("{process}: cannot be told: the thinnest wall is {thinnest}, give or take {error:.2g}, the limit "
                       "is {least}.", process=process, thinnest=thinnest, error=error, least=least)
    if check.thin_holds is None:
        return message("{process}: cannot be told: the surface is open, and there may be walls thinner than the {thinnest} "
                       "that were found.", process=process, thinnest=thinnest)
    if check.thick_holds is None:
        return message("{process}: cannot be told: {share} of the surface lies over more than {most}, but a ray may run "
                       "along a wall there: look at the thickness map.",
                       process=process, share=Share(check.thick_share), most=most)
    if check.within_tolerance:
        return message("{process}: passes within tolerance: the thinnest wall is {thinnest}, give or take {error:.2g}, "
                       "the limit is {least}.", process=process, thinnest=thinnest, error=error, least=least)
    if check.tapered_share > STATED_FLOOR:
        return message("{process}: passes: the thinnest wall is {thinnest}, the limit {least}; towards their edges, "
                       "tapered walls are thinner on {share} of the surface.",
                       process=process, thinnest=thinnest, least=least, share=Share(check.tapered_share))
    if limits.min_mm is None:
        return message("{process}: passes: no wall is over {most}.", process=process, most=most)
    if limits.max_mm is not None:
        return message("{process}: passes: walls from {thinnest} on, the limits are {least} and {most}.",
                       process=process, thinnest=thinnest, least=least, most=most)
    return message("{process}: passes: the thinnest wall is {thinnest}, the limit {least}.",
                   process=process, thinnest=thinnest, least=least)


def _findings(check):
    """What is too thin, what is too thick, or both: Message."""
    least, most = Length(check.limits.min_mm), Length(check.limits.max_mm)
    if check.thin_holds is not False:
        return message("{share} of the surface lies over walls of more than {most}",
                       share=Share(check.thick_share), most=most)
    thin, place = _share_text(check.thin_share), _place(check)
    if check.thick_holds is False:
        return message("{thin} of the surface is under {least}, thinnest {place}, and {thick} over {most}",
                       thin=thin, least=least, place=place, thick=Share(check.thick_share), most=most)
    return message("{thin} of the surface is under {least}, thinnest {place}", thin=thin, least=least, place=place)


def _is_thick_enough(measured, least):
    """Whether no wall is thinner than the least, and whether the error bound spans it; see `wall_verdict`."""
    if least is None:
        return True, False
    if measured.thinnest is None:
        return None, False
    off = measured.thinnest - least
    rounding = TOLERANCES.threshold * least + TOLERANCES.rounding * measured.diagonal
    near = abs(off) <= max(measured.error, rounding)
    if near and measured.error > TOO_COARSE * least:
        return None, False
    if off < -max(rounding, min(measured.error, NEAR * least)):
        return False, near
    if measured.unmet > STATED_FLOOR:
        return None, False  # nothing is known about the wall there
    return True, near


def _is_thin_enough(measured, most):
    """Whether no place is thicker than the greatest wall, by the largest balls; see `wall_verdict`."""
    if most is None or not measured.share_over(most) > STATED_FLOOR:
        return True if most is None or measured.thinnest is not None else None
    if measured.thickest is None:
        outside = measured.volume_outside(most)
        if outside is None or THIN_UP_TO < outside < THICK_FROM:
            return None
        return outside <= THIN_UP_TO
    if measured.thickest > (1.0 + NEAR) * most and (
            measured.thickest > WHERE_WALLS_MEET * most
            or measured.share_between((1.0 + NEAR) * most, WHERE_WALLS_MEET * most) > THICK_SHARE):
        return False
    return None if measured.volume is None else True


def _thick_share(record, measured, most, holds):
    """Share of the surface that balls larger than the greatest wall reach; over thicker walls where balls tell nothing."""
    if measured.thickest is None or holds is None:
        return measured.share_over(most)
    if measured.thickest <= (1.0 + NEAR) * most:
        return 0.0
    known = [face for face in record.get("faces", ()) if face.get("ball_mm")]
    if known:
        over = sum(face["area_mm2"] for face in known if face["ball_mm"] > (1.0 + NEAR) * most)
        return max(over / sum(face["area_mm2"] for face in known), THICK_SHARE)
    local, middle = record["descriptors"]["local"], record["descriptors"]["box_mm"][1]
    cut = math.floor(most / middle * MIDDLE_BINS)
    return max(sum(area for bin_, area in zip(local["bins"], local["area"]) if bin_ > cut), THICK_SHARE)


def _faces_over(limited, most):
    """Names of the faces that balls larger than the greatest wall reach, the thickest first."""
    thick = [(-face["ball_mm"], face["face"]) for face in limited.get("faces", ()) if face.get("ball_mm")]
    return [face for ball, face in sorted(thick) if -ball > (1.0 + NEAR) * most]


def _thin_share(record, measured, limit):
    """Least and greatest share of the surface under a limit: what the distribution and what the faces say, together."""
    low, high = measured.share_under(limit)
    faces = record.get("faces", ())
    total = sum(face["area_mm2"] for face in faces)
    if not total:
        return low, high
    surely = possibly = 0.0
    for face in faces:
        own = face["area_mm2"] / total * (1.0 - face["unmeasured_share"])
        if face["min"] is None:
            possibly += own
        elif face["min"] < limit:
            surely += own * (1.0 if face["max"] < limit else 0.5 if face["median"] < limit else 0.0)
            possibly += own * (1.0 if face["median"] < limit else 0.5)
    # Only parallel walls are in the range of a face; all tapered ones may be elsewhere, or all of them thin.
    tapered = record["descriptors"]["shares"]["nonparallel"]
    low, high = max(low, surely - tapered), min(high, possibly + tapered)
    return min(low, high), high


def _place(check):
    """The thinnest wall, its error bound where that matters, its face where it is known, and how far it is from a sharp edge
    that it ends in: Message or Length."""
    thinnest = Length(check.thinnest_mm)
    if check.within_tolerance:
        thinnest = message("{thinnest}, give or take {error:.2g},", thinnest=thinnest, error=Length(check.error_mm))
    if check.thinnest_face:
        thinnest = message("{wall} on {face}", wall=thinnest, face=check.thinnest_face)
    if check.edge_mm is None:
        return thinnest
    return message("{wall}, {depth:.2g} beside a sharp edge", wall=thinnest, depth=Length(check.edge_mm))


def _share_text(bounds):
    low, high = bounds
    if high - low <= CLOSE:
        return Share(max(0.5 * (low + high), LEAST_SHARE))
    return message("{low} to {high}", low=Share(low), high=Share(high))
