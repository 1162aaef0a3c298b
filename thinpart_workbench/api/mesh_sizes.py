# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element sizes for parts, from the thickness of their walls, and meshes with them."""

import os
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial
from typing import Callable, Optional

import numpy as np

from ..core.analysis_limits import Limits
from ..core.analysis_settings import DEFAULT_PROFILE, AnalysisSettings
from ..core.errors import ThinPartError
from ..core.file_formats import is_shape
from ..core.judging.criteria import given_profile
from ..core.kinds.file_marks import SCRIPT
from ..core.message import message
from ..core.regular_file import open_regular
from ..core.run_control import RunControl
from ..core.shells.shell_settings import ShellSettings
from ..core.sizing.size_boxes import size_boxes
from ..core.sizing.size_field import SizeField
from ..core.sizing.size_sources import places
from ..core.sizing.sizing_settings import SizingSettings
from ..storage.exchange.geo_file import write_geo
from ..storage.exchange.gmsh_shape import OPTIONS, gmsh_ending, is_opened_as_shape, stem_for_gmsh
from ..storage.exchange.shell_files import MIXED_FORMATS, SHELL_FORMATS, write_shell
from ..storage.new_file import write_new
from ..storage.output_file import check_output, writing
from ..system.file_paths import relative_path
from ..workflow.analysis.run_progress import RunProgress
from ..workflow.meshing.gmsh_program import gmsh_program
from ..workflow.meshing.shell_meshing import mesh_of_record, shell_of_part, solid_of_record
from ..workflow.meshing.size_run import propose_for_documents
from ..workflow.meshing.size_task import SizeTask
from .file_run import FileRun

MESH_SECONDS = 120.0
"""Limit for each mesh."""

@dataclass(frozen=True)
class MeshRequest:
    """What is wanted of the meshes of parts.

    Attributes
    ----------
    sizing : SizingSettings
    region_sizes : tuple of (int, float or None)
        Sizes that are wanted on wall regions: number of the listed region, from 0, and mm, or None for none.
    all_walls : bool
        Whether the thin walls of parts that are called normal get layers too; such parts mesh well at one size.
    check : bool
        Whether to mesh with Gmsh, at the global size and at the proposed sizes.
    shell : ShellSettings or None
        Where the parts are wanted as shells too, for `write_shell_file`: as ``shell`` of each part.
    mesh_seconds : float, s
        Limit for each mesh.
    has_sources : bool
        Whether the places with their sizes are wanted too, as `write_size_script` needs them.
    part : str or None
        Name or label of the only part that is wanted; empty for the only one that there is. Several are refused before they
        are measured.
    """

    sizing: SizingSettings = SizingSettings()
    region_sizes: tuple = ()
    all_walls: bool = False
    check: bool = False
    shell: Optional[ShellSettings] = None
    mesh_seconds: float = MESH_SECONDS
    has_sources: bool = False
    part: Optional[str] = None


@dataclass(frozen=True)
class FileChoice:
    """Which files are taken, and from where.

    Attributes
    ----------
    include, exclude : tuple of str
        Globs for files in folders.
    force : bool
        Whether not to take results that an earlier run has kept.
    found : callable or None
        Called with the paths of the documents, before they are measured; may raise.
    """

    include: tuple = ()
    exclude: tuple = ()
    force: bool = False
    found: Optional[Callable] = None


@dataclass(frozen=True)
class SizeProgress:
    """Who is told how far a run is; each may be None.

    Attributes
    ----------
    started : callable
        Called with the `RunProgress` at the start.
    counted : callable
        Called with each outcome and the `RunProgress`.
    step : callable
        Called with the `RunProgress` and a dict when a worker begins a step of a part, which may take minutes: ``file``,
        ``part``, its label, ``number`` and ``parts``, ``step`` (see `workflow.meshing.size_steps`) and ``attempt``.
    """

    started: Optional[Callable] = None
    counted: Optional[Callable] = None
    step: Optional[Callable] = None


