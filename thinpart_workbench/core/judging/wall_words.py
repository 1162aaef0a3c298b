# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walls of a part in the words of a workshop: "2 mm sheet, 93 % of the surface", "2 ribs of 6 mm"."""

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

from ..descriptors.bins import BINS
from ..descriptors.equal_walls import SAME
from ..descriptors.region_kinds import BAR, BLOCK, CORE, FEWEST_TEETH, PLATE, RIB, RIB_VOLUME, TAPER, TOOTH, TUBE, is_thread
from ..descriptors.wall_kinds import EDGE
from ..figures import Length, Share
from ..message import Message, message
from ..record.face_names import face_number

MOST_OF_IT = 0.5
"""Share of the surface from which walls of one thickness are what the part is made of."""

SHEET_BELOW = 3.0
"""Thickness, mm, from which on a sheet is a plate (EN 10079: flat products)."""

ABOUT = 0.1
"""Share by which walls of one thickness may be thicker or thinner."""

OUTLYING = 0.05, 0.95
"""Shares of the thin walls below and above which they are not named."""

MOSTLY = 3.0
"""Median thickness of a taper, in limits, from which it is a body that ends in an edge rather than a thin wall."""

NOTED = 0.15
"""Thickness, in widths of a part, up to which a rib, a thread or the teeth of a solid body are named."""

_MOST_NAMED = 3


def walls_it_is_made_of(record, groups, limit):
    """What sheet, plate or wall makes up most of the surface of a part, in words: Message; None where none does.

    The share is that of the surface over parallel walls that are as thick, give or take a tenth.

    Parameters
    ----------
    record : PartRecord
    groups : list of RegionGroup
        Of its regions.
    limit : float, mm
        Walls below it are thin.
    """
    walls = [group for group in groups if group.kind in (PLATE, TUBE)]
    by_thickness = _Distribution(record["descriptors"])
    least = record["descriptors"]["thickness_mm"]["min"]
    if sum(group.area_share for group in walls) < MOST_OF_IT:
        return _between(by_thickness, limit, least)
    largest = max(walls, key=lambda group: group.area_share)
    alike = by_thickness.about(largest.median)
    if alike < MOST_OF_IT:
        return _between(by_thickness, limit, least)
    thickness, share = Length(largest.median), Share(alike)
    if largest.kind == TUBE:
        return message("{thickness} wall, {share} of the surface", thickness=thickness, share=share)
    if largest.median < SHEET_BELOW:
        return message("{thickness} sheet, {share} of the surface", thickness=thickness, share=share)
    return message("{thickness} plate, {share} of the surface", thickness=thickness, share=share)


def _between(by_thickness, limit, least):
    """Walls of several thicknesses that most of the surface lies over, none thinner than the thinnest: Message or None."""
    low, high, share = by_thickness.most(limit)
    low = max(low, least or 0.0)  # a bin begins before the walls in it
    return message("Walls {low} to {high} thick, {share} of the surface", low=Length(low), high=Length(high),
                   share=Share(share)) if share >= MOST_OF_IT else None


class _Distribution:
    """Shares of the surface over parallel walls, by thickness; and over tapered ones."""

    def __init__(self, descriptors):
        self._step = descriptors["diagonal_mm"] / BINS
        self._bins = list(zip(descriptors["distribution"]["bins"], descriptors["distribution"]["area"]))
        self._tapered = list(zip(descriptors["nonparallel"]["bins"], descriptors["nonparallel"]["area"]))

    def about(self, thickness):
        """Share over walls of about a thickness: float."""
        low, high = (1.0 - ABOUT) * thickness / self._step, (1.0 + ABOUT) * thickness / self._step
        return min(1.0, sum(area for number, area in self._bins if math.floor(low) <= number < math.ceil(high)))

    def most(self, limit):
        """Thicknesses, mm, between which nine tenths of the walls below a limit are, tapered ones too, and their share.

        Returns a tuple of three float.
        """
        thin = sorted((number, area) for number, area in (*self._bins, *self._tapered) if number * self._step < limit)
        total = sum(area for _, area in thin)
        low, high = (self._below(thin, share * total) for share in OUTLYING)
        return low * self._step, (high + 1) * self._step, (OUTLYING[1] - OUTLYING[0]) * total

    @staticmethod
    def _below(thin, area):
        for number, own in thin:
            area -= own
            if area <= 0.0:
                return number
        return thin[-1][0] if thin else 0


class ThinFeatures(NamedTuple):
    """Thin walls, ribs, teeth and threads of a part.

    Attributes
    ----------
    words : Message
        The largest of them.
    has_core : bool
        Whether most of the part is a bulky body.
    are_teeth : bool
        Whether all of them are teeth or threads, which an analysis may leave out.
    """

    words: Message
    has_core: bool
    are_teeth: bool


def thin_features(groups, limit, width, run_out=frozenset()):
    """The thin regions of a part: ThinFeatures; None where it has none.

    Parameters
    ----------
    groups : list of RegionGroup
    limit : float, mm
        Walls below it are thin.
    width : float, mm
        Middle side of the box of the part.
    run_out : set of int, optional
        Numbers of the faces that meet in the sharp edge where the part is thinnest: see `run_out_of`.
    """
    thin = [group for group in groups if _is_thin(group, limit)] or [
        group for group in groups if group.kind not in (BLOCK, TUBE) and group.least < limit and group.count > 1]
    thin.sort(key=lambda group: -group.area_share)
    if not thin:
        return None
    bulky = [group.volume_share or 0.0 for group in groups if group.kind in (BLOCK, BAR) and not _is_thin(group, limit)]
    has_core = sum(bulky) >= CORE
    features = _features(thin, width, run_out)
    named = features[:_MOST_NAMED]
    thinnest = min(features, key=lambda feature: feature.least)
    if thinnest not in named:
        named = [*named[:-1], thinnest]
    words = _listed([_feature(feature, limit) for feature in named],
                    sum(feature.count for feature in features) - sum(feature.count for feature in named))
    return ThinFeatures(words, has_core, all(_is_toothing(feature) for feature in features))


