"""From a surface mesh to everything that is measured on it."""

from dataclasses import dataclass
from functools import cached_property
from typing import Optional

import numpy as np

from .bounds import minimal_box, principal_box
from .descriptors import STATED_ANGLES, STATED_FLOOR, Descriptors
from .distribution import distribution
from .dominant_directions import dominant_directions
from .inward_rays import InwardRays
from .mass_properties import area, volume
from .nonparallel import nonparallel_minimum
from .pair_rule import measure_pairs
from .progress import portion, tell
from .sampling import centroid_samples, surface_samples
from .thickness import ThicknessField, measure_rays

BOX_DONE, TREE_DONE, RAYS_DONE = 0.1, 0.15, 0.85
"""Progress when the box is found, the tree is built, and all samples have been cast; the search for
slanted walls is the rest."""

FLAT_DIRECTIONS = 16
"""Sides of a part that its box may lie flush with."""


@dataclass(frozen=True)
class Measurement:
    """What was measured on one part.

    Attributes
    ----------
    descriptors : Descriptors
    field : ThicknessField
        The thickness under every sample, for colours and per-face summaries.
    rays : InwardRays or None
        By which it was measured; None for pairs.
    """

    descriptors: Descriptors
    field: ThicknessField
    rays: Optional[InwardRays] = None

    @property
    def thinnest(self):
        """float or None, mm: the least distance between parallel walls."""
        return self.wall_range[0]

    @cached_property
    def wall_range(self):
        """Least, median by area, and greatest distance between parallel walls, mm, or None."""
        walls = self.field.distance[self.field.parallel]
        if not len(walls):
            return None, None, None
        order = np.argsort(walls, kind="stable")
        cumulative = np.cumsum(self.field.area[self.field.parallel][order])
        middle = order[np.searchsorted(cumulative, 0.5 * cumulative[-1])]
        return float(walls[order[0]]), float(walls[middle]), float(walls[order[-1]])


def measure(mesh, settings, report=None):
    """Measure a part.

    Parameters
    ----------
    mesh : SurfaceMesh
    settings : AnalysisSettings
    report : callable, optional
        Called with the fraction done; may raise to stop.

    Returns
    -------
    Measurement

    Raises
    ------
    MeshError
        kind ``zero_volume`` for a closed surface that encloses nothing.
    """
    tell(report, 0.0)
    enclosed = volume(mesh)
    box = _box(mesh, settings.box, portion(report, 0.0, BOX_DONE))
    rays = None
    if settings.measure == "pairs":
        pairs_report = portion(report, BOX_DONE, 1.0)
        field, shares = measure_pairs(mesh, centroid_samples(mesh), box.diagonal, pairs_report)
        least = shares.nonparallel_minimum(STATED_FLOOR, *STATED_ANGLES)
    else:
        tell(report, BOX_DONE)
        rays = InwardRays(mesh)
        tell(report, TREE_DONE)
        samples = surface_samples(mesh, settings.minimum_samples)
        field = measure_rays(mesh, samples, portion(report, TREE_DONE, RAYS_DONE), rays)
        shares = distribution(field, box.diagonal)
        slanted_report = portion(report, RAYS_DONE, 1.0)
        least = nonparallel_minimum(mesh, rays, field, box.diagonal, slanted_report)
    tell(report, 1.0)
    return Measurement(Descriptors(enclosed, area(mesh), box, shares, least), field, rays)


def _box(mesh, kind, report=None):
    if kind == "principal":
        return principal_box(mesh.vertices)
    flat = dominant_directions(mesh.normals, mesh.areas, FLAT_DIRECTIONS)
    return minimal_box(mesh.vertices, flat, report)
