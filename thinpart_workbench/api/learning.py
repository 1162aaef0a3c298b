# SPDX-License-Identifier: LGPL-2.1-or-later
"""Learn a profile from parts that people have labelled, and write their labels as a table."""

import math
import os

from ..core.analysis_limits import Limits
from ..core.analysis_settings import DEFAULT_PROFILE
from ..core.descriptors.automatic_mesh import AUTOMATIC_SHARE
from ..core.errors import ThinPartError
from ..core.judging.criteria import given_profile, profile_from
from ..core.message import message
from ..storage.labels_file import check_labels_output, read_labels, write_labels
from ..storage.user_profiles import check_profile_file, write_profile
from ..workflow.learning.automatic_labels import THIN, THIN_FEATURES, AutomaticLabels
from ..workflow.learning.fit_probabilities import check_scikit_learn
from ..workflow.learning.kept_labels import kept_labels as kept_labels_of
from ..workflow.learning.labelling_run import label_library
from ..workflow.learning.labels import categories_of, check_library, labelled_parts
from ..workflow.learning.learn_profile import learn_profile
from ..workflow.learning.mesh_labelling import MeshLabelling
from ..workflow.learning.solver_labelling import ERROR, SolverLabelling
from ..workflow.meshing.gmsh_program import gmsh_program
from ..workflow.solving.calculix_program import calculix_program

UNNAMED = "learned"
"""Name of a profile that is written nowhere."""


LABELLING_LIMITS = Limits(seconds=60.0)
"""For each mesh: at Gmsh's default size most take less than a second."""


def learn(library, labels=(), profile=DEFAULT_PROFILE, *, kept_labels=True, output=None, report=None,
          overwrite=False, inputs=()):
    """Learn a profile from labelled parts of a library, from their info files alone. FreeCAD is not needed.

    Parameters
    ----------
    library : str or Path
        Folder with info files.
    labels : str, Path, or list of them, optional
        CSV files; docs/learning.md describes their columns. Also `AutomaticLabels`.
    profile : str, Path, dict or Profile, optional
        Where to start: name of a shipped profile, a JSON file, or the content of a profile.
    kept_labels : bool, optional
        Whether to take the labels too that people keep in the info files.
    output : str or Path, optional
        Where to write the new profile. A shipped profile, the start, the labels and files that are no profiles are not
        overwritten.
    report : callable, optional
        ``report(stage, done, total)``, where the stage is ``read`` or ``learn``; may raise `Cancelled` to stop.
    overwrite, inputs
        See `storage.output_file.check_output`; labels and profile are inputs.

    Returns
    -------
    LearnedProfile
        Its ``content`` may be given to `classify`.

    Raises
    ------
    ThinPartError
        If the profile is invalid, a label cannot be used, labels are too few, scikit-learn is not installed, or the file
        cannot be written.

    Examples
    --------
    >>> learn(samples, kept_labels=False)
    Traceback (most recent call last):
    thinpart_workbench.core.errors.ThinPartError: There are no labels in ...
    """
    check_scikit_learn()
    start = given_profile(profile)
    files = _files(labels)
    replacing = {"overwrite": overwrite, "inputs": [*_inputs(files, profile), *inputs]}
    if output is not None:
        check_profile_file(output, **replacing)
    parts = _labelled(library, files, categories_of(start), kept_labels, report)[0]
    learned = learn_profile(parts, start, UNNAMED if output is None else _stem(output), _of_stage(report, "learn"))
    if output is not None:
        write_profile(learned.content, output, **replacing)
    return learned


def export_labels(library, output, labels=(), profile=DEFAULT_PROFILE, *, kept_labels=True, overwrite=False, inputs=()):
    """Write the labels of a library as one CSV file, which `learn` reads.

    Parameters
    ----------
    library, labels, profile, kept_labels
        See `learn`; of the profile only the categories count.
    output : str or Path
        A file that is none of labels, or that somebody has changed, is not overwritten.
    overwrite, inputs
        See `storage.output_file.check_output`; labels and profile are inputs.

    Returns
    -------
    int
        Number of labels.

    Raises
    ------
    ThinPartError
        If a label cannot be used, there are none, or the file cannot be written.

    Examples
    --------
    >>> export_labels(samples, f"{samples}/labels.csv", labels)
    1
    """
    files = _files(labels)
    inputs = [*_inputs(files, profile), *inputs]
    check_labels_output(output, overwrite, inputs)
    rows = _labelled(library, files, categories_of(given_profile(profile)), kept_labels, None)[1]
    write_labels(output, rows, overwrite=overwrite, inputs=inputs)
    return len(rows)


