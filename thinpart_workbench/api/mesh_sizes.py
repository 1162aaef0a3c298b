"""Element sizes for parts, from the thickness of their walls, and meshes with them."""

import os
from contextlib import closing
from dataclasses import replace
from functools import partial

import numpy as np

from ..core.analysis_limits import Limits
from ..core.analysis_settings import DEFAULT_PROFILE, AnalysisSettings
from ..core.categories import NORMAL
from ..core.errors import ThinPartError
from ..core.file_formats import is_shape
from ..core.judging.classification import classify
from ..core.judging.criteria import given_profile, profile_from
from ..core.kinds.file_marks import SCRIPT
from ..core.message import message
from ..core.regular_file import open_regular
from ..core.run_control import RunControl
from ..core.shells.shell_settings import ShellSettings
from ..core.sizing.size_boxes import size_boxes
from ..core.sizing.size_field import SizeField
from ..core.sizing.size_sources import places
from ..core.sizing.sizing_settings import SizingSettings
from ..freecad_adapter.objects.snapshot import read_snapshot
from ..storage.exchange.geo_file import write_geo
from ..storage.exchange.gmsh_shape import OPTIONS, gmsh_ending, is_opened_as_shape, stem_for_gmsh
from ..storage.exchange.shell_files import SHELL_FORMATS, write_shell
from ..storage.new_file import write_new
from ..storage.output_file import check_output
from ..system.file_paths import relative_path
from ..workflow.analysis.analyse_part import analyse_part
from ..workflow.analysis.run_progress import RunProgress
from ..workflow.meshing.gmsh_program import gmsh_program
from ..workflow.meshing.part_shell import (  # noqa: F401 - the names of files, for the window
    SHELL_FACETS,
    SHELL_MESH,
    SHELL_SHAPE,
    SHELL_THICKNESS,
    save_whole,
    write_part_shell,
)
from ..workflow.meshing.part_sizing import PartSizing
from ..workflow.meshing.shell_meshing import mesh_of_record, shell_of_part, shell_walls
from ..workflow.meshing.size_run import propose_for_documents
from ..workflow.meshing.size_task import SizeTask
from .file_run import FileRun

MESH_SECONDS = 120.0
"""Limit for each mesh."""

FACETS, SIZES, POOR = "facets.npy", "sizes.npy", "poor.npy"
"""Files in the snapshot's folder: see `PartSizing`."""


