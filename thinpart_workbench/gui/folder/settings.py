# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of a folder classification: what to classify, how, and where to write the results."""

import os
from dataclasses import dataclass

from ...core.analysis_settings import DEFAULT_PROFILE
from ...core.errors import ThinPartError
from ...core.file_formats import CHOICES
from ...core.judging.criteria import load_profile
from ...freecad_adapter.preferences import preference, preference_list, set_preference, set_preference_list
from ...storage.info.info_file import info_path
from ...storage.info.info_location import info_location
from ...storage.user_limits import limits_named
from ..application.qt import translate
from ..processes.command_arguments import check_arguments, info_folder_arguments, measuring_arguments

MAX_HISTORY = 12


@dataclass(frozen=True)
class FolderSettings:
    """Settings of one run.

    Attributes
    ----------
    folder : str
        Absolute path.
    formats : tuple of str
        Keys of `CHOICES`.
    include, exclude : str
        Name patterns separated by semicolons; empty includes everything and excludes nothing.
    beside : bool
        Whether info files go to the default location of all documents instead of `info_folder`.
    preferred_folder : str
        Default location of info files; empty for beside each document.
    info_folder : str
    profile : str
        Name of a shipped profile, or a path.
    jobs : int
        Number of files processed in parallel; 0 for one per processor.
    seconds : int
        Time limit per file.
    checks : str
        Processes to check, with commas between their names.
    force : bool
        Also measure unchanged files again.
    """

    folder: str = ""
    formats: tuple = tuple(CHOICES)
    include: str = ""
    exclude: str = ""
    beside: bool = True
    preferred_folder: str = ""
    info_folder: str = ""
    profile: str = DEFAULT_PROFILE
    jobs: int = 0
    seconds: int = 600
    checks: str = ""
    force: bool = False

    def check(self):
        """Validate the settings: Profile. Raises a ThinPartError with a message for the user."""
        if not self.folder:
            raise _usage_error(translate("ThinPart", "Choose the folder that is to be classified."))
        if not os.path.isdir(self.folder):
            raise _usage_error(translate(
                "ThinPart", "There is no folder {}: choose another one.").format(self.folder))
        if not self.formats:
            raise _usage_error(translate("ThinPart", "Choose at least one format."))
        if not self.beside and not self.info_folder:
            raise _usage_error(translate("ThinPart", "Choose the folder for the info files."))
        # The preferred folder may be on another computer: the process that uses it checks it.
        if not (self.beside and self.preferred_folder) and not _can_write(
                self.folder if self.beside else self.info_folder):
            raise _usage_error(translate(
                "ThinPart", "Info files cannot be written in {}: choose another folder for them."
            ).format(self.folder if self.beside else self.info_folder))
        self.limits()
        return load_profile(self.profile)

    def limits(self):
        """What is checked: tuple of WallLimits. Raises a ThinPartError, kind ``usage``, where a process is not known."""
        return limits_named(self.checks.split(","))

    def arguments(self):
        """list of str: arguments of ``classify``, without those of the JSON protocol."""
        excluded = [ending for name, endings in CHOICES.items() if name not in self.formats
                    for ending in endings]
        arguments = [self.folder, "--profile", self.profile, "--timeout", str(self.seconds),
                     *measuring_arguments()]
        # With '=': a pattern may start with a dash.
        arguments += [f"--include={pattern}" for pattern in _patterns(self.include)]
        arguments += [f"--exclude={pattern}" for pattern in _patterns(self.exclude)]
        arguments += [f"--exclude=*{ending}" for ending in excluded]
        if not self.beside:
            arguments += ["--info-dir", self.info_folder]
        else:
            arguments += info_folder_arguments(self.preferred_folder)
        arguments += check_arguments(self.checks)
        if self.jobs:
            arguments += ["--jobs", str(self.jobs)]
        return arguments + (["--force"] if self.force else [])

    def info_file(self, document):
        """Path of the info file of a document in the folder."""
        if self.beside:
            return info_location(document, self.preferred_folder)
        return info_path(document, self.info_folder, self.folder)


def _patterns(text):
    """Patterns of a list separated by semicolons; a word without wildcards matches names that contain it."""
    for pattern in filter(None, map(str.strip, text.split(";"))):
        yield pattern if set(pattern) & set("*?[") else f"*{pattern}*"


def _can_write(folder):
    """Whether a folder is writable, or can be created."""
    folder = os.path.abspath(folder)
    while not os.path.lexists(folder):
        folder = os.path.dirname(folder)
    return os.path.isdir(folder) and os.access(folder, os.W_OK | os.X_OK)


def _usage_error(sentence):
    return ThinPartError(sentence, "usage")


def stored_settings():
    """The settings of the last run, from FreeCAD's parameters."""
    formats = tuple(preference("FolderFormats").split())
    return FolderSettings(
        folder=(folder_history() or [""])[0],
        formats=tuple(name for name in CHOICES if name in formats),
        include=preference("FolderInclude"), exclude=preference("FolderExclude"),
        beside=not preference("FolderUsesInfoFolder"), preferred_folder=preference("InfoFolder"),
        info_folder=preference("FolderInfoFolder"),
        profile=preference("FolderProfile") or preference("Profile"),
        jobs=preference("Jobs") if preference("FolderJobs") < 0 else preference("FolderJobs"),
        seconds=preference("FolderSeconds") or preference("Seconds"),
        checks=preference("Checks"),
    )


def store_settings(settings):
    """Store settings in FreeCAD's parameters for the next run, except `force`."""
    history = [settings.folder] + [folder for folder in folder_history() if folder != settings.folder]
    set_preference_list("FolderHistory", history[:MAX_HISTORY])
    set_preference("FolderFormats", " ".join(settings.formats))
    set_preference("FolderInclude", settings.include)
    set_preference("FolderExclude", settings.exclude)
    set_preference("FolderUsesInfoFolder", int(not settings.beside))
    set_preference("FolderInfoFolder", settings.info_folder)
    # Values equal to the general preference are stored as "same", so that they follow its changes.
    for name, value, same in (("Profile", settings.profile, ""), ("Jobs", settings.jobs, -1),
                              ("Seconds", settings.seconds, 0)):
        set_preference(f"Folder{name}", same if value == preference(name) else value)


def folder_history():
    """list of str: previously classified folders, the most recent first."""
    return preference_list("FolderHistory")
