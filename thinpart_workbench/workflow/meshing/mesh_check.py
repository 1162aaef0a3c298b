# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes a part with Gmsh, with and without proposed sizes, and measures both meshes."""

import os
import time
from dataclasses import replace
from functools import partial

import numpy as np

from ...core.errors import ThinPartError
from ...core.mesh.sampling import even_samples
from ...core.mesh.second_order import straightened
from ...core.mesh.tetrahedra import POOR, inverse_condition_numbers, layers_through, radius_ratios
from ...core.message import message
from ...core.sizing.size_boxes import size_boxes
from ...storage.exchange.geo_file import geo_text
from ...storage.exchange.msh_file import move_points, read_tetrahedra
from .gmsh_program import CRASHED, INCOMPLETE, MEMORY, TIMEOUT, mesh_volume, stated_error
from .mesh_tries import MeshTries
from .netgen_program import has_netgen, mesh_with_netgen
from .size_steps import ONE_SIZE, SIZES

MESH = "part.msh"

ATTEMPTS = 10
"""How often a part is tried at most; see `mesh_tries`."""

LAYERS_ASKED = 1500
"""Places of thin walls at which layers are counted."""


def checked_sizes(program, shape, measurement, proposal, seconds, folder, default=None, on_mesh=None, solid=None,
                  on_step=None):
    """Mesh a part at the global size and at the proposed ones.

    Returns `check` (dict; ``default`` and ``proposed``, see `mesh_figures`) and `tried` (MeshTry; what was meshed at last).

    Parameters
    ----------
    program : str
        Path of Gmsh.
    shape : str
        File of the part that Gmsh opens, in `folder`.
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
    solid : str, optional
        BREP file of the part, where `shape` is none.
    on_step : callable, optional
        Called with `size_steps.ONE_SIZE` or `SIZES`, and the number of the attempt, before each mesh.
    """
    order = proposal.settings.order
    walls, tries = thin_places(measurement, proposal), MeshTries(measurement, proposal, solid or shape, folder)
    if default is None or proposal.is_uniform:
        if on_step is not None:
            on_step(ONE_SIZE)
        default, _ = _meshed(program, [shape], seconds, folder, ("-clmax", repr(proposal.global_size),
                                                                 "-order", str(order)),
                             walls, partial(on_mesh, "default") if on_mesh else None, order)
    done, tried = [], tries.first
    if proposal.is_uniform:
        if default["elements"] or default["reason"] in (CRASHED, TIMEOUT, MEMORY):
            return {"default": default, "proposed": default}, tried
        done, tried = [_tried(tried, default)], tries.without_sizes()
    mesh = measurement.field.mesh
    low, high = (end(mesh.vertices, axis=0) + mesh.origin for end in (np.min, np.max))
    script = os.path.join(folder, "size.geo")
    while True:
        sizes = tried.proposal
        if on_step is not None:
            on_step(SIZES, len(done) + 1)
        boxes = None if sizes.is_uniform else size_boxes(sizes.field, low, high, sizes.inner.points.reshape(-1, 3))
        with open(script, "w", encoding="utf-8") as file:
            file.write(geo_text(sizes.global_size, boxes, os.path.basename(tried.mended or shape), sizes.settings.order,
                                tried.options.items()))
        proposed, stated = _meshed(program, [script], seconds, folder, (), walls,
                                   partial(on_mesh, "proposed") if on_mesh else None, order)
        done.append(_tried(tried, proposed))
        if proposed["elements"] or tried.proposal.is_uniform:
            break
        following = tries.after(tried, proposed["reason"], stated)
        if following is None and default["elements"] and proposed["reason"] != INCOMPLETE:
            following = tries.one_size()
        if following is None:
            break
        tried = following
    if not proposed["elements"] and proposed["reason"] != INCOMPLETE and has_netgen():
        tried = replace(tries.first, what=message("by Netgen, since Gmsh does not mesh it"))
        if on_step is not None:
            on_step(SIZES, len(done) + 1)
        proposed, _ = _by_netgen(solid or shape, tried.proposal, seconds, folder, walls,
                                 partial(on_mesh, "proposed") if on_mesh else None)
        done.append(_tried(tried, proposed))
    proposed.update(attempts=len(done), tries=done)
    joined = "" if proposed["elements"] or default["elements"] else _joined_bodies(solid or shape)
    if joined:
        default["reason"] = proposed["reason"] = joined
    return {"default": default, "proposed": proposed}, tried


def _joined_bodies(shape):
    """Why nothing can fill a shape whose bodies touch along edges; empty for another one."""
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.shapes.mended_solid import edges_of_many_faces

    count = edges_of_many_faces(shape)
    return "" if not count else message(
        "edges of it join more than two faces ({count}), as where bodies touch along them: fuse these with some overlap, or "
        "separate them", count=count)