def mesh_sizes(paths, settings=None, profile=DEFAULT_PROFILE, *, analysis=None, limits=None, check=False,
               mesh_seconds=MESH_SECONDS, has_sources=False, force=False, include=(), exclude=(), control=None,
               started=None, report=None, on_step=None, shell=None, region_sizes=None, all_walls=False, part=None,
               found=None):
    """Propose element sizes for the parts of files and folders.

    Parameters
    ----------
    paths : str, Path, or list of them
    settings : SizingSettings, optional
    profile : str, Path, dict or Profile, optional
        Its thin limit says which walls are thin.
    analysis : AnalysisSettings, optional
    limits : Limits, optional
        Of time for measuring a file, of memory, and the number of files at the same time.
    check : bool, optional
        Whether to mesh with Gmsh, at the global size and at the proposed sizes.
    mesh_seconds : float, optional
        Limit for each mesh.
    has_sources : bool, optional
        Whether the places with their sizes are wanted too, as `write_size_script` needs them.
    force : bool, optional
        Whether not to take results that an earlier run has kept.
    include, exclude : sequence of str, optional
        Globs for files in folders.
    control : RunControl, optional
        Pauses and stops the run.
    started, report : callable, optional
        Called with the `RunProgress` at the start; with it and each outcome.
    on_step : callable, optional
        Called with the `RunProgress` and a dict when a worker begins a step of a part, which may take minutes: ``file``,
        ``part``, its label, ``number`` and ``parts``, ``step`` (see `workflow.meshing.size_steps`) and ``attempt``.
    shell : ShellSettings, optional
        Where the parts are wanted as shells too, for `write_shell_file`: as ``shell`` of each part.
    region_sizes : dict, optional
        Sizes that are wanted on wall regions: mm, or None for none, by number of the listed region, from 0.
    all_walls : bool, optional
        Whether the thin walls of parts that are called normal get layers too; such parts mesh well at one size.
    part : str, optional
        Name or label of the only part that is wanted; empty for the only one that there is. Several are refused before they
        are measured.
    found : callable, optional
        Called with the paths of the documents, before they are measured; may raise.

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
    """
    paths = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    limits, settings = limits or Limits(jobs=os.cpu_count() or 1), settings or SizingSettings()
    control = control or RunControl()
    program, version = _gmsh(control) if check or shell else (None, "")
    run = FileRun(paths, include, exclude, control=control)
    if found is not None:
        found([document.path for document in run.documents])
    if part == "" and len(run.documents) > 1:
        raise ThinPartError(message("A script or a shell is for one part, and there are {count} documents: name one of "
                                    "them, or the part after --part.", count=len(run.documents)), "usage")
    tasks = [SizeTask(document.path, settings, given_profile(profile).content, analysis or AnalysisSettings(), program,
                      mesh_seconds, has_sources, shell, check,
                      tuple(sorted((region_sizes or {}).items())), all_walls, part) for document in run.documents]
    progress = RunProgress({document.path: (document.bytes, False) for document in run.documents}, limits.jobs)
    if started is not None:
        started(progress)
    yield from run.failures
    tell = None if on_step is None else partial(on_step, progress)
    with closing(propose_for_documents(tasks, limits, version, force, control, tell)) as outcomes:
        for outcome in outcomes:
            progress.add({"reused": False, **outcome})
            if report is not None:
                report(outcome, progress)
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
    """
    path = os.fspath(path)
    if not path.lower().endswith(".geo"):
        raise ThinPartError(message("{file} is no name for a script of Gmsh: give it the ending .geo.", file=path), "usage")
    values = np.asarray(part["sources"], dtype=np.float64).reshape(-1, 5)
    sources = replace(places(values[:, :3], values[:, 3]), radius=values[:, 4])
    field = SizeField(sources, part["global_size"], part["growth"])
    low, high = part["box"]
    inner = np.asarray(part["inner"], dtype=np.float64).reshape(-1, 3)
    boxes = size_boxes(field, low, high, inner) if field.least < part["global_size"] else None
    try:
        check_output(path, SCRIPT, overwrite, [file, *inputs])  # before a copy is made beside it
        opened, copy = _opened_by_script(path, os.path.abspath(file), part.get("mended_shape"), solids)
        write_geo(path, part["global_size"], boxes, opened, part["order"],
                  [(each["name"], each["value"]) for each in part["gmsh_options"]], overwrite, [file, *inputs])
    except OSError as error:
        raise ThinPartError(message("{file} cannot be written ({problem}): name another place.", file=path,
                                    problem=error.strerror), "failed") from None
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
    """Raise a ThinPartError of the kind ``usage`` if a path has no ending of a format for shells."""
    if os.path.splitext(os.fspath(path))[1].lower() not in SHELL_FORMATS:
        raise ThinPartError(message("{file} is no name for a shell: give it one of the endings {endings}.",
                                    file=os.fspath(path), endings=", ".join(SHELL_FORMATS)), "usage")


def write_shell_file(path, part, overwrite=False, inputs=()):
    """Write the shell of a part, in the format that the ending says: ``.inp``, ``.msh`` or ``.unv``.

    Parameters
    ----------
    path : str or Path
    part : dict
        What `mesh_sizes` yields for a part, with ``shell``.
    overwrite, inputs
        See `storage.output_file.check_output`.

    Raises
    ------
    ThinPartError
        kind ``usage`` for another ending; ``no_shell`` if the part has none; ``failed`` if the file cannot be written.
    """
    check_shell_file(path)
    shell = part["shell"]
    if not shell["elements"]:
        raise ThinPartError(message("{file} was not written. {reason}", file=os.fspath(path), reason=shell["reason"]),
                            "no_shell")
    try:
        write_shell(path, mesh_of_record(shell), part["label"], overwrite, inputs)
    except OSError as error:
        raise ThinPartError(message("{file} cannot be written ({problem}): name another place.", file=os.fspath(path),
                                    problem=error.strerror), "failed") from None


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
    """
    return shell_of_part(part, measurement, gmsh_program()[0], seconds, settings or ShellSettings())


