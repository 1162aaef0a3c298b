"""What is asked about a whole folder: what to classify, how, and where the results go."""

import os
from dataclasses import dataclass

from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..freecad_adapter.settings import preference, preference_list, set_preference, set_preference_list
from ..storage.info_file import info_path
from ..workflow.info_location import info_location
from .command_arguments import info_place_arguments, measuring_arguments
from .qt import translate

FORMATS = {
    "FreeCAD": (".fcstd",),
    "STEP": (".step", ".stp"),
    "IGES": (".iges", ".igs"),
    "BREP": (".brep", ".brp"),
    "Mesh": (".stl", ".obj", ".ply", ".off", ".3mf"),
}
"""Formats that can be chosen, and the endings that each stands for."""

LONGEST_HISTORY = 12


@dataclass(frozen=True)
class FolderSettings:
    """The choices for one run.

    Attributes
    ----------
    folder : str
        Absolute.
    formats : tuple of str
        Keys of `FORMATS`.
    include, exclude : str
        Patterns of names, separated by semicolons; empty stands for all and for none.
    beside : bool
        Whether info files go where those of all documents go, and not into `info_folder`.
    preferred_folder : str
        Where those of all documents go; empty for beside each document.
    info_folder : str
    profile : str
        A shipped profile's name, or a file.
    jobs : int
        Files at once; 0 stands for one per processor.
    seconds : int
        That one file may take.
    force : bool
        Measure again what has not changed.
    """

    folder: str = ""
    formats: tuple = tuple(FORMATS)
    include: str = ""
    exclude: str = ""
    beside: bool = True
    preferred_folder: str = ""
    info_folder: str = ""
    profile: str = "paper"
    jobs: int = 0
    seconds: int = 600
    force: bool = False

    def check(self):
        """Refuse what cannot be run.

        Returns
        -------
        Profile

        Raises
        ------
        ThinPartError
            One sentence for the user.
        """
        if not self.folder:
            raise _refused(translate("ThinPart", "Choose the folder that is to be classified."))
        if not os.path.isdir(self.folder):
            raise _refused(translate(
                "ThinPart", "There is no folder {}: choose another one.").format(self.folder))
        if not self.formats:
            raise _refused(translate("ThinPart", "Choose at least one format."))
        if not self.beside and not self.info_folder:
            raise _refused(translate("ThinPart", "Choose the folder for the info files."))
        # The preferred folder may be on another computer: the process that uses it looks at it.
        if not (self.beside and self.preferred_folder) and not _can_write(
                self.folder if self.beside else self.info_folder):
            raise _refused(translate(
                "ThinPart", "Info files cannot be written in {}: choose another folder for them."
            ).format(self.folder if self.beside else self.info_folder))
        return load_profile(self.profile)

    def arguments(self):
        """list of str: arguments of ``classify`` without those of the conversation with it."""
        unwanted = [ending for name, endings in FORMATS.items() if name not in self.formats
                    for ending in endings]
        arguments = [self.folder, "--profile", self.profile, "--timeout", str(self.seconds),
                     *measuring_arguments()]
        # With '=': a pattern may start with a dash.
        arguments += [f"--include={each}" for each in _patterns(self.include)]
        arguments += [f"--exclude={each}" for each in _patterns(self.exclude)]
        arguments += [f"--exclude=*{ending}" for ending in unwanted]
        if not self.beside:
            arguments += ["--info-dir", self.info_folder]
        else:
            arguments += info_place_arguments(self.preferred_folder)
        if self.jobs:
            arguments += ["--jobs", str(self.jobs)]
        return arguments + (["--force"] if self.force else [])

    def info_file(self, document):
        """Path of the info file of a document of the folder."""
        if self.beside:
            return info_location(document, self.preferred_folder)
        return info_path(document, self.info_folder, self.folder)


def _patterns(text):
    """Patterns of a list; a word without any wildcard stands for names that hold it."""
    for each in filter(None, map(str.strip, text.split(";"))):
        yield each if set(each) & set("*?[") else f"*{each}*"


def _can_write(folder):
    """Whether a folder, or what is missing of it, can be written."""
    folder = os.path.abspath(folder)
    while not os.path.lexists(folder):
        folder = os.path.dirname(folder)
    return os.path.isdir(folder) and os.access(folder, os.W_OK | os.X_OK)


def _refused(sentence):
    return ThinPartError(sentence, "usage")


def kept_settings():
    """The choices of the last time, from FreeCAD's parameters."""
    formats = tuple(preference("FolderFormats").split())
    return FolderSettings(
        folder=(folder_history() or [""])[0],
        formats=tuple(name for name in FORMATS if name in formats),
        include=preference("FolderInclude"), exclude=preference("FolderExclude"),
        beside=not preference("FolderUsesInfoFolder"), preferred_folder=preference("InfoFolder"),
        info_folder=preference("FolderInfoFolder"),
        profile=preference("FolderProfile") or preference("Profile"),
        jobs=preference("Jobs") if preference("FolderJobs") < 0 else preference("FolderJobs"),
        seconds=preference("FolderSeconds") or preference("Seconds"),
    )


def keep_settings(settings):
    """Keep choices for the next time. To measure everything again is asked for each time anew."""
    history = [settings.folder] + [each for each in folder_history() if each != settings.folder]
    set_preference_list("FolderHistory", history[:LONGEST_HISTORY])
    set_preference("FolderFormats", " ".join(settings.formats))
    set_preference("FolderInclude", settings.include)
    set_preference("FolderExclude", settings.exclude)
    set_preference("FolderUsesInfoFolder", int(not settings.beside))
    set_preference("FolderInfoFolder", settings.info_folder)
    # What is the same as everywhere else follows when that is changed.
    for name, value, same in (("Profile", settings.profile, ""), ("Jobs", settings.jobs, -1),
                              ("Seconds", settings.seconds, 0)):
        set_preference(f"Folder{name}", same if value == preference(name) else value)


def folder_history():
    """list of str: folders that were classified before, the last one first."""
    return preference_list("FolderHistory")