def mesh_sizes(paths, request=None, profile=DEFAULT_PROFILE, *, analysis=None, limits=None, files=None, control=None,
               progress=None):
    """Propose element sizes for the parts of files and folders.

    Parameters
    ----------
    paths : str, Path, or list of them
    request : MeshRequest, optional
    profile : str, Path, dict or Profile, optional
        Its thin limit says which walls are thin.
    analysis : AnalysisSettings, optional
    limits : Limits, optional
        Of time for measuring a file, of memory, and the number of files at the same time.
    files : FileChoice, optional
    control : RunControl, optional
        Pauses and stops the run.
    progress : SizeProgress, optional

    Yields
    ------
    dict
        Per file, as they finish: ``file``, ``parts`` (see `workflow.meshing.size_result.PART_SIZES`) and ``failures``; or
        ``error`` with ``kind`` and ``message``.

    Raises
    ------
    ThinPartError
        If there are no files, several where there should be one part, or Gmsh is missing and needed.
    Cancelled
        If `control` was asked to stop; what is done is kept for the next run.

    Examples
    --------
    >>> outcome, = mesh_sizes(plate, MeshRequest(SizingSettings(layers=1)), limits=Limits(jobs=1))
    >>> outcome["parts"][0]["regions"][0]["size"]
    8.0
    """
    request, files, progress = request or MeshRequest(), files or FileChoice(), progress or SizeProgress()
    paths = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    limits, control = limits or Limits(jobs=os.cpu_count() or 1), control or RunControl()
    program, version = _gmsh(control) if request.check or request.shell else (None, "")
    run = FileRun(paths, files.include, files.exclude, control=control)
    if files.found is not None:
        files.found([document.path for document in run.documents])
    if request.part == "" and len(run.documents) > 1:
        raise ThinPartError(message("A script or a shell is for one part, and there are {count} documents: name one of "
                                    "them, or the part after --part.", count=len(run.documents)), "usage")
    tasks = [SizeTask(document.path, request.sizing, given_profile(profile).content, analysis or AnalysisSettings(), program,
                      request.mesh_seconds, request.has_sources, request.shell, request.check,
                      tuple(sorted(request.region_sizes)), request.all_walls, request.part) for document in run.documents]
    state = RunProgress({document.path: (document.bytes, False) for document in run.documents}, limits.jobs)
    if progress.started is not None:
        progress.started(state)
    yield from run.failures
    tell = None if progress.step is None else partial(progress.step, state)
    with closing(propose_for_documents(tasks, limits, version, files.force, control, tell)) as outcomes:
        for outcome in outcomes:
            state.add({"reused": False, **outcome})
            if progress.counted is not None:
                progress.counted(outcome, state)
            yield outcome


def _gmsh(control):
    try:
        return gmsh_program()
    except ThinPartError:
        control.check()  # a Ctrl-C that ended Gmsh too does not mean that it is missing
        raise


def write_size_script(path, part, file, solids=1, overwrite=False, inputs=()):
    """Write the proposed sizes as a script for Gmsh.

    Parameters
    ----------
    path : str or Path
        Of the script, with the ending ``.geo``.
    part : dict
        What `mesh_sizes` yields for a part, with ``sources``.
    file : str
        The document of the part; the script opens it where Gmsh can. A part that was mended to mesh it is written beside the
        script, with the ending ``.mended.brep``, and opened in its place; so is a copy with the ending ``.part.step`` or the
        like, where the script cannot say the path, or Gmsh would take the file for a script.
    solids : int
        Parts of the document: the script opens it only where there is one.
    overwrite, inputs
        See `storage.output_file.check_output`; the document is an input.

    Returns
    -------
    str or None
        The name of the file that was written beside the script, or was there with the same content; none is replaced.

    Raises
    ------
    ThinPartError
        kind ``usage`` if the path would overwrite something that is no such script, or has another ending; ``failed`` if
        it cannot be written.

    Examples
    --------
    >>> write_size_script(f"{samples}/sizes.msh", {}, plate)
    Traceback (most recent call last):
    thinpart_workbench.core.errors.ThinPartError: ... is no name for a script of Gmsh: give it the ending .geo.
    """
    path = os.fspath(path)
    if not path.lower().endswith(".geo"):
        raise ThinPartError(message("{file} is no name for a script of Gmsh: give it the ending .geo.", file=path), "usage")
    values = np.asarray(part["sources"], dtype=np.float64).reshape(-1, 5)
    sources = replace(places(values[:, :3], values[:, 3]), radius=values[:, 4])
    field = SizeField(sources, part["global_size"], part["growth"])
    low, high = part["box"]
    inner = np.asarray(part["inner"], dtype=np.float64).reshape(-1, 3)
    boxes = size_boxes(field, low, high, inner) if len(values) else None
    with writing(path):
        check_output(path, SCRIPT, overwrite, [file, *inputs])  # before a copy is made beside it
        opened, copy = _opened_by_script(path, os.path.abspath(file), part.get("mended_shape"), solids)
        write_geo(path, part["global_size"], boxes, opened, part["order"],
                  [(each["name"], each["value"]) for each in part["gmsh_options"]], overwrite, [file, *inputs])
    return copy