def label_by_meshing(library, profile=DEFAULT_PROFILE, limits=LABELLING_LIMITS, *, output=None, control=None, report=None,
                     overwrite=False, inputs=()):
    """Label the classified parts of a library without a person: by how Gmsh meshes them.

    Parameters
    ----------
    library : str or Path
        Folder with info files; their documents are read.
    profile : str, Path, dict or Profile, optional
        The quantities of its conditions are examined too. It needs the categories ``thin`` and ``thin_features``.
    limits : Limits, optional
        Of processor time for each mesh, of memory, and the number of workers.
    output : str or Path, optional
        Where to write the labels as CSV. A file that is none of labels, or that somebody has changed, is not overwritten.
    control : RunControl, optional
        Pauses and stops the run.
    report : callable, optional
        Called with the number of documents done and their total.
    overwrite, inputs
        See `storage.output_file.check_output`.

    Returns
    -------
    AutomaticLabels
        With the labels, and how well each quantity foretells trouble.

    Raises
    ------
    ThinPartError
        If Gmsh is not installed, or there are no info files.
    Cancelled
        When `control` was asked to stop; what was meshed is kept for the next run.

    Examples
    --------
    >>> label_by_meshing(samples, one_category)
    Traceback (most recent call last):
    thinpart_workbench.core.errors.ThinPartError: The profile ... has no category thin_features: ...
    """
    return _label(library, lambda: MeshLabelling(gmsh_program(), float(limits.seconds)), profile, limits, output, control,
                  report, overwrite, inputs)


def label_by_solver(library, profile=DEFAULT_PROFILE, limits=LABELLING_LIMITS, *, size=AUTOMATIC_SHARE, size_mm=None,
                    error=ERROR, output=None, control=None, report=None, overwrite=False, inputs=()):
    """Label the classified parts of a library without a person: by the error of the automatic mesh, from CalculiX.

    Normal is a part whose first six elastic frequencies by the automatic mesh, tetrahedra of second order by Gmsh, are
    those of a converged mesh.

    Parameters
    ----------
    library, profile, limits, output, control, report, overwrite, inputs
        See `label_by_meshing`. A solution may take four times the time of a mesh.
    size : float, optional
        Greatest size of elements of the automatic mesh, as a share of the diagonal of the part.
    size_mm : float, optional
        The same in mm; it goes before `size`.
    error : float, optional
        Relative error of the frequencies up to which a mesh is good enough.

    Returns
    -------
    AutomaticLabels
        With the labels, and how well each quantity foretells trouble.

    Raises
    ------
    ThinPartError
        If Gmsh or CalculiX is not installed, a size or the error is no positive number, or there are no info files.
    Cancelled
        When `control` was asked to stop; what was solved is kept for the next run.

    Examples
    --------
    >>> label_by_solver(samples, size_mm=0.0)
    Traceback (most recent call last):
    thinpart_workbench.core.errors.ThinPartError: The size of elements and the error have to be more than 0: ...
    """
    if not all(math.isfinite(each) and each > 0.0 for each in (size, size if size_mm is None else size_mm, error)):
        raise ThinPartError(message("The size of elements and the error have to be more than 0: state other ones."), "usage")

    def labelling():
        return SolverLabelling(gmsh_program(), calculix_program(), float(limits.seconds), float(size),
                               None if size_mm is None else float(size_mm), float(error))

    return _label(library, labelling, profile, limits, output, control, report, overwrite, inputs)


def _label(library, labelling, profile, limits, output, control, report, overwrite, inputs):
    start = given_profile(profile)
    missing = [category for category in (THIN, THIN_FEATURES) if category not in categories_of(start)]
    if missing:
        raise ThinPartError(message("The profile {profile} has no category {categories}: labels by a program are of these.",
                                    profile=start.name, categories=", ".join(missing)), "usage")
    if output is not None:
        check_labels_output(output, overwrite, inputs)
    labels = label_library(library, labelling(), limits, start, control, report)
    if output is not None:
        figures = [result.figures for result in labels.results]
        write_labels(output, labels.labels, [(key, lambda number, key=key: _cell(figures[number][key]))
                                             for key in labels.labelling.columns], overwrite, inputs)
    return labels


def _cell(value):
    return "" if value is None else value


def save_profile(content, output, overwrite=False):
    """Write a learned profile; raises ThinPartError.

    Parameters
    ----------
    content : dict
        Of a `LearnedProfile`. It gets the name of the file.
    output : str or Path
        A shipped profile is not overwritten.
    overwrite : bool, optional
        Whether a file that is no profile may be overwritten.

    Examples
    --------
    >>> save_profile(profile, f"{samples}/own.json")
    >>> given_profile(f"{samples}/own.json").name
    'own'
    """
    name = _stem(output)
    write_profile(profile_from({**content, "name": name, "title": name}).content, output, overwrite)


def _files(labels):
    return [labels] if isinstance(labels, (str, os.PathLike, AutomaticLabels)) else list(labels)


def _labelled(library, files, categories, with_kept, report):
    """The labelled parts, list of LabelledPart; and the labels, list of Label."""
    rows = [row for file in files
            for row in (file.labels if isinstance(file, AutomaticLabels) else read_labels(file, categories))]
    if with_kept:
        check_library(library)
        rows += kept_labels_of(library, categories, _of_stage(report, "read"))
    if not rows:
        raise ThinPartError(message("There are no labels in {folder}: label parts in the window, or by 'thinpart note "
                                    "--label', or name CSV files of labels.", folder=os.fspath(library)), "usage")
    parts = labelled_parts(library, rows, categories)
    return parts, [label for part in parts for label in part.labels]


def _of_stage(report, stage):
    return None if report is None else lambda done, total: report(stage, done, total)


def _stem(path):
    return os.path.splitext(os.path.basename(path))[0]


def _inputs(labels, profile):
    """The files that are learned from."""
    return [each for each in (*labels, profile) if isinstance(each, (str, os.PathLike))]