class PartSizes:
    """The one part of a snapshot.

    Parameters
    ----------
    folder : str
        See `freecad_adapter.objects.snapshot.write_snapshot`.
    report : callable, optional
        Called with the fraction of the measurement, or later of a shell, that is done.

    Attributes
    ----------
    record : PartRecord
    shell_walls : list of dict
        Walls that a shell of the part could have: ``thickness``, mm, ``area``, mm2, and ``faces``, from 0.

    Raises
    ------
    ThinPartError
        If the part cannot be measured.
    """

    def __init__(self, folder, report=None):
        job, read = read_snapshot(folder)
        entry, = job["parts"]
        part, profile = read(entry), profile_from(job["profile"])
        self._report = report
        self._folder, self._shape, self._part = folder, os.path.join(folder, entry["file"]), part
        measurement, self.record = analyse_part(
            part, AnalysisSettings(**job["settings"]), profile,
            None if report is None else lambda stage, fraction: report(fraction if stage == "measure" else 0.0))
        self._measurement = measurement
        limit = classify(measurement.descriptors, profile).thin_limit_x * measurement.descriptors.box.diagonal
        walls, obstacle = shell_walls(part, measurement)
        self.shell_walls = [{"thickness": wall.thickness, "area": wall.area, "faces": sorted(wall.faces)} for wall in walls]
        self._sizing = PartSizing(measurement, limit, obstacle, only_chosen=self.record["category"] == NORMAL)
        np.save(os.path.join(folder, FACETS), self._sizing.facets())

    def proposed(self, settings, sizes):
        """What is proposed: dict, see `PartSizing.proposed`. Writes `SIZES`.

        Parameters
        ----------
        settings : dict
            Of `SizingSettings`.
        sizes : list of pairs
            Number of a wall region and its size, mm, or None.
        """
        wanted = SizingSettings(**settings), dict(map(tuple, sizes))
        found = self._sizing.proposed(*wanted)
        save_whole(os.path.join(self._folder, SIZES), self._sizing.sizes_on_facets(*wanted))
        return found

    def mesh(self, settings, sizes, gmsh="", seconds=MESH_SECONDS):
        """Mesh the part: dict, see `PartSizing.mesh`, without ``poor``, which is written to `POOR`.

        Parameters
        ----------
        settings, sizes
            As of `proposed`.
        gmsh : str
            A path of Gmsh that is looked at first.
        seconds : float
            Limit for each mesh.

        Raises
        ------
        ThinPartError
            kind ``unsupported`` without Gmsh.
        """
        program, _ = gmsh_program(gmsh)
        found = self._sizing.mesh(program, self._shape, SizingSettings(**settings), dict(map(tuple, sizes)), seconds,
                                  self._folder)
        save_whole(os.path.join(self._folder, POOR), found.pop("poor").astype(np.float32))
        return found

    def shell(self, settings, gmsh="", seconds=MESH_SECONDS):
        """Make the shell of the part: dict and files, see `workflow.meshing.part_shell.write_part_shell`.

        Parameters
        ----------
        settings : dict
            Of `ShellSettings`.
        gmsh, seconds
            As of `mesh`.

        Raises
        ------
        ThinPartError
            kind ``unsupported`` without Gmsh, ``no_shell`` where the part has none.
        OSError
        """
        try:
            shell = shell_of_part(self._part, self._measurement, gmsh_program(gmsh)[0], seconds, ShellSettings(**settings),
                                  self._report)
        except ThinPartError as error:
            if error.kind == "no_shell":
                self._sizing.no_shell = error.args[0]  # further proposals advise against it
            raise
        return write_part_shell(self._folder, shell, self._part.label)


def missing_gmsh(gmsh=""):
    """Why nothing can be meshed, in a sentence; empty if Gmsh is there."""
    try:
        gmsh_program(gmsh)
    except ThinPartError as error:
        return error.args[0]
    return ""
