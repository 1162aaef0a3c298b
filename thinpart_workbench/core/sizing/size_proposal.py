# SPDX-License-Identifier: LGPL-2.1-or-later
"""A proposal of element sizes for a part: sizes by region, how many elements they give, and what a budget costs."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Optional

import numpy as np

from .element_estimate import FINER, elements_by_sample, nodes_of, of_few
from .error_law import error_at
from .inner_points import InnerPoints, inner_points
from .size_field import SizeField
from .size_sources import NO_REGION, SizeSources, regions_of, size_sources
from .sizing_settings import SizingSettings, layers_of

CLOSE = 0.02
"""Share of the budget that may be left."""

THINNEST = 0.05
"""Share of the thin area whose walls, the thinnest, get fewer layers first where there are to be fewer elements."""

WORTH = 0.5
"""Share of the elements that must be left for that: a knife's edge of some walls may take most of them."""

_MOST_STEPS = 14


@dataclass(frozen=True)
class RegionSize:
    """What is proposed for one wall region.

    Attributes
    ----------
    number : int
        Of the region among those that are listed, from 0.
    region : WallRegion
    size : float, mm
        Of the elements, the median over the region; see `size_groups` for that of equal regions.
    layers : float
        Elements through its median thickness.
    elements : int
        Estimated.
    """

    number: int
    region: object
    size: float
    layers: float
    elements: int


@dataclass(frozen=True)
class SizeProposal:
    """Element sizes for a part.

    Attributes
    ----------
    settings : SizingSettings
    thin_limit : float, mm
        Walls that are thinner have `layers`.
    global_size : float, mm
        Greatest size.
    layers : float
        Elements through a thin wall: fewer than wanted where the budget does not allow them. 1 for an error aimed at, 0
        where no wall has a size.
    sources : SizeSources
        Without any, all of the part has the global size, as where layers decide and it has no thin wall.
    elements, nodes : int
        Estimated.
    uniform_elements : int
        Estimated of a mesh that has the least size everywhere.
    regions : tuple of RegionSize
        Those with thin walls, the thinnest first.
    inner : InnerPoints
        Of the part.
    unbounded : SizeProposal or None
        That without the budget, where it is exceeded.
    layered_from : float, mm
        Thinner walls have fewer layers than `layers`; 0 where all have these.
    region_sizes : dict or None
        Sizes that people wanted, see `propose_sizes`.
    only_chosen : bool
        Whether no walls have sizes but those of `region_sizes`.
    left_out : int
        Thin wall regions that have no size of their own for that reason.
    error : float or None
        Of an analysis, expected: that aimed at, more where the budget does not allow it; None where layers decide.
    """

    settings: SizingSettings
    thin_limit: float
    global_size: float
    layers: float
    sources: SizeSources
    elements: int
    nodes: int
    uniform_elements: int
    regions: tuple
    inner: InnerPoints
    unbounded: Optional["SizeProposal"] = None
    layered_from: float = 0.0
    region_sizes: Optional[dict] = None
    only_chosen: bool = False
    left_out: int = 0
    error: Optional[float] = None

    @cached_property
    def field(self):
        """SizeField"""
        return SizeField(self.sources, self.global_size, self.settings.growth)

    @property
    def least_size(self):
        """float, mm"""
        return self.field.least

    @property
    def is_uniform(self):
        """bool: whether all of the part has the global size, without a field of sizes."""
        return self.sources.count == 0


