# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is tried, one after the other, until Gmsh meshes a part."""

import os
import re
from dataclasses import dataclass, field, replace

import numpy as np

from ...core.message import message
from ...core.sizing.size_proposal import (
    SizeProposal,
    propose_everywhere,
    propose_sizes,
    with_sources,
    without_thinnest,
)
from ...core.sizing.size_sources import SPACING, places
from .gmsh_program import CRASHED, INCOMPLETE, MEMORY, TIMEOUT

FINER = 0.5
"""Of the size there, at places at which Gmsh failed."""

ANOTHER = 0.8
"""Of all sizes, where Gmsh does not say where it failed: a surface that cannot be meshed with some sizes, can be with
others."""

ALIKE = 4.0
"""Of the faces that Gmsh names beside a place, what has up to so many times the size of the place gets finer too: the
facets of two sides that cross in one place do so all along."""

LOST = 20_000
"""Estimated elements up to which Gmsh takes seconds: where so few take too long, it is lost between sides that cross."""

FEWER = 0.2
"""Share of the elements that is tried where Gmsh took too long."""

DELAUNAY = {"Mesh.Algorithm": 5}
"""Surfaces by the Delaunay method, which is less neat and fails less."""

QUICK = {"Mesh.Algorithm3D": 10}
"""Volumes by the HXT method: a seventh of the time of Gmsh's own for a million elements, whose mean is slightly worse."""

MANY = 400_000
"""Estimated elements from which on that is tried at first."""

OPTIONS = (*DELAUNAY, *QUICK)
"""Names of the options of Gmsh that a try may have."""

MENDED = "mended.brep"

_SURFACE = re.compile(r"surface (\d+)")
_PLACE = re.compile(r"intersection \(?([-+.\deE]+)\s*,\s*([-+.\deE]+)\s*,\s*([-+.\deE]+)\)?")


def usual_options(proposal):
    """Options of Gmsh with which a proposal is tried at first: dict."""
    return QUICK if proposal.elements > MANY else {}


@dataclass(frozen=True)
class MeshTry:
    """One way to ask Gmsh for a mesh.

    Attributes
    ----------
    what : str
        In words.
    proposal : SizeProposal
        The sizes.
    options : dict
        Further options of Gmsh, number by name.
    mended : str
        BREP file that is meshed in place of the part, whose faces lie on each other; empty for the part itself.
    """

    what: str
    proposal: SizeProposal
    options: dict = field(default_factory=dict)
    mended: str = ""


