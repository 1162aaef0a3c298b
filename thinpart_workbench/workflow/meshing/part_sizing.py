# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element sizes of one part that people change, and meshes with them: the part is measured once."""

import os
from contextlib import suppress

import numpy as np

from ...core.maps.facet_refinement import cut_sides, side_lengths
from ...core.mesh.smooth_normals import normals_at
from ...core.mesh.tetrahedra import POOR, radius_ratios
from ...core.message import message
from ...core.shells.shell_or_solid import idealisation_values
from ...core.sizing.element_estimate import MANY_NODES, solver_seconds
from ...core.sizing.size_groups import median_size, size_groups
from ...core.sizing.size_proposal import propose_sizes
from ...core.sizing.size_sources import size_sources
from .gmsh_program import convert_mesh
from .mesh_check import MESH, checked_sizes

BINS = 20
"""Bins of the histogram of gamma, from 0 to 1."""

MOST_POOR = 20_000
"""Poor elements that are shown at most, the worst."""

FACETS = 20_000
"""Facets into which the surface is cut, about, to show sizes on it."""

_MOST_CUTS = 8


class PartSizing:
    """Proposals for one measured part.

    Parameters
    ----------
    measurement : Measurement
    thin_limit : float, mm
    no_shell : str
        Why a shell of the part cannot be made; empty where it can, or nothing is known. It may be changed.
    only_chosen : bool
        See `propose_sizes`.
    """

    def __init__(self, measurement, thin_limit, no_shell="", only_chosen=False):
        self._measurement, self._thin_limit, self.no_shell = measurement, thin_limit, no_shell
        self._only_chosen = only_chosen
        self._default = None  # (what it depends on, figures, histogram) of the last mesh at the global size
        self._points = np.empty((0, 3, 3))

    def proposed(self, settings, region_sizes):
        """What is proposed, of plain values, all lengths in mm: dict.

        Parameters
        ----------
        settings : SizingSettings
        region_sizes : dict
            See `propose_sizes`.
        """
        proposal = self._proposal(settings, region_sizes)
        unbounded = proposal.unbounded
        return {
            "elements": proposal.elements, "nodes": proposal.nodes, "is_large": proposal.nodes > MANY_NODES,
            "solver_seconds": solver_seconds(proposal.nodes), "error": proposal.error,
            "wanted_error": settings.error if settings.is_by_error else None,
            "uniform_elements": proposal.uniform_elements, "layers": proposal.layers,
            "wanted_layers": settings.wanted_layers, "layered_from": proposal.layered_from,
            "global_size": proposal.global_size,
            "least_size": proposal.least_size, "order": settings.order, "growth": settings.growth,
            "unbounded_elements": None if unbounded is None else unbounded.elements,
            "unbounded_nodes": None if unbounded is None else unbounded.nodes,
            "regions": self._rows(proposal, settings), "left_out": proposal.left_out,
            "idealisation": idealisation_values(self._measurement, proposal.elements, self.no_shell),
        }

    def facets(self):
        """The surface, cut into facets on which sizes can be shown, and its normals at their corners.

        Two ndarrays of shape (m, 3, 3), float32: mm, and unit vectors.
        """
        mesh = self._measurement.field.mesh
        points, facets = mesh.vertices, mesh.triangles
        longest = 1.6 * np.sqrt(4.0 / np.sqrt(3.0) * mesh.areas.sum() / FACETS)
        of_mesh = np.arange(mesh.count)
        for _ in range(_MOST_CUTS):
            cut = side_lengths(points, facets) > longest
            if not cut.any() or len(facets) > 3 * FACETS:
                break
            points, facets, parents = cut_sides(points, facets, cut)
            of_mesh = of_mesh[parents]
        self._points = (points + mesh.origin)[facets]
        normals = normals_at(mesh, np.repeat(of_mesh, 3), points[facets].reshape(-1, 3)).reshape(-1, 3, 3)
        return self._points.astype(np.float32), normals.astype(np.float32)

    def sizes_on_facets(self, settings, region_sizes):
        """Size at each corner of `facets`: ndarray of shape (m, 3), float32, mm."""
        field = self._proposal(settings, region_sizes).field
        return field.at(self._points.reshape(-1, 3)).reshape(-1, 3).astype(np.float32)

    def mesh(self, program, shape, settings, region_sizes, seconds, folder):
        """Mesh the part with Gmsh, at the global size and as proposed.

        Returns a dict: ``default`` and ``proposed``: figures as of `checked_sizes`, with ``histogram``, the share of the
        elements in each of `BINS`; ``mesh``, a UNV file, empty where there is none; ``poor``, an ndarray of shape (k, 4, 3),
        mm: the corners of poor elements of the last mesh; ``poor_count``, of all of them; ``regions`` and ``global_size``,
        as of `proposed`, with the sizes that the mesh has.

        Parameters
        ----------
        program : str
            Path of Gmsh.
        shape : str
            BREP file of the part.
        settings : SizingSettings
        region_sizes : dict
        seconds : float
            Limit for each mesh.
        folder : str
            Working directory.
        """
        proposal, known = self._proposal(settings, region_sizes), self._default
        depends = proposal.global_size, settings.order
        histograms: dict = {}
        poor: list = [np.empty((0, 4, 3)), 0]
        if known is None or known[0] != depends or proposal.is_uniform:
            known = None

        def on_mesh(name, points, tetrahedra):
            gamma = radius_ratios(points, tetrahedra)
            histograms[name] = (np.histogram(gamma, BINS, (0.0, 1.0))[0] / len(gamma)).tolist()
            worst = np.argsort(gamma)[:np.count_nonzero(gamma < POOR)]
            poor[:] = points[tetrahedra[worst[:MOST_POOR]]], len(worst)

        check, tried = checked_sizes(program, shape, self._measurement, proposal, seconds, folder,
                                 None if known is None else known[1], on_mesh)
        if known is not None:
            histograms["default"] = known[2]
        self._default = depends, check["default"], histograms.get("default", [])
        found: dict = {name: {**figures, "histogram": histograms.get("default" if tried.proposal.is_uniform else name, [])}
                       for name, figures in check.items()}
        found.update(regions=self._rows(tried.proposal, settings), global_size=tried.proposal.global_size)
        found.update(mesh="", poor=poor[0] if check["proposed"]["elements"] else np.empty((0, 4, 3)),
                     poor_count=poor[1] if check["proposed"]["elements"] else 0)
        if check["proposed"]["elements"]:
            output = os.path.join(folder, "part.unv")
            with suppress(FileNotFoundError):
                os.remove(output)
            reason = convert_mesh(program, os.path.join(folder, MESH), output, seconds, folder)
            if reason:
                found["proposed"] = {**found["proposed"], "elements": 0,
                                     "reason": message("the mesh was not written ({problem})", problem=reason)}
            else:
                found["mesh"] = output
        return found

    def _proposal(self, settings, region_sizes):
        return propose_sizes(self._measurement, self._thin_limit, settings, region_sizes, only_chosen=self._only_chosen)

    def _rows(self, proposal, settings):
        """A row for equal regions of which one asks for a size, also for those that people have switched off."""
        sources = size_sources(self._measurement, self._thin_limit, settings, not settings.is_by_error).below(
            settings.global_size(self._measurement.descriptors.box.diagonal))
        return [{"region": group.numbers[0], "regions": list(group.numbers), "kind": group.kind, "word": group.word,
                 "count": group.count, "thickness": group.median, "thinnest": group.least,
                 "faces": list(group.faces), "proposed_size": median_size(sources, group.numbers),
                 "size": group.size, "layers": group.layers, "elements": group.elements}
                for group in size_groups(self._measurement, proposal) if median_size(sources, group.numbers) is not None]
