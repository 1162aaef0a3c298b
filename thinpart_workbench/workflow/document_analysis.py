"""All that is found out about an open document, as the worker tells it, and its info file."""

from ..core.criteria import profile_from
from ..core.errors import ThinPartError
from ..freecad_adapter.linked_files import linked_files
from ..storage.info_file import info_content, info_path, new_source, write_info

_MEASURED = 0.8
"""Share of the work on a part that is done before its map is made."""


class DocumentAnalysis:
    """The parts of a document, one of them in the foreground, and what was measured on them.

    Parameters
    ----------
    parts : list of SolidPart or MeshedPart
        In the order of the document.
    chosen : SolidPart or MeshedPart
        The one that is measured first.
    settings : AnalysisSettings
    profile : dict
        Content of a profile.
    broken : list of BrokenPart, optional
        What is no part although it should be one: it is told in the info file.

    Attributes
    ----------
    records, failures : dict
        By the name of the part.
    maps : bool
        Whether thickness maps are wanted as well.
    """

    def __init__(self, parts, chosen, settings, profile, broken=(), maps=False):
        self.parts = parts
        self.chosen = chosen
        self.broken = broken
        self.settings = settings
        self.maps = maps
        self.profile_content = profile
        self.profile = profile_from(profile)
        self.records = {}
        self.failures = {}

    @property
    def in_turn(self):
        """list: the parts in the order in which they are measured, the chosen one first."""
        return [self.chosen] + [part for part in self.parts if part is not self.chosen]

    @property
    def is_complete(self):
        """Whether every part was measured or failed to be."""
        return len(self.records) + len(self.failures) == len(self.parts)

    def take(self, line):
        """Keep what a line of the worker tells.

        Returns
        -------
        str
            Key of what came: ``record``, ``failure``, ``map``, ``progress`` or ``done``.
        """
        if "record" in line:
            self.records[line["record"]["name"]] = line["record"]
        elif "failure" in line:
            self.failures[line["failure"]["part"]] = line["failure"]
        return next(iter(line))

    def share_done(self, progress):
        """Fraction of the whole work that is done.

        Parameters
        ----------
        progress : dict
            ``part``, ``stage``, ``fraction`` as the worker tells them.
        """
        turn = [part.name for part in self.in_turn].index(progress["part"])
        # Measuring takes most of the time; the tessellation before it has no fraction of its own.
        measured = _MEASURED if self.maps else 1.0
        begin, end = {"measure": (0.0, measured), "map": (measured, 1.0)}.get(progress["stage"], (0.0, 0.0))
        return (turn + begin + (end - begin) * progress["fraction"]) / len(self.parts)

    def write_info_file(self, document_file):
        """Write the info file of the document as it is on disk.

        Parameters
        ----------
        document_file : str

        Returns
        -------
        Path
            Of the info file.

        Raises
        ------
        ThinPartError
            kind ``info_write``, or as `new_source`.
        """
        if not self.records:
            raise ThinPartError("Nothing was measured that could be written.", "info_write")
        path = info_path(document_file)
        names = [part.name for part in self.parts]
        content = info_content(
            new_source(document_file, linked_files(document_file)),
            self.settings.content(), self.profile_content,
            [self.records[name] for name in names if name in self.records],
            [self.failures[name] for name in names if name in self.failures]
            + [each.failure() for each in self.broken],
        )
        write_info(path, content)
        return path
