# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wall regions of a part record as people read them: equal ones together."""

from dataclasses import dataclass
from typing import Optional

from ..descriptors.equal_walls import WallSize, equal_groups
from ..descriptors.region_kinds import TOOTH
from ..descriptors.ridges import has_core, ridge_ratio, wall_row
from .face_names import face_number
from .region_notes import notes_of_regions


@dataclass(frozen=True)
class RegionGroup:
    """Equal regions, such as the fins of a heat sink.

    Attributes
    ----------
    kind : str
    count : int
    least : float, mm
        Of all of them.
    median, length, width : float, mm
        Of the one that is neither the longest nor the shortest.
    volume_share : float or None
        Of all together, at most 1.
    faces : tuple of int
        Of all together, from 0.
    area_share : float
        Of the surface of the part, of all together.
    walls : tuple of (float, list)
        Where each of them is thinnest, the thinnest first: thickness, mm, and both ends of the line through the wall, in the
        coordinates of the document. Records of earlier versions have none.
    area : float, mm2
        Of both sides, of all together.
    regions : tuple of dict
        Their entries in the record.
    excluded : str
        Why people leave them out; empty where they do not.
    mesh_size : float or None, mm
        Element size that is wanted there.
    word : str
        The kind as people call it: see `called`; or `THREAD`, or `RIB`.
    """

    kind: str
    count: int
    least: float
    median: float
    length: float
    width: float
    volume_share: Optional[float]
    faces: tuple
    area_share: float
    walls: tuple
    area: float = 0.0
    regions: tuple = ()
    excluded: str = ""
    mesh_size: Optional[float] = None
    word: str = ""


def region_groups(record, notes=None):
    """Group the regions of a part record; those of which people say something else are apart.

    Returns a list of RegionGroup: by their least thickness, the thinnest first; empty for a record of a version that did not
    find regions.

    Parameters
    ----------
    record : PartRecord
    notes : list of dict, optional
        ``region_notes`` of the part; by default those in the record.
    """
    listed = record.get("regions", {}).get("listed", [])
    found = notes_of_regions(listed, record.get("region_notes", ()) if notes is None else notes)
    said = [((note or {}).get("excluded", ""), (note or {}).get("mesh_size_mm")) for note in found]
    sizes = _sizes(record)
    has_solid_core = has_core(sizes, [region["volume_share"] for region in listed])
    # Those of a record are in the order of their medians: a taper that begins thinner than a plate came after it.
    groups = (_group(record, numbers, sizes, has_solid_core, *said[numbers[0]])
              for numbers in _equal_groups(record, sizes, said))
    return sorted(groups, key=lambda group: (group.least, -group.area))


def equal_regions(record):
    """The listed regions of a part record, equal ones together, whatever people say: list of list of int, numbers from 0."""
    sizes = _sizes(record)
    return _equal_groups(record, sizes, [None] * len(sizes))


def recorded_ridge_ratio(record):
    """The quantity ``ridge_ratio`` of a part record, from its listed regions: float; None where it has no such list."""
    if "regions" not in record:
        return None
    listed = record["regions"]["listed"]
    return ridge_ratio(_sizes(record), [region["volume_share"] for region in listed], [region["faces"] for region in listed],
                       record["descriptors"]["box_mm"][1], record["descriptors"]["area_mm2"])


def _equal_groups(record, sizes, said):
    listed = record.get("regions", {}).get("listed", ())
    return equal_groups(sizes, said, [region["faces"] for region in listed], record["descriptors"]["box_mm"][1])


def _sizes(record):
    face_areas = {face["face"]: face["area_mm2"] for face in record.get("faces", ())}
    return [_size(region, face_areas) for region in record.get("regions", {}).get("listed", ())]


def features_of(group, record, features):
    """The features that made the faces of a group, the one with most of their area first: list of str.

    Parameters
    ----------
    group : RegionGroup
    record : PartRecord
    features : list of str
        The feature that made each face, by face number; empty where that is not known.
    """
    areas = {face_number(face): face["area_mm2"] for face in record["faces"]}
    found: dict = {}
    for face in group.faces:
        if face < len(features) and features[face]:
            found[features[face]] = found.get(features[face], 0.0) + areas.get(face, 0.0)
    return sorted(found, key=lambda feature: -found[feature])


def _size(region, face_areas):
    return WallSize(region["kind"], region["min"], region["median"], region["length_mm"], region["width_mm"],
                    region["area_mm2"], tuple(sorted(face_areas[face] for face in region["faces"] if face in face_areas)))


def _group(record, numbers, sizes, has_solid_core, excluded, mesh_size):
    regions = [record["regions"]["listed"][number] for number in numbers]
    shares = [region["volume_share"] for region in regions]
    own = [sizes[number] for number in numbers]
    walls = wall_row(own, shares, [region["faces"] for region in regions], record["descriptors"]["box_mm"][1],
                     has_solid_core)
    typical = regions[walls.typical]
    return RegionGroup(
        TOOTH if walls.is_one_thread else typical["kind"], 1 if walls.is_one_thread else len(regions),
        min(region["min"] for region in regions), typical["median"], walls.length, typical["width_mm"],
        None if None in shares else min(1.0, sum(shares)),
        tuple(sorted({face_number({"face": face}) for region in regions for face in region["faces"]})),
        min(1.0, sum(region["area_mm2"] for region in regions) / record["descriptors"]["area_mm2"]),
        tuple(sorted((region["min"], region["witness"]["points"]) for region in regions if region.get("witness"))),
        sum(region["area_mm2"] for region in regions), tuple(regions), excluded, mesh_size,
        walls.word)
