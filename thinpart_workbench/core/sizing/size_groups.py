# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element sizes as people read them: equal wall regions, such as the teeth of a gear, have one size and one row."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..descriptors.equal_walls import WallSize, equal_groups
from ..descriptors.ridges import has_core, wall_row
from .sizing_settings import layers_of


@dataclass(frozen=True)
class SizeGroup:
    """Equal wall regions and the size of the elements there.

    Attributes
    ----------
    numbers : tuple of int
        Of the regions among those that are listed, from 0.
    kind, word : str
        One of `REGION_KINDS`, and what people call it; see `ridges.wall_row`.
    count : int
        How many there are; pieces of a thread are one.
    median, length, width : float, mm
        Of the one that is neither the longest nor the shortest; the length of a thread is that of all.
    least : float, mm
        Of all of them.
    area : float, mm2
        Of all together.
    faces : tuple of int
        Of all together, from 0, ascending.
    size : float or None, mm
        Of the elements, the median over all of them; None where nothing there asks for a size.
    layers : float or None
        Elements through the median thickness.
    elements : int or None
        Estimated, of all together.
    """

    numbers: tuple
    kind: str
    word: str
    count: int
    median: float
    length: float
    width: float
    least: float
    area: float
    faces: tuple
    size: Optional[float] = None
    layers: Optional[float] = None
    elements: Optional[int] = None


def size_groups(measurement, proposal):
    """All listed wall regions of a part, equal ones together, with the sizes of a proposal: list of SizeGroup.

    As in a table of walls, those for which people want another size are apart. They are in the order of the first of each.

    Parameters
    ----------
    measurement : Measurement
    proposal : SizeProposal
    """
    listed, mesh = measurement.regions.listed, measurement.field.mesh
    face_areas = np.bincount(mesh.face_of_triangle, mesh.areas)
    wanted = proposal.region_sizes or {}
    # What nobody wants is told from a wall that is switched off, which is None.
    said = [(number in wanted, wanted.get(number)) for number in range(len(listed))]
    sizes, faces = [WallSize.of_region(region, face_areas) for region in listed], [region.faces for region in listed]
    shares, width = [region.volume_share for region in listed], measurement.box_mm[1]
    on_core = has_core(sizes, shares)
    walls = {tuple(numbers): wall_row([sizes[number] for number in numbers], [shares[number] for number in numbers],
                                      [faces[number] for number in numbers], width, on_core)
             for numbers in equal_groups(sizes, said, faces, width)}
    sources, proposed = proposal.sources.below(proposal.global_size), {each.number: each for each in proposal.regions}
    return [_group(numbers, equal, listed, sources, [proposed[number] for number in numbers if number in proposed],
                   proposal.settings.is_by_error) for numbers, equal in walls.items()]


def median_size(sources, numbers):
    """The size that one row says for wall regions, by their numbers from 0: float, mm; None where none asks for any."""
    own = sources.of_regions(numbers).sizes
    return float(np.median(own)) if len(own) else None


def _group(numbers, equal, listed, sources, proposed, is_by_error):
    regions = [listed[number] for number in numbers]
    typical = regions[equal.typical]
    size = layers = elements = None
    if proposed:
        size = median_size(sources, numbers)
        layers = layers_of(typical.median / size)
        layers = max(1.0, layers) if is_by_error else layers
        elements = sum(each.elements for each in proposed)
    return SizeGroup(numbers, typical.kind, equal.word, 1 if equal.is_one_thread else len(numbers),
                     float(typical.median), float(equal.length), float(typical.width),
                     float(min(region.least for region in regions)), float(sum(region.area for region in regions)),
                     tuple(sorted({int(face) for region in regions for face in region.faces})), size, layers, elements)