def propose_sizes(measurement, thin_limit, settings, region_sizes=None, has_details=None, only_chosen=False):
    """Propose element sizes for a measured part: SizeProposal.

    For a budget, the thinnest walls get no smaller elements than the others, where they take most of the elements: see
    `without_thinnest`. If that is not enough, all sizes are multiplied alike, up to the global size, until the estimate is
    within the budget: so walls keep equal numbers of layers, only fewer, and the error that is expected gets greater.

    Parameters
    ----------
    measurement : Measurement
    thin_limit : float, mm
        Walls that are thinner are meshed with layers; see `Classification.thin_limit_x`.
    settings : SizingSettings
    region_sizes : dict, optional
        Sizes that people want on wall regions instead of the proposed ones: see `SizeSources.with_region_sizes`.
    has_details : bool or None
        Whether narrow faces and short edges ask for sizes too; None for where layers decide.
    only_chosen : bool
        Whether nothing asks for sizes but the regions to which `region_sizes` gives one: for parts that are called normal,
        which mesh well at one size, whatever small walls they have. For an error aimed at, all of every part has sizes.
    """
    global_size = settings.global_size(measurement.descriptors.box.diagonal)
    only_chosen = only_chosen and not settings.is_by_error
    if has_details is None:
        has_details = not settings.is_by_error
    asking = size_sources(measurement, thin_limit, settings, has_details and not only_chosen)
    wanted = _bounded(asking, global_size, settings)
    left_out = 0
    if only_chosen:
        chosen = {number for number, size in (region_sizes or {}).items() if size is not None}
        left_out = len(set(wanted.region.tolist()) - chosen - {NO_REGION})
        wanted = wanted.of_regions(chosen)
    if region_sizes:
        wanted = _bounded(wanted.with_region_sizes(region_sizes), global_size, settings)
    inner = inner_points(measurement)

    def proposed(sources, layers, most=global_size):
        return replace(_proposed(measurement, thin_limit, settings, most, sources, layers, inner), region_sizes=region_sizes,
                       only_chosen=only_chosen, left_out=left_out)

    proposal = proposed(wanted, settings.wanted_layers)
    if settings.budget is None or proposal.elements <= settings.budget:
        return proposal
    coarser = without_thinnest(measurement, proposal)
    if coarser is not None and coarser.elements <= settings.budget:
        found = _least_raised(proposed, settings, wanted, coarser)
    else:
        found = _within_budget(proposed, settings, global_size, wanted if coarser is None else coarser.sources)
        found = replace(found, layered_from=0.0 if coarser is None else coarser.layered_from)
    return replace(found, unbounded=proposal)


def without_thinnest(measurement, proposal):
    """A proposal whose elements are no smaller than all but the thinnest walls want, `THINNEST` of the thin area.

    Returns a SizeProposal or None: None where that saves too little, see `WORTH`, and for an error aimed at, where the
    thinnest places ask for no more than others anyway.
    """
    if proposal.settings.is_by_error:
        return None
    field = measurement.field
    thin = np.flatnonzero((field.area > 0.0) & field.parallel & (field.distance < proposal.thin_limit))
    if not len(thin):
        return None
    order = thin[np.argsort(field.distance[thin])]
    reached = np.cumsum(field.area[order])
    thickness = float(field.distance[order][np.searchsorted(reached, THINNEST * reached[-1])])
    least = thickness / proposal.settings.divisions
    if least <= proposal.least_size:
        return None
    found = with_sources(measurement, proposal, proposal.sources.scaled(1.0, least).below(proposal.global_size))
    return replace(found, layered_from=thickness) if found.elements <= WORTH * proposal.elements else None


def with_sources(measurement, proposal, sources):
    """A proposal with other sources, and its elements counted anew: SizeProposal."""
    found = _proposed(measurement, proposal.thin_limit, proposal.settings, proposal.global_size, sources, proposal.layers,
                      proposal.inner)
    return replace(found, unbounded=proposal.unbounded, region_sizes=proposal.region_sizes, only_chosen=proposal.only_chosen,
                   left_out=proposal.left_out, layered_from=proposal.layered_from, error=proposal.error)


def propose_everywhere(measurement, thin_limit, settings):
    """Propose sizes for a part that is not meshed at one size, or not with those for an error aimed at.

    Returns a SizeProposal: no element is larger than the part is thick there, nor than the curvature, narrow faces and short
    edges allow. It has no layers, and no regions.

    Parameters
    ----------
    measurement : Measurement
    thin_limit : float, mm
    settings : SizingSettings
    """
    everywhere = propose_sizes(measurement, np.inf, replace(settings, layers=1.0))
    return replace(everywhere, settings=settings, thin_limit=thin_limit, layers=0.0, regions=(), error=None)