class MeshTries:
    """The tries for one part.

    Parameters
    ----------
    measurement : Measurement
    proposal : SizeProposal
        What is tried first.
    shape : str
        BREP file of the part.
    folder : str
        A temporary one.
    """

    def __init__(self, measurement, proposal, shape, folder):
        self._measurement, self._shape, self._folder = measurement, shape, folder
        self.first = MeshTry(message("as proposed"), proposal, usual_options(proposal))
        self._steps = [self._mended, self._finer, self._finer, self._finer_delaunay, self._details,
                       self._no_larger_than_thick]
        if proposal.settings.is_by_error:
            self._steps = [self._mended, self._finer, self._details, self._finer, self._finer_delaunay,
                           self._no_larger_than_thick]
        self._stated, self._is_long = "", False

    def after(self, last, reason, stated):
        """What to try after a try that gave no mesh: MeshTry, or None where nothing else helps.

        Parameters
        ----------
        last : MeshTry
        reason : str
            Why there is no mesh.
        stated : str
            All that Gmsh printed.
        """
        self._stated = stated
        if reason in (TIMEOUT, MEMORY):
            if not self._is_long:
                self._is_long, self._steps = True, [self._quick, self._without_thinnest, self._fewer]
                if last.proposal.elements <= LOST:
                    self._steps.insert(0, self._no_larger_than_thick)
        elif reason == INCOMPLETE:
            return None
        elif reason == CRASHED:
            if DELAUNAY.items() <= last.options.items():
                return None
            return replace(last, what=message("surfaces by Delaunay's method"), options=DELAUNAY)
        elif QUICK.items() <= last.options.items():
            # This Gmsh may not have that method, or it fails where the usual one does not.
            last = replace(last, options={name: value for name, value in last.options.items() if name not in QUICK})
            if "hxt" in stated.lower():
                return replace(last, what=message("volumes by Gmsh's usual method"))
        while self._steps:
            found = self._steps.pop(0)(last)
            if found is not None:
                return found
        return None

    def without_sizes(self):
        """What to try where no wall of the part has a size, and it is not meshed at one size: MeshTry."""
        proposal = self.first.proposal
        if proposal.only_chosen:
            full = propose_sizes(self._measurement, proposal.thin_limit, proposal.settings)
            if not full.is_uniform:
                self.first = MeshTry(message("layers in its thin walls"), full)
                return self.first
        return self._everywhere(self.first)

    def one_size(self):
        """What remains where a part is meshed at one size, and in no other way: MeshTry."""
        proposal = self.first.proposal
        found = with_sources(self._measurement, proposal, proposal.sources.below(0.0))
        return MeshTry(message("one size, since nothing finer is meshed"), replace(found, error=None))

    def _mended(self, last):
        # Imported here since the adapter loads FreeCAD.
        from ...freecad_adapter.shapes.mended_solid import write_mended

        output = os.path.join(self._folder, MENDED)
        if not write_mended(self._shape, output):
            return None
        return replace(last, what=message("faces that lie on each other taken out"), mended=output)

    def _finer(self, last):
        return replace(last, what=message("finer where Gmsh failed"), proposal=self._finer_sizes(last))

    def _finer_delaunay(self, last):
        return replace(last, what=message("finer where Gmsh failed, surfaces by Delaunay's method"),
                       proposal=self._finer_sizes(last), options={**last.options, **DELAUNAY})

    def _details(self, last):
        """The sizes at first, with those of curves, short edges and narrow faces, or without them where they had them: so
        small ones may be flaws of the model."""
        first = self.first.proposal
        is_by_error = first.settings.is_by_error
        proposal = propose_sizes(self._measurement, first.thin_limit, first.settings, first.region_sizes,
                                 has_details=is_by_error)
        if proposal.is_uniform:
            return None
        what = message("finer at curves, short edges and narrow faces") if is_by_error else message(
            "short edges and narrow faces not finer than the walls")
        return replace(last, what=what, proposal=proposal, options={})

    def _no_larger_than_thick(self, last):
        """Elements for an error aimed at may be larger: then their facets may cross the other side of a wall."""
        return self._everywhere(last) if last.proposal.settings.is_by_error and last.proposal.layers else None

    def _everywhere(self, last):
        proposal = self.first.proposal
        return MeshTry(message("no element larger than the part is thick there"), propose_everywhere(
            self._measurement, proposal.thin_limit, proposal.settings), usual_options(last.proposal), last.mended)

    def _quick(self, last):
        if QUICK.items() <= last.options.items():
            return None
        return replace(last, what=message("volumes by the HXT method, which is quicker"), options={**last.options, **QUICK})

    def _without_thinnest(self, last):
        proposal = without_thinnest(self._measurement, last.proposal)
        if proposal is None:
            return None
        return replace(last, what=message("fewer layers in the thinnest walls, a twentieth of the thin area"),
                       proposal=proposal)

    def _fewer(self, last):
        first = self.first.proposal
        budget = max(1, round(FEWER * first.elements))
        if last.proposal.elements <= budget or first.is_uniform:
            return None
        settings = replace(first.settings, budget=budget)
        what = message("a larger error, a fifth of the elements") if settings.is_by_error else message(
            "fewer layers, a fifth of the elements")
        return replace(last, what=what, proposal=propose_sizes(self._measurement, first.thin_limit, settings,
                                                               first.region_sizes))

    def _finer_sizes(self, last):
        proposal = last.proposal
        points, radius = self._places_of_failure(proposal, not last.mended)
        if not len(points):
            return with_sources(self._measurement, proposal, proposal.sources.scaled(ANOTHER))
        finer = replace(places(points, FINER * proposal.field.at(points)), radius=radius)
        return with_sources(self._measurement, proposal, proposal.sources.followed_by(finer))

    def _places_of_failure(self, proposal, has_faces):
        """Points that Gmsh names where it fails, and samples of the surfaces that it names: ndarray of shape (k, 3), mm; and
        around each, how far that holds, mm."""
        sampled = self._measurement.field
        points = np.array([[float(number) for number in match] for match in _PLACE.findall(self._stated)]).reshape(-1, 3)
        # Gmsh counts surfaces from 1, in the order of the solid's faces.
        faces = [int(number) - 1 for number in _SURFACE.findall(self._stated)] if has_faces else []
        own = np.flatnonzero(np.isin(sampled.face, faces) & (sampled.area > 0.0))
        samples = sampled.samples.points[own] + sampled.mesh.origin
        if len(points):
            alike = proposal.field.at(samples) <= ALIKE * proposal.field.at(points).max()
            own, samples = own[alike], samples[alike]
        return (np.concatenate([points, samples]),
                np.concatenate([np.zeros(len(points)), SPACING * np.sqrt(sampled.area[own])]))