def _opened_by_script(script, file, mended, solids):
    """What a script opens as the part, and the name of the file that was written for it; None for nothing."""
    folder = os.path.dirname(os.path.abspath(script))
    if mended:
        content, ending = mended.encode(), ".mended.brep"
    elif solids == 1 and is_shape(file):
        opened = relative_path(file, folder)
        if is_opened_as_shape(opened, folder):
            return opened, None
        with open_regular(file) as stream:
            content, ending = stream.read(), f".part{gmsh_ending(file)}"
    else:
        return None, None
    name = write_new(folder, stem_for_gmsh(os.path.basename(script)[:-len(".geo")]), ending, content,
                     mode=os.stat(file).st_mode & 0o666, companion=OPTIONS)
    return name, name


def check_shell_file(path):
    """Raise a ThinPartError of the kind ``usage`` if a path has no ending of a format for shells.

    Examples
    --------
    >>> check_shell_file("lid.stl")
    Traceback (most recent call last):
    thinpart_workbench.core.errors.ThinPartError: lid.stl is no name for a shell: give it one of the endings .inp, ...
    """
    if os.path.splitext(os.fspath(path))[1].lower() not in SHELL_FORMATS:
        raise ThinPartError(message("{file} is no name for a shell: give it one of the endings {endings}.",
                                    file=os.fspath(path), endings=", ".join(SHELL_FORMATS)), "usage")


def takes_solids(path):
    """Whether a file of this name has the rest of a part too, as a solid that is tied to its shell: bool.

    Examples
    --------
    >>> takes_solids("lid.inp"), takes_solids("lid.unv")
    (True, False)
    """
    return os.path.splitext(os.fspath(path))[1].lower() in MIXED_FORMATS


def write_shell_file(path, part, overwrite=False, inputs=()):
    """Write the shell of a part, in the format that the ending says: ``.inp``, ``.msh`` or ``.unv``.

    Parameters
    ----------
    path : str or Path
    part : dict
        What `mesh_sizes` yields for a part, with ``shell``; what its ``solid`` has is in the file where that `takes_solids`.
    overwrite, inputs
        See `storage.output_file.check_output`.

    Raises
    ------
    ThinPartError
        kind ``usage`` for another ending; ``no_shell`` if the part has none; ``failed`` if the file cannot be written.

    Examples
    --------
    >>> none = {"label": "lid", "shell": {"elements": 0, "reason": "It has no walls."}}
    >>> write_shell_file("lid.inp", none)
    Traceback (most recent call last):
    thinpart_workbench.core.errors.ThinPartError: lid.inp was not written. It has no walls.
    """
    check_shell_file(path)
    shell = part["shell"]
    if not shell["elements"]:
        raise ThinPartError(message("{file} was not written. {reason}", file=os.fspath(path), reason=shell["reason"]),
                            "no_shell")
    with writing(path):
        solid = solid_of_record(shell) if takes_solids(path) else None
        write_shell(path, mesh_of_record(shell), part["label"], overwrite, inputs, solid)


def shell_of(part, measurement, settings=None, seconds=MESH_SECONDS):
    """The mid-surface of a part that is measured already, as a mesh with a thickness for each element.

    Parameters
    ----------
    part : SolidPart
    measurement : Measurement
        By rays.
    settings : ShellSettings, optional
    seconds : float
        Limit for Gmsh, which makes the triangles.

    Returns
    -------
    PartShell
        ``mesh`` with ``points``, ``triangles``, ``wall`` and ``thickness``; ``walls``, ``left_solid`` and ``warnings``.

    Raises
    ------
    ThinPartError
        kind ``no_shell`` where the part has none, ``no_solid`` for triangles, ``unsupported`` without Gmsh.

    Examples
    --------
    >>> from thinpart_workbench import classify
    >>> part, = classify(document)
    >>> shell = shell_of(document_parts(document)[0], part.measurement)
    >>> round(float(shell.mesh.thickness.mean()), 2)
    2.0
    """
    return shell_of_part(part, measurement, gmsh_program()[0], seconds, settings or ShellSettings())


def missing_gmsh(gmsh=""):
    """Why nothing can be meshed, in a sentence; empty if Gmsh is there.

    Examples
    --------
    >>> print(missing_gmsh() or "Gmsh is there")
    Gmsh is there
    """
    try:
        gmsh_program(gmsh)
    except ThinPartError as error:
        return error.args[0]
    return ""
