# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the first elastic frequencies of the automatic mesh are off those of a converged one."""

import math
import os
import time
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np

from ...core.descriptors.automatic_mesh import AUTOMATIC_SHARE
from ...core.message import message
from ...storage.exchange.msh_file import read_tetrahedra
from ..meshing.gmsh_program import mesh_volume, stated_error
from .elastic_frequencies import COUNT, elastic_frequencies

FINER = (0.5, 0.7)
"""Ratios of sizes of one reference mesh to the one before: of the first, and of those that follow."""

CONVERGED, KNOWN = 0.01, 0.02
"""Change of the frequencies from one reference mesh to the next at which no finer one is made; and up to which the last one
is a reference."""

MOST_MESHES = 5
"""Reference meshes that are made at most."""

_OPTIMIZE = "Mesh.HighOrderOptimize"

UNTANGLED = ("-setnumber", _OPTIMIZE, "1")
"""Option with which Gmsh moves nodes of the second order until no element is inside out, as far as it can."""

STRAIGHT = ("-setnumber", "Mesh.SecondOrderLinear", "1")
"""Option with which the sides of elements are straight, so that none is inside out: less accurate on round parts."""

OTHER_WAYS = ((), UNTANGLED, ("-setnumber", "Mesh.Algorithm", "5", *UNTANGLED), STRAIGHT, ("-algo", "meshadapt", *STRAIGHT))
"""Options with which a reference mesh is made, one after the other until there is one: they change no size."""

SOLVED, NO_MESH, NOT_SOLVED, UNKNOWN = "solved", "no_mesh", "not_solved", "unknown"
"""What became of a part: an error is known; the automatic mesh fails, or the solver refuses it; nothing is known of it."""


@dataclass(frozen=True)
class AutomaticMesh:
    """The automatic mesh of a part, compared with a converged one.

    Attributes
    ----------
    outcome : str
        `SOLVED`, `NO_MESH`, `NOT_SOLVED` or `UNKNOWN`.
    error : float or None
        Greatest relative error of the first six elastic frequencies.
    reason : str
        Why there is none.
    nodes : int
    is_tangled : bool
        Whether the solver refuses the mesh as it is, and all is of the one that Gmsh has untangled.
    is_straight : bool
        Whether all is of one with straight sides, since Gmsh could not untangle it in time.
    change : float or None
        Between the last two reference meshes: how far the reference may be off.
    reference_nodes : int
    frequencies, reference : tuple of float
        Hz, of the part scaled to a diagonal of 100 mm.
    """

    outcome: str
    error: Optional[float] = None
    reason: str = ""
    nodes: int = 0
    is_tangled: bool = False
    is_straight: bool = False
    change: Optional[float] = None
    reference_nodes: int = 0
    frequencies: tuple = ()
    reference: tuple = ()


@dataclass(frozen=True)
class SolvingLimits:
    """Limits of meshes of one part.

    Attributes
    ----------
    mesh_seconds, solver_seconds : float
        Of processor time, for each mesh.
    nodes : int
        Of a reference mesh.
    seconds : float
        By the clock, after which no finer reference mesh is made.
    """

    mesh_seconds: float = 60.0
    solver_seconds: float = 240.0
    nodes: int = 32_000
    seconds: float = math.inf


