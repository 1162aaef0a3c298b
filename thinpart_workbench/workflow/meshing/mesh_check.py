"""Meshes a part with Gmsh, with and without proposed sizes, and measures both meshes."""

import os
import re
import time
from dataclasses import replace
from functools import partial

import numpy as np

from ...core.mesh.tetrahedra import POOR, inverse_condition_numbers, layers_through, radius_ratios
from ...core.message import message
from ...core.sizing.size_boxes import size_boxes
from ...core.sizing.size_sources import places
from ...storage.exchange.geo_file import geo_text
from ...storage.exchange.msh_file import read_tetrahedra
from .gmsh_program import CRASHED, MEMORY, TIMEOUT, mesh_volume, stated_error

MESH = "part.msh"

ATTEMPTS = 4
"""How often a part that Gmsh does not mesh is tried again, finer where it failed."""

FINER = 0.5
"""Of the size there, at places at which Gmsh failed."""

ANOTHER = 0.8
"""Of all sizes, where Gmsh does not say where it failed: a surface that cannot be meshed with some sizes, can be with
others."""

DELAUNAY_FROM = 2
"""The attempt from which on surfaces are meshed by the Delaunay method, which is less neat and fails less."""

HOPELESS = (CRASHED, TIMEOUT, MEMORY)
"""Reasons after which finer elements do not help."""

LAYERS_ASKED = 1500
"""Places of thin walls at which layers are counted."""

_SURFACE = re.compile(r"surface (\d+)")
_PLACE = re.compile(r"intersection \(?([-+.\deE]+)\s*,\s*([-+.\deE]+)\s*,\s*([-+.\deE]+)\)?")


def checked_sizes(program, shape, measurement, proposal, seconds, folder, default=None, on_mesh=None):
    """Mesh a part at the global size and at the proposed ones.

    Parameters
    ----------
    program : str
        Path of Gmsh.
    shape : str
        BREP file of the part.
    measurement : Measurement
    proposal : SizeProposal
    seconds : float
        Limit for each mesh.
    folder : str
        A temporary one; the last mesh stays there, as `MESH`.
    default : dict, optional
        Figures of the mesh at the global size, where they are known.
    on_mesh : callable, optional
        Called with ``default`` or ``proposed``, points and tetrahedra of each mesh.

    Returns
    -------
    check : dict
        ``default`` and ``proposed``, see `_figures`.
    proposal : SizeProposal
        With the sizes that were meshed at last: finer at places where Gmsh failed at first.
    """
    order = ("-order", str(proposal.settings.order)) if proposal.settings.order != 1 else ()
    walls = _thin_places(measurement, proposal)
    if default is None or proposal.is_uniform:
        default, _ = _meshed(program, [shape], seconds, folder, ("-clmax", repr(proposal.global_size), *order), walls,
                             partial(on_mesh, "default") if on_mesh else None)
    if proposal.is_uniform:
        return {"default": default, "proposed": default}, proposal
    mesh = measurement.field.mesh
    low, high = (end(mesh.vertices, axis=0) + mesh.origin for end in (np.min, np.max))
    inner = proposal.inner.points.reshape(-1, 3)
    script = os.path.join(folder, "size.geo")
    for attempt in range(ATTEMPTS):
        with open(script, "w", encoding="utf-8") as file:
            file.write(geo_text(proposal.global_size, size_boxes(proposal.field, low, high, inner), shape,
                                proposal.settings.order))
        options = ("-algo", "del2d") if attempt >= DELAUNAY_FROM else ()
        proposed, text = _meshed(program, [script], seconds, folder, options, walls,
                                 partial(on_mesh, "proposed") if on_mesh else None)
        proposed["attempts"] = attempt + 1
        if proposed["elements"] or proposed["reason"] in HOPELESS:
            break
        proposal = _finer_at(proposal, _places_of_failure(text, measurement.field))
    return {"default": default, "proposed": proposed}, proposal


def _meshed(program, inputs, seconds, folder, options, walls, on_mesh=None):
    """Figures of a mesh, and what Gmsh printed."""
    output, started = os.path.join(folder, MESH), time.perf_counter()
    if os.path.exists(output):
        os.remove(output)
    reason, text = mesh_volume(program, inputs, output, seconds, folder, options)
    took = time.perf_counter() - started
    if reason:
        return _figures(took, reason), text
    points, tetrahedra = read_tetrahedra(output)
    if not len(tetrahedra):
        return _figures(took, stated_error(text) or message("Gmsh filled no volume")), text
    if on_mesh is not None:
        on_mesh(points, tetrahedra)
    return _figures(took, "", points, tetrahedra, walls), text


def _figures(seconds, reason, points=None, tetrahedra=None, walls=None):
    """Figures of a mesh, dict: `reason` why there is none, number of elements, gamma and minSICN, share of poor elements,
    share of the thin places that have the wanted layers, seconds."""
    found = {"reason": reason, "elements": 0, "gamma_least": None, "gamma_1_percent": None, "gamma_mean": None,
             "poor_share": None, "sicn_least": None, "layers_share": None, "seconds": round(seconds, 2), "attempts": 1}
    if points is None:
        return found
    gamma, sicn = radius_ratios(points, tetrahedra), inverse_condition_numbers(points, tetrahedra)
    found.update(
        elements=len(tetrahedra), gamma_least=_rounded(gamma.min()), gamma_1_percent=_rounded(np.quantile(gamma, 0.01)),
        gamma_mean=_rounded(gamma.mean()), poor_share=_rounded(np.mean(gamma < POOR)), sicn_least=_rounded(sicn.min()))
    here, there, area, wanted = walls
    if len(here):
        layers = layers_through(points, tetrahedra, here, there, wanted)
        found["layers_share"] = _rounded(area[layers >= wanted].sum() / area.sum())
    return found


def _rounded(value):
    return round(float(value), 5)


def _thin_places(measurement, proposal):
    """Places of thin parallel walls: both ends, two ndarrays of shape (k, 3), their area, and whole layers wanted."""
    field = measurement.field
    thin = np.flatnonzero((field.area > 0.0) & field.parallel & (field.distance < proposal.thin_limit))
    # Evenly spread samples, each for the same share of the area of all.
    if len(thin):
        reached = np.cumsum(field.area[thin])
        asked = (np.arange(LAYERS_ASKED) + 0.5) / LAYERS_ASKED * reached[-1]
        thin = thin[np.unique(np.searchsorted(reached, asked))]
    here = field.samples.points[thin] + field.mesh.origin
    there = here - field.distance[thin, None] * field.normals[thin]
    return here, there, field.area[thin], max(1, int(np.floor(proposal.layers + 1e-6)))


def _places_of_failure(text, field):
    """Points that Gmsh names where it fails, ndarray of shape (k, 3), mm, or else of the surfaces that it names."""
    found = [[float(number) for number in match] for match in _PLACE.findall(text)]
    if found:
        return np.array(found)
    # Gmsh counts surfaces from 1, in the order of the solid's faces.
    faces = [int(number) - 1 for number in _SURFACE.findall(text)]
    return field.samples.points[np.isin(field.face, faces)] + field.mesh.origin


def _finer_at(proposal, failed_at):
    if not len(failed_at):
        return replace(proposal, sources=proposal.sources.scaled(ANOTHER))
    finer = places(failed_at, FINER * proposal.field.at(failed_at))
    return replace(proposal, sources=proposal.sources.followed_by(finer))