def run_out_of(record):
    """The faces that meet in the sharp edge where a part is thinnest: set of int, numbers from 0; empty where it is none."""
    place = record.get("thinnest")
    if place is None or place["kind"] != EDGE:
        return set()
    return {face_number({"face": face}) for face in (place["face"], place["witness"]["opposite_face"])}


def features_of_a_solid(groups, limit, width, run_out=frozenset()):
    """What a solid part has of thin regions, or else of ribs, threads and teeth on its core that are thin beside that.

    Parameters and result are those of `thin_features`.
    """
    found = thin_features(groups, limit, width, run_out)
    if found is not None:
        return found
    small = [group for group in groups if group.kind == TOOTH or not _is_thin(group, NOTED * width)
             or (group.volume_share or 0.0) <= RIB_VOLUME * group.count]
    noted = thin_features(small, NOTED * width, width, run_out)
    return noted if noted is not None and noted.has_core else None


@dataclass(frozen=True)
class _Feature:
    kind: str
    count: int
    least: float
    thickness: float
    is_thread: bool
    width: float
    runs_out: bool


def _features(groups, width, run_out):
    """Groups of regions, those of one kind and thickness as one: list of _Feature."""
    found: list[_Feature] = []
    for group in groups:
        kind = group.word if group.word in (RIB, TOOTH) else {TUBE: PLATE, TAPER: TOOTH}.get(group.kind, group.kind)
        goes_round = is_thread(group.kind, group.length, group.median, width)
        feature = _Feature(kind, group.count, group.least, group.median, goes_round, width,
                           not run_out.isdisjoint(group.faces))
        same = next((number for number, other in enumerate(found) if _are_one(feature, other)), None)
        if same is None:
            found.append(feature)
        else:
            other = found[same]
            found[same] = replace(other, count=other.count + feature.count, least=min(other.least, feature.least),
                                  runs_out=other.runs_out or feature.runs_out)
    return found


def _are_one(feature, other):
    alike = abs(feature.thickness - other.thickness) <= (ABOUT if feature.kind == TOOTH else SAME) * other.thickness
    return alike and (feature.kind, feature.is_thread) == (other.kind, other.is_thread)


def _is_toothing(feature):
    return feature.is_thread or feature.kind == TOOTH and feature.count >= FEWEST_TEETH


def _listed(words, others):
    if others:
        return message("{one}, {two}, {three} and {count} more", one=words[0], two=words[1], three=words[2], count=others)
    if len(words) == 3:
        return message("{one}, {two} and {three}", one=words[0], two=words[1], three=words[2])
    if len(words) == 2:
        return message("{one} and {two}", one=words[0], two=words[1])
    return words[0]


def _is_thin(group, limit):
    if group.kind in (TAPER, TOOTH):
        return group.least < limit and group.median < MOSTLY * limit
    return group.median < limit


def _feature(feature, limit):
    kind, count = feature.kind, feature.count
    least, thickness, share = Length(feature.least), Length(feature.thickness), Share(feature.thickness / feature.width)
    if feature.is_thread and feature.runs_out:
        return message("thread {least} to {thickness} thick, with a run-out to a sharp edge", least=least,
                       thickness=thickness)
    if feature.is_thread:
        return message("thread {least} to {thickness} thick", least=least, thickness=thickness)
    is_as_thick = f"{least}" == f"{thickness}"
    if kind == TOOTH and count >= FEWEST_TEETH:
        return message("{count} teeth {least} to {thickness} thick", count=count, least=least, thickness=thickness)
    if kind == TOOTH and count > 1 and not is_as_thick:
        return message("{count} tapers {least} to {thickness} thick", count=count, least=least, thickness=thickness)
    if kind == TOOTH and not is_as_thick:
        return message("a taper {least} to {thickness} thick", least=least, thickness=thickness)
    if thickness.value >= limit and count > 1:  # thin where they are thinnest only
        return message("{count} walls {least} to {thickness} thick", count=count, least=least, thickness=thickness)
    if kind == RIB and count > 1:
        return message("{count} ribs of {thickness} ({share} of the width)", count=count, thickness=thickness, share=share)
    if kind == RIB:
        return message("a rib of {thickness} ({share} of the width)", thickness=thickness, share=share)
    if kind == BAR and count > 1:
        return message("{count} bars of {thickness} ({share} of the width)", count=count, thickness=thickness, share=share)
    if kind == BAR:
        return message("a bar of {thickness} ({share} of the width)", thickness=thickness, share=share)
    if kind == BLOCK and count > 1:
        return message("{count} studs of {thickness} ({share} of the width)", count=count, thickness=thickness, share=share)
    if kind == BLOCK:
        return message("a stud of {thickness} ({share} of the width)", thickness=thickness, share=share)
    if count > 1:
        return message("{count} walls of {thickness} ({share} of the width)", count=count, thickness=thickness, share=share)
    return message("a wall of {thickness} ({share} of the width)", thickness=thickness, share=share)