def _least_raised(proposed, settings, wanted, coarser):
    """The proposal with the smallest least size that is within the budget; one such is known."""
    low, high, best = np.log(wanted.sizes.min()), np.log(coarser.least_size), coarser
    for _ in range(_MOST_STEPS):
        least = float(np.exp(0.5 * (low + high)))
        found = proposed(wanted.scaled(1.0, least), settings.wanted_layers)
        if found.elements > settings.budget:
            low = np.log(least)
            continue
        best, high = replace(found, layered_from=least * settings.divisions), np.log(least)
        if found.elements >= (1.0 - CLOSE) * settings.budget:
            break
    return best


def _within_budget(proposed, settings, global_size, wanted):
    low, high = 0.0, np.log(global_size / wanted.sizes.min()) if wanted.count else 0.0
    best = None
    for _ in range(_MOST_STEPS):
        # The number falls with about the square of the size, so halving the logarithm is quick enough.
        factor = float(np.exp(0.5 * (low + high)))
        found = proposed(_bounded(wanted.scaled(factor), global_size, settings), layers_of(settings.divisions / factor))
        if settings.is_by_error:
            found = replace(found, error=error_at(settings.error, factor))
        if found.elements > settings.budget:
            low = np.log(factor)
            continue
        best, high = found, np.log(factor)
        if found.elements >= (1.0 - CLOSE) * settings.budget:
            break
    if best is not None:
        return best
    # Not even the global size is within it: that has to grow.
    none = _bounded(wanted.scaled(np.inf), global_size, settings)
    found, size = proposed(none, 0.0), global_size
    if found.elements > settings.budget:
        size *= (found.elements / settings.budget) ** 0.5
        found = proposed(_bounded(wanted.scaled(np.inf), size, settings), 0.0, size)
    if settings.is_by_error:
        found = replace(found, error=error_at(settings.error, size / (wanted.sizes.min() if wanted.count else global_size)))
    return found


def _bounded(sources, size, settings):
    """Sources that count beside a greatest size.

    For an error aimed at, all of them: where there are none, Gmsh spreads the sizes at small holes into the volume.
    """
    return sources.at_most(size) if settings.is_by_error else sources.below(size)


def _proposed(measurement, thin_limit, settings, global_size, sources, layers, inner):
    size_field, count = SizeField(sources, global_size, settings.growth), len(measurement.field.area)
    if settings.is_by_error:
        layers = settings.wanted_layers
    by_sample = elements_by_sample(inner, size_field, count)
    uniform = elements_by_sample(inner, SizeField(sources.below(0.0), size_field.least, settings.growth), count)
    found, everywhere = float(by_sample.sum()), float(uniform.sum())
    if settings.is_by_error:
        faces = int(measurement.field.mesh.face_of_triangle.max()) + 1
        found, everywhere, by_sample = of_few(found, faces), of_few(everywhere, faces), FINER * by_sample
    elements = max(1, round(found))
    regions = tuple(_region_sizes(measurement, sources.below(global_size), by_sample, settings.is_by_error))
    return SizeProposal(settings, thin_limit, global_size, layers if sources.count else 0.0, sources, elements,
                        nodes_of(elements, settings.order), max(1, round(everywhere)), regions, inner,
                        error=settings.error if settings.is_by_error else None)


def _region_sizes(measurement, sources, by_sample, is_by_error):
    field = measurement.field
    region_of_sample = regions_of(measurement.regions.listed, field.face, field.distance)
    for number, region in enumerate(measurement.regions.listed):
        sizes = sources.sizes[sources.region == number]
        if len(sizes):
            size = float(np.median(sizes))
            elements = max(1, round(float(by_sample[region_of_sample == number].sum())))
            layers = layers_of(region.median / size)
            yield RegionSize(number, region, size, max(1.0, layers) if is_by_error else layers, elements)