def _tried(tried, figures):
    return {"what": tried.what, "reason": figures["reason"], "seconds": figures["seconds"]}


def _meshed(program, inputs, seconds, folder, options, walls, on_mesh=None, order=1):
    """Figures of a mesh, and what Gmsh printed."""
    output, started = os.path.join(folder, MESH), time.perf_counter()
    if os.path.exists(output):
        os.remove(output)
    reason, text = mesh_volume(program, inputs, output, seconds, folder, options)
    return _figures_of(output, started, reason, text, walls, on_mesh, order)


def _by_netgen(shape, proposal, seconds, folder, walls, on_mesh):
    output, started = os.path.join(folder, MESH), time.perf_counter()
    reason = mesh_with_netgen(shape, proposal, output, seconds, folder)
    return _figures_of(output, started, reason, "", walls, on_mesh, proposal.settings.order)


def _figures_of(output, started, reason, text, walls, on_mesh, order):
    took = time.perf_counter() - started
    if reason:
        return mesh_figures(took, reason), text
    try:
        points, tetrahedra, straightened = _solvable(output, order)
    except ThinPartError:
        return mesh_figures(took, INCOMPLETE), text
    if not len(tetrahedra):
        return mesh_figures(took, stated_error(text) or message("Gmsh filled no volume")), text
    if on_mesh is not None:
        on_mesh(points, tetrahedra)
    return mesh_figures(took, "", points, tetrahedra, walls, straightened), text


def _solvable(output, order):
    """Points, corners of the tetrahedra of a mesh, and the number of sides that were made straight in its file."""
    points, tetrahedra = read_tetrahedra(output, order)
    if order == 1 or not len(tetrahedra):
        return points, tetrahedra, 0
    found, moved = straightened(points, tetrahedra)
    if len(moved):
        move_points(output, found)
    return found, tetrahedra[:, :4], len(moved)


def mesh_figures(seconds, reason, points=None, tetrahedra=None, walls=None, straightened=0):
    """Figures of a mesh.

    Returns a dict: the reason, numbers of elements and nodes, gamma and minSICN, share of poor elements, share of the thin
    places that have the wanted layers, seconds.

    Parameters
    ----------
    seconds : float
        That it took.
    reason : str
        Why there is none; empty if there is one.
    points : ndarray of shape (n, 3), mm
    tetrahedra : ndarray of shape (m, 4), int64
    walls : tuple
        See `thin_places`.
    straightened : int
        Sides of elements of second order that were made straight, since elements would be inside out else.
    """
    found = {"reason": reason, "elements": 0, "nodes": 0, "straightened": straightened, "gamma_least": None,
             "gamma_1_percent": None, "gamma_mean": None,
             "poor_share": None, "sicn_least": None, "sicn_1_percent": None, "sicn_mean": None, "layers_share": None,
             "seconds": round(seconds, 2), "attempts": 1, "tries": []}
    if points is None:
        return found
    gamma, sicn = radius_ratios(points, tetrahedra), inverse_condition_numbers(points, tetrahedra)
    found.update(
        elements=len(tetrahedra), nodes=len(points), gamma_least=_rounded(gamma.min()),
        gamma_1_percent=_rounded(np.quantile(gamma, 0.01)),
        gamma_mean=_rounded(gamma.mean()), poor_share=_rounded(np.mean(gamma < POOR)), sicn_least=_rounded(sicn.min()),
        sicn_1_percent=_rounded(np.quantile(sicn, 0.01)), sicn_mean=_rounded(sicn.mean()))
    here, there, area, wanted = walls
    if len(here):
        layers = layers_through(points, tetrahedra, here, there, wanted)
        found["layers_share"] = _rounded(area[layers >= wanted].sum() / area.sum())
    return found


def _rounded(value):
    return round(float(value), 5)


def thin_places(measurement, proposal):
    """Places of thin parallel walls, at which `mesh_figures` counts layers.

    Returns `here` and `there` (ndarray of shape (k, 3), mm; both sides of the wall), `area` (ndarray of shape (k,), mm2) and
    `wanted` (int; layers).
    """
    field = measurement.field
    thin = np.flatnonzero((field.area > 0.0) & field.parallel & (field.distance < proposal.thin_limit))
    if len(thin):
        thin = thin[np.unique(even_samples(field.area[thin], LAYERS_ASKED))]
    here = field.samples.points[thin] + field.mesh.origin
    there = here - field.distance[thin, None] * field.normals[thin]
    return here, there, field.area[thin], max(1, int(np.floor(proposal.layers + 1e-6)))
