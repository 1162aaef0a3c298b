"""All that is found out about an open document, as the worker tells it, and its info file."""

from ..core.criteria import profile_from
from ..core.errors import ThinPartError
from ..core.thin_faces import with_limit
from .info_file_worker import file_stamp

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
    thin_limit : dict, optional
        See `preferred_thin_limit`.

    Attributes
    ----------
    records, failures : dict
        By the name of the part.
    shown : dict
        The records as they are to be shown: with the user's own limit for what is thin, if there is one.
    maps : bool
        Whether thickness maps are wanted as well.
    """

    def __init__(self, parts, chosen, settings, profile, broken=(), thin_limit=None, maps=False):
        self.parts = parts
        self.chosen = chosen
        self.broken = broken
        self.settings = settings
        self.maps = maps
        self.profile_content = profile
        self.profile = profile_from(profile)
        self.thin_limit = thin_limit
        self.records = {}
        self.shown = {}
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
            record = line["record"]
            self.records[record["name"]] = self.shown[record["name"]] = record
            if "thin_limit_mm" in line:
                self.shown[record["name"]] = with_limit(
                    record, line["thin_limit_mm"], line["thin_shares"])
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

    def info_job(self, document, folder):
        """The job of `info_file_worker` for the document as it is on disk.

        Parameters
        ----------
        document : str
            Its file.
        folder : str
            For info files; see `info_location`.

        Returns
        -------
        dict

        Raises
        ------
        ThinPartError
            kind ``info_write`` where there is nothing to write.
        """
        if not self.records:
            raise ThinPartError("Nothing was measured that could be written.", "info_write")
        try:
            stamp = file_stamp(document)
        except OSError:
            raise ThinPartError(f"There is no file {document} any more.", "missing") from None
        names = [part.name for part in self.parts]
        return {
            "document": document, "folder": folder, "stamp": stamp,
            "settings": self.settings.content(), "profile": self.profile_content,
            "records": [self.records[name] for name in names if name in self.records],
            "failures": [self.failures[name] for name in names if name in self.failures]
            + [each.failure() for each in self.broken],
        }