def automatic_mesh_error(shape, diagonal, gmsh, calculix, limits, folder, size=None, untangle=True):
    """Compare the automatic mesh of a part, tetrahedra of second order, with finer ones: AutomaticMesh.

    Parameters
    ----------
    shape : str
        Its file, in `folder`.
    diagonal : float
        Of its box, in the unit of the file.
    gmsh, calculix : str
        Paths of the programs.
    limits : SolvingLimits
    folder : str
        Working directory, temporary.
    size : float, optional
        Greatest size of elements of the automatic mesh, in the unit of the file; by default `element_size`.
    untangle : bool, optional
        Whether Gmsh is asked to untangle meshes that the solver refuses, which takes it a minute or more on some; else they
        have straight sides at once.
    """
    solver = _Solver(shape, diagonal, gmsh, calculix, limits, folder, untangle)
    size = element_size(diagonal, size)
    points, tetrahedra, reason = solver.mesh(size)
    if not len(tetrahedra):
        return AutomaticMesh(NO_MESH, reason=reason)
    own, reason = solver.frequencies(points, tetrahedra)
    is_too_large = len(points) > limits.nodes
    is_tangled = len(own) < COUNT and not is_too_large
    found = AutomaticMesh(UNKNOWN, nodes=len(points), is_tangled=is_tangled)
    for options in solver.remedies if is_tangled else ():
        points, tetrahedra, _ = solver.mesh(size, options)
        if len(tetrahedra):
            own, reason = solver.frequencies(points, tetrahedra)
        if len(own) == COUNT:
            found = replace(found, is_straight=options is STRAIGHT)
            break
    found = replace(found, frequencies=tuple(own.tolist()))
    if len(own) < COUNT:  # a mesh too large for the solver's limits is not to blame for it
        return replace(found, outcome=UNKNOWN if is_too_large else NOT_SOLVED, reason=reason)
    last, change, count, reason = solver.converged(size, found.nodes)
    found = replace(found, change=change, reference_nodes=count, reason=reason)
    if last is None:
        return found
    return replace(found, outcome=SOLVED, error=largest_change(own, last), reference=tuple(last.tolist()))


def element_size(diagonal, size=None):
    """The greatest size of elements, float: as asked for, but at most `AUTOMATIC_SHARE`, since Gmsh makes none larger."""
    return AUTOMATIC_SHARE * diagonal if size is None else min(size, AUTOMATIC_SHARE * diagonal)


def largest_change(frequencies, reference):
    """The greatest relative difference, float, of frequencies in ascending order, ndarrays of shape (n,)."""
    return float(np.max(np.abs(frequencies / reference - 1.0)))


class _Solver:
    def __init__(self, shape, diagonal, gmsh, calculix, limits, folder, untangle):
        self._shape, self._diagonal, self._folder = shape, diagonal, folder
        self._gmsh, self._calculix, self._limits = gmsh, calculix, limits
        self.remedies = (UNTANGLED, STRAIGHT) if untangle else (STRAIGHT,)
        self._ways = [way for way in OTHER_WAYS if untangle or _OPTIMIZE not in way]
        self._until = time.monotonic() + limits.seconds

    def mesh(self, size, options=()):
        """Points and tetrahedra of a mesh of a size; and why there are none."""
        output = os.path.join(self._folder, "part.msh")
        if os.path.exists(output):
            os.remove(output)
        reason, text = mesh_volume(self._gmsh, [self._shape], output, self._limits.mesh_seconds, self._folder,
                                   ("-clmax", repr(float(size)), "-order", "2", *options))
        points, tetrahedra = (np.zeros((0, 3)), np.zeros((0, 10), int)) if reason else read_tetrahedra(output, 2)
        if not len(tetrahedra):
            reason = reason or stated_error(text) or message("Gmsh filled no volume")
        return points, tetrahedra, reason

    def frequencies(self, points, tetrahedra):
        """The elastic frequencies of a mesh, and why there are none."""
        return elastic_frequencies(points, tetrahedra, self._diagonal, self._calculix, self._limits.solver_seconds,
                                   self._folder)

    def converged(self, size, nodes):
        """The frequencies of the finest reference mesh, or None; the change to the last, its nodes, and why there is none.

        Parameters
        ----------
        size : float
            Of elements, than which all reference meshes are finer.
        nodes : int
            Of the automatic mesh, from which those of the next are estimated.
        """
        last, change, count, reason = None, None, nodes, ""
        for number in range(MOST_MESHES):
            if time.monotonic() > self._until:
                reason = reason or message("its reference mesh took too long")
                break
            size *= FINER[min(number, 1)]
            if last is not None and count * FINER[1] ** -2 > self._limits.nodes:
                break
            found, points, reason = self._reference(size)
            if len(found) < COUNT:
                if last is None:
                    continue
                break
            if last is not None:
                change = largest_change(last, found)
            last, count = found, points
            if change is not None and change < CONVERGED:
                break
        return last, change, count, reason

    def _reference(self, size):
        for options in self._ways:
            points, tetrahedra, reason = self.mesh(size, options)
            if len(tetrahedra):
                if len(points) > 2 * self._limits.nodes:
                    return np.zeros(0), 0, message("its reference mesh is too large")
                found, reason = self.frequencies(points, tetrahedra)
                if len(found) == COUNT:
                    return found, len(points), ""
        return np.zeros(0), 0, reason
