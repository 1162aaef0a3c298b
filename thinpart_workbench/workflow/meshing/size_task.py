# SPDX-License-Identifier: LGPL-2.1-or-later
"""Propose element sizes for the parts of one document, and mesh them. Runs in a worker process."""

import os
import shutil
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional

import numpy as np

from ...core.analysis_settings import AnalysisSettings
from ...core.categories import NORMAL
from ...core.errors import ThinPartError
from ...core.file_formats import is_shape
from ...core.judging.classification import classify
from ...core.judging.criteria import profile_from
from ...core.message import message
from ...core.shells.shell_or_solid import idealisation_values
from ...core.shells.shell_settings import ShellSettings
from ...core.sizing.size_groups import size_groups
from ...core.sizing.size_proposal import propose_sizes
from ...core.sizing.sizing_settings import SizingSettings
from ...storage.exchange.gmsh_shape import gmsh_ending
from ..analysis.analyse_part import analyse_part
from .mesh_check import checked_sizes
from .mesh_tries import usual_options
from .shell_meshing import no_shell_record, shell_obstacle, shell_of_part, shell_record
from .size_steps import MEASURE, SHELL


@dataclass(frozen=True)
class SizeTask:
    """One document whose parts are to be meshed.

    Attributes
    ----------
    file : str
    settings : SizingSettings
    profile : dict
        Content of the profile: its thin limit says which walls are thin.
    analysis : AnalysisSettings
    program : str or None
        Path of Gmsh, to mesh with and without the sizes.
    seconds : float
        Limit for each mesh.
    has_sources : bool
        Whether the places and their sizes are wanted too.
    shell : ShellSettings or None
        Where a shell is wanted too; that needs `program`.
    check : bool
        Whether to mesh with and without the sizes; that needs `program`.
    region_sizes : tuple of (int, float or None)
        See `propose_sizes`.
    all_walls : bool
        Whether thin walls of a part that is called normal get layers too.
    part : str or None
        Name or label of the only part that is wanted; empty for the only one that there is, None for all.
    """

    file: str
    settings: SizingSettings
    profile: dict
    analysis: AnalysisSettings = field(default_factory=AnalysisSettings)
    program: Optional[str] = None
    seconds: float = 120.0
    has_sources: bool = False
    shell: Optional[ShellSettings] = None
    check: bool = True
    region_sizes: tuple = ()
    all_walls: bool = False
    part: Optional[str] = None


def propose_for_document(task, note):
    """Propose sizes for every part of a document.

    Returns a dict: ``parts``: see `size_record`; ``failures``: ``part``, ``label``, ``kind`` and ``message``; ``solids``,
    the number of parts of the document. Raises ThinPartError if the document cannot be read, or, before any is measured, if
    several parts may be the one that is wanted.

    Parameters
    ----------
    task : SizeTask
    note : StepNote
        Is told what is done with which part.
    """
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.reading.part_files import read_parts

    profile, content = profile_from(task.profile), read_parts(task.file)
    parts, broken = content.parts, content.broken
    if task.part:
        parts, broken = ([each for each in some if task.part in (each.name, each.label)] for some in (parts, broken))
    if task.part is not None and len(parts) > 1:
        raise ThinPartError(message("{file} has {count} parts, and one is written: name it after --part, as {example}.",
                                    file=Path(task.file).name, count=len(parts), example=parts[0].name), "usage")
    records, failures = [], [each.failure() for each in broken]
    for number, part in enumerate(parts, 1):
        note.part(part.label, number, len(parts))
        try:
            records.append(_proposed(part, profile, task, len(content.parts) == 1, note))
        except ThinPartError as error:
            failures.append({"part": part.name, "label": part.label, "kind": error.kind, "message": str(error)})
    return {"parts": records, "failures": failures, "solids": len(content.parts)}


def _proposed(part, profile, task, is_alone, note):
    note.begin(MEASURE)
    measurement, judged = analyse_part(part, task.analysis, profile)
    diagonal = measurement.descriptors.box.diagonal
    limit = classify(measurement.descriptors, profile).thin_limit_x * diagonal
    proposal = propose_sizes(measurement, limit, task.settings, dict(task.region_sizes),
                             only_chosen=judged["category"] == NORMAL and not task.all_walls)
    check, tried, mended = None, None, ""
    if task.program is not None and task.check:
        with tempfile.TemporaryDirectory(prefix="thinpart-gmsh-") as folder:
            shape = solid = os.path.join(folder, "part.brep")
            part.write_brep(shape)
            if is_alone and is_shape(task.file):
                # As the script opens it: what FreeCAD exports may differ in a detail. A copy, since Gmsh runs some files by
                # their names, and scripts that lie beside others.
                shape = os.path.join(folder, f"document{gmsh_ending(task.file)}")
                shutil.copyfile(task.file, shape)
            check, tried = checked_sizes(task.program, shape, measurement, proposal, task.seconds, folder, solid=solid,
                                         on_step=note.begin)
            proposal = tried.proposal
            if tried.mended and task.has_sources:
                mended = Path(tried.mended).read_text(encoding="utf-8")
    if task.shell is not None:
        note.begin(SHELL)
    shell = None if task.shell is None else _shell(part, measurement, task)
    record = size_record(part, judged, measurement, proposal, check, task.has_sources, tried,
                         shell_obstacle(part, measurement) if shell is None else shell["reason"])
    if mended:
        record["mended_shape"] = mended
    if shell is not None:
        record["shell"] = shell
    return record


