# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element sizes of one part of an open document, in the folder of its snapshot: what a process writes, the window reads."""

import os

import numpy as np

from ...core.analysis_settings import AnalysisSettings
from ...core.categories import NORMAL
from ...core.errors import ThinPartError
from ...core.judging.classification import classify
from ...core.judging.criteria import profile_from
from ...core.shells.shell_mesh import ALIKE
from ...core.shells.shell_settings import ShellSettings
from ...core.sizing.sizing_settings import SizingSettings
from ...freecad_adapter.objects.snapshot import read_snapshot
from ...workflow.analysis.analyse_part import analyse_part
from ...workflow.meshing.gmsh_program import gmsh_program
from ...workflow.meshing.part_shell import (
    SHELL_FACETS,
    SHELL_MESH,
    SHELL_SHAPE,
    SHELL_THICKNESS,
    save_whole,
    write_part_shell,
)
from ...workflow.meshing.part_sizing import PartSizing
from ...workflow.meshing.shell_meshing import shell_of_part, shell_walls
from ..mesh_sizes import MESH_SECONDS

_FACETS, _NORMALS, _SIZES, _POOR = "facets.npy", "normals.npy", "sizes.npy", "poor.npy"


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
        for name, array in zip((_FACETS, _NORMALS), self._sizing.facets()):
            np.save(os.path.join(folder, name), array)

    def proposed(self, settings, sizes):
        """What is proposed: dict, see `PartSizing.proposed`. Writes what `shown_sizes` reads.

        Parameters
        ----------
        settings : dict
            Of `SizingSettings`.
        sizes : list of pairs
            Number of a wall region and its size, mm, or None.
        """
        wanted = SizingSettings(**settings), dict(map(tuple, sizes))
        found = self._sizing.proposed(*wanted)
        save_whole(os.path.join(self._folder, _SIZES), self._sizing.sizes_on_facets(*wanted))
        return found

    def mesh(self, settings, sizes, gmsh="", seconds=MESH_SECONDS):
        """Mesh the part: dict, see `PartSizing.mesh`, without ``poor``, which `poor_elements` reads.

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
        save_whole(os.path.join(self._folder, _POOR), found.pop("poor").astype(np.float32))
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
            shell = shell_of_part(self._part, self._measurement, gmsh_program(gmsh)[0], seconds,
                                  ShellSettings(**settings, on_faces=True), self._report)
        except ThinPartError as error:
            if error.kind == "no_shell":
                self._sizing.no_shell = error.args[0]  # further proposals advise against it
            raise
        return write_part_shell(self._folder, shell, self._part.label)


def shown_sizes(folder):
    """The facets of a part, ndarray of shape (n, 3, 3), the element sizes at their corners, (n, 3), as proposed last, and
    the normals of the surface there, (n, 3, 3).

    All but the normals in mm; `folder` is that of the snapshot.

    Examples
    --------
    >>> sizes = PartSizes(snapshot)
    >>> proposal = sizes.proposed({"order": 2}, [])
    >>> shown_sizes(snapshot)[1].shape[1]
    3
    """
    return _array(folder, _FACETS), _array(folder, _SIZES), _array(folder, _NORMALS)


def poor_elements(folder):
    """Corners of the poor elements of the mesh that was made last: ndarray of shape (n, 4, 3), float32, mm.

    Examples
    --------
    >>> np.save(f"{snapshot}/poor.npy", np.empty((0, 4, 3)))
    >>> len(poor_elements(snapshot))
    0
    """
    return _array(folder, _POOR)


def shown_shell(folder):
    """The triangles of the last shell, ndarray of shape (m, 3, 3), and the thickness of each, (m,): float32, mm.

    Examples
    --------
    >>> np.save(f"{snapshot}/shell.npy", np.zeros((7, 3, 3)))
    >>> np.save(f"{snapshot}/shell_thickness.npy", np.full(7, 2.0))
    >>> [len(array) for array in shown_shell(snapshot)]
    [7, 7]
    """
    return _array(folder, SHELL_FACETS), _array(folder, SHELL_THICKNESS)


def shell_files(folder):
    """Paths of the mid-surface, a BREP file, and of its mesh, a UNV file.

    Examples
    --------
    >>> [os.path.basename(file) for file in shell_files(snapshot)]
    ['middle.brep', 'shell.unv']
    """
    return os.path.join(folder, SHELL_SHAPE), os.path.join(folder, SHELL_MESH)


def shown_thickness_range(thicknesses):
    """The ends of a scale of colours for the walls of a shell, mm: walls that are alike get one colour in its middle.

    Examples
    --------
    >>> shown_thickness_range([2.0, 3.0])
    (2.0, 3.0)
    >>> shown_thickness_range([2.0, 2.01])[0]
    1.0
    """
    least, most = min(thicknesses), max(thicknesses)
    return (least, most) if most > ALIKE * least else (0.5 * least, 1.5 * most)


def rows_to_keep(meshed, sizes):
    """What is kept of a mesh that worked, for other parts.

    Parameters
    ----------
    meshed : dict
        From `PartSizes.mesh`.
    sizes : list of pairs
        With which it was made; see `PartSizes.proposed`.

    Returns
    -------
    dict
        ``rows``, ``global_size`` and ``figures``, as arguments of `keep_mesh_settings`.

    Examples
    --------
    >>> made = {"regions": [], "global_size": 8.0, "proposed": dict.fromkeys(
    ...     ("elements", "poor_share", "gamma_least", "layers_share", "tries"), 0)}
    >>> rows_to_keep(made, [])["global_size"]
    8.0
    """
    changed = {number for number, _ in sizes}
    rows = [{"kind": row["kind"], "thickness": row["thickness"], "size": row["size"],
             "is_changed": not changed.isdisjoint(row["regions"])} for row in meshed["regions"]]
    figures = {key: meshed["proposed"][key] for key in ("elements", "poor_share", "gamma_least", "layers_share", "tries")}
    return {"rows": rows, "global_size": meshed["global_size"], "figures": figures}


def _array(folder, name):
    return np.load(os.path.join(folder, name))
