# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which idealisation suits a part: shells or solids, with the figures that say so."""

from dataclasses import asdict, dataclass
from typing import Optional

import numpy as np

from ..descriptors.region_kinds import PLATE, TUBE
from .shell_settings import SHARE_OF_DIAGONAL

SHELL_VOLUME = 0.85
"""Share of the volume in plates and tubes from which on a part is a shell."""

MIXED_VOLUME = 0.4
"""The same from which on a part of it may be one."""

SHELL_WIDTH = 5.0
"""Width by thickness of a wall from which on shells are meant: below, the shear through the wall counts."""

SHELL_ELEMENT = 2.0
"""Element of a shell by the thickness of its wall, at least."""

PER_SQUARE, PER_FACE = 2.9, 4.1
"""Triangles by the squared element size, and for each face of the part, along whose edges they are smaller: by the shells of
121 real parts, of which four in five have 0.5 to 3.4 times as many as estimated."""


@dataclass(frozen=True)
class Idealisation:
    """Shell or solid.

    Attributes
    ----------
    advice : str
        ``shell``, ``mixed`` or ``solid``.
    plate_volume_share : float or None
        Share of the part's volume in walls that are plates or tubes.
    plate_area_share : float
        Share of the surface over such walls.
    width_to_thickness : float or None
        Median of those walls, by area.
    solid_elements, shell_elements : int
        Estimated: of the proposed solid mesh, and of a shell of all walls.
    no_shell : str
        Why a shell cannot be made, although the walls ask for one; else empty.
    """

    advice: str
    plate_volume_share: Optional[float]
    plate_area_share: float
    width_to_thickness: Optional[float]
    solid_elements: int
    shell_elements: int
    no_shell: str = ""


def idealisation(measurement, solid_elements, shell_size, no_shell=""):
    """Say whether a part is better meshed as shells or as a solid: Idealisation.

    Parameters
    ----------
    measurement : Measurement
    solid_elements : int
        Of the proposed solid mesh.
    shell_size : float, mm
        Greatest size of the elements of a shell.
    no_shell : str
        Why a shell cannot be made; empty where it can, or nothing is known.
    """
    walls = [region for region in measurement.regions.listed if region.kind in (PLATE, TUBE)]
    known = [region.volume_share for region in walls if region.volume_share is not None]
    volume_share = min(1.0, sum(known)) if known or measurement.volume_mm3 else None
    ratio, elements = None, 0.0
    if walls:
        ratios = np.array([min(region.width, region.length) / region.median for region in walls])
        areas = np.array([region.area for region in walls])
        order = np.argsort(ratios, kind="stable")
        ratio = float(ratios[order][np.searchsorted(np.cumsum(areas[order]), 0.5 * areas.sum())])
        for region in walls:
            size = max(SHELL_ELEMENT * region.median, min(shell_size, 0.5 * min(region.width, region.length)))
            elements += PER_SQUARE * 0.5 * region.area / size ** 2
        if measurement.field.mesh.has_faces:
            elements += PER_FACE * len(np.unique(measurement.field.mesh.face_of_triangle))
    advice = "solid"
    if volume_share is not None and ratio is not None and ratio >= SHELL_WIDTH:
        advice = "shell" if volume_share >= SHELL_VOLUME else "mixed" if volume_share >= MIXED_VOLUME else "solid"
    why, advice = (no_shell, "solid") if no_shell and advice != "solid" else ("", advice)
    return Idealisation(advice, volume_share, measurement.regions.plate_share, ratio, int(solid_elements),
                        max(1, round(elements)) if walls else 0, why)


def idealisation_values(measurement, solid_elements, no_shell):
    """The `Idealisation` of a part, with shells of the default size, as plain values, dict; numbers with six digits."""
    size = SHARE_OF_DIAGONAL * measurement.descriptors.box.diagonal
    found = idealisation(measurement, solid_elements, size, no_shell)
    return {name: float(f"{value:.6g}") if isinstance(value, float) else value for name, value in asdict(found).items()}
