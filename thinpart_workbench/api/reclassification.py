# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judge stored parts again, without geometry."""

import os

from ..core.analysis_settings import DEFAULT_PROFILE
from ..core.errors import ThinPartError
from ..core.judging.criteria import given_profile
from ..core.message import message
from ..storage.info.info_file import SUFFIX
from ..storage.info.info_tree import scan
from ..storage.info.stored_records import info_file_of
from ..workflow.library.reclassify import reclassify_files
from ..workflow.library.verdict_changes import VerdictChanges


class Reclassification:
    """An iterable that judges info files by another profile and yields a `ReclassifiedFile` for each.

    Parameters
    ----------
    info_files : list of str
    problems : list of str
    profile, write, jobs, control
        See `reclassify`.

    Attributes
    ----------
    info_files : list of str
    profile : Profile
    problems : list of str
        One sentence per folder that could not be searched.
    """

    def __init__(self, info_files, problems, profile=DEFAULT_PROFILE, write=False, jobs=1, control=None):
        self.info_files, self.problems = info_files, problems
        self.profile = given_profile(profile)
        self._write, self._jobs, self._control = write, jobs, control

    def __len__(self):
        return len(self.info_files)

    def __iter__(self):
        return reclassify_files(self.info_files, self.profile.content, self._write, self._jobs, self._control)


def reclassify(paths, profile=DEFAULT_PROFILE, *, write=False, jobs=1, control=None):
    """Judge stored parts by another profile, from their info files alone. FreeCAD is not needed.

    Parameters
    ----------
    paths : str, Path, or list of them
        Folders with info files, documents that were classified, or info files.
    profile : str, Path, dict or Profile, optional
        Name of a shipped profile, a JSON file, or the content of a profile.
    write : bool, optional
        Whether to update the info files.
    jobs : int, optional
        Number of processes.
    control : RunControl, optional
        Stops the run from another thread.

    Returns
    -------
    Reclassification
        Nothing is judged or written until it is iterated.

    Raises
    ------
    ThinPartError
        If the profile is invalid, a document was not classified, or there are no info files.

    Examples
    --------
    >>> len(list(reclassify([plate], "paper")))  # files
    1
    """
    profile = given_profile(profile)  # first, so that an invalid one is refused before folders are read
    paths = [os.fspath(path) for path in ([paths] if isinstance(paths, (str, os.PathLike)) else paths)]
    found: list[str] = []
    problems: list[str] = []
    for path in paths:
        if os.path.isdir(path):
            below, unlisted = _info_files_below(path)
            found += below
            problems += unlisted
        else:
            found.append(os.fspath(info_file_of(path)))
    if not found:
        raise ThinPartError(message("There are no info files (*{ending}) in {paths}: classify the parts first.",
                                    ending=SUFFIX, paths=", ".join(paths)), "empty")
    return Reclassification(list(dict.fromkeys(found)), problems, profile, write, jobs, control)


def reclassify_folders(folders, profile=DEFAULT_PROFILE, *, write=False, jobs=1, control=None):
    """As `reclassify`, of libraries: those that are empty, or that are not there at the moment, are no error.

    Parameters
    ----------
    folders : list of str
    profile, write, jobs, control
        See `reclassify`.

    Returns
    -------
    Reclassification
        Folders that cannot be listed are among its ``problems``.

    Raises
    ------
    ThinPartError
        If the profile is invalid.

    Examples
    --------
    >>> len(list(reclassify_folders([samples])))
    2
    """
    profile = given_profile(profile)
    searched = [_info_files_below(folder) for folder in folders]
    return Reclassification([file for found, _ in searched for file in found],
                            [problem for _, problems in searched for problem in problems], profile, write, jobs, control)


def verdict_changes(folders):
    """What one profile after another would change in libraries, from the descriptors in their info files.

    Parameters
    ----------
    folders : list of str
        As for `reclassify_folders`.

    Returns
    -------
    VerdictChanges
        Nothing is read yet but the lists of the folders, and nothing is ever written.

    Examples
    --------
    >>> type(verdict_changes([samples])).__name__
    'VerdictChanges'
    """
    searched = [_info_files_below(folder) for folder in folders]
    return VerdictChanges(list(dict.fromkeys(file for found, _ in searched for file in found)),
                          [problem for _, problems in searched for problem in problems])


def _info_files_below(path):
    """Info files in a folder, and a sentence for each folder that cannot be listed: two lists of str."""
    found, unreachable = scan(path)
    problems = [message("The folder {folder} cannot be listed ({problem}): the files in it were not changed.",
                        folder=os.path.join(path, os.fsdecode(folder)), problem=error.strerror)
                for folder, error in unreachable.items()]
    return [os.path.join(path, os.fsdecode(name)) for name in sorted(found)], problems