def _shell(part, measurement, task):
    """The shell of a part as plain values, or why there is none: its sizes are proposed all the same."""
    try:
        return shell_record(shell_of_part(part, measurement, task.program, task.seconds, task.shell))
    except ThinPartError as error:
        return no_shell_record(error)


def size_record(part, record, measurement, proposal, check, has_sources, tried, no_shell):
    """What is proposed for a part, of plain values: dict, all lengths in mm.

    Parameters
    ----------
    part : Part
    record : PartRecord
    measurement : Measurement
    proposal : SizeProposal
    check : dict or None
        See `mesh_check.checked_sizes`.
    has_sources : bool
        With ``sources``: rows of x, y, z, size and radius, mm; ``inner``: points within the part; and ``box``: the least and
        greatest coordinates.
    tried : MeshTry or None
        What was meshed.
    no_shell : str
        Why a shell cannot be made; see `idealisation`.
    """
    unbounded = proposal.unbounded
    groups = [group for group in size_groups(measurement, proposal) if group.size is not None]
    of_region = {number: group for group in groups for number in group.numbers}
    options = tried.options if tried else usual_options(proposal)
    found = {
        "name": part.name, "label": part.label, "category": record["category"],
        "diagonal": _rounded(measurement.descriptors.box.diagonal), "thin_limit": _rounded(proposal.thin_limit),
        "order": proposal.settings.order, "growth": proposal.settings.growth,
        "wanted_layers": proposal.settings.wanted_layers, "layers": _rounded(proposal.layers),
        "layered_from": _rounded(proposal.layered_from),
        "global_size": _rounded(proposal.global_size), "least_size": _rounded(proposal.least_size),
        "elements": proposal.elements, "nodes": proposal.nodes, "error": proposal.error,
        "uniform_elements": proposal.uniform_elements,
        "unbounded": None if unbounded is None else {
            "layers": _rounded(unbounded.layers), "least_size": _rounded(unbounded.least_size),
            "elements": unbounded.elements, "nodes": unbounded.nodes},
        "regions": [_region_row(each, of_region[each.number]) for each in proposal.regions],
        "region_groups": [_group_row(group) for group in groups],
        "check": check, "idealisation": idealisation_values(measurement, proposal.elements, no_shell),
        "left_out": proposal.left_out,
        "gmsh_options": [{"name": name, "value": value} for name, value in options.items()],
        "is_mended": bool(tried and tried.mended),
    }
    if has_sources:
        vertices, sources = measurement.field.mesh.vertices, proposal.sources
        found["inner"] = proposal.inner.points.reshape(-1, 3).tolist()
        found["sources"] = np.column_stack([sources.points, sources.sizes, sources.radius]).tolist()
        found["box"] = [(end(vertices, axis=0) + measurement.field.mesh.origin).tolist() for end in (np.min, np.max)]
    return found


def _region_row(each, group):
    """One of equal regions: its measures are its own, its size is that of all of them."""
    region = each.region
    return {"region": each.number + 1, "kind": region.kind, "thickness": _rounded(region.median),
            "thinnest": _rounded(region.least), "area": _rounded(region.area), "length": _rounded(region.length),
            "width": _rounded(region.width), "faces": [f"Face{face + 1}" for face in region.faces],
            "size": _rounded(group.size), "layers": _rounded(group.layers), "elements": each.elements,
            "group": group.numbers[0] + 1}


def _group_row(group):
    return {"regions": [number + 1 for number in group.numbers], "count": group.count, "kind": group.kind,
            "word": group.word, "thickness": _rounded(group.median), "thinnest": _rounded(group.least),
            "area": _rounded(group.area), "length": _rounded(group.length), "width": _rounded(group.width),
            "faces": [f"Face{face + 1}" for face in group.faces], "size": _rounded(group.size),
            "layers": _rounded(group.layers), "elements": group.elements}


def _rounded(value):
    return float(f"{value:.6g}")
