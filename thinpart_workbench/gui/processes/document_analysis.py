# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis of an open document from the messages of the worker, and its info file."""

from ...api.document_info import file_stamp
from ...api.window.walls import shown_record
from ...core.errors import ThinPartError
from ...core.judging.criteria import profile_from
from ..application.qt import translate

_MEASURING_SHARE = 0.3
"""Share of the work on a part before its thickness map is made, which takes two thirds of the time on most parts."""


class DocumentAnalysis:
    """The parts of a document and their results.

    Parameters
    ----------
    parts : list of SolidPart or MeshedPart
        In the order of the document.
    first_part : SolidPart or MeshedPart
        The part that is measured first.
    settings : AnalysisSettings
    profile : dict
        Content of a profile.
    broken : list of BrokenPart, optional
        Objects that cannot be read as parts: they are failures in the info file.
    thin_limit : dict, optional
        See `preferred_thin_limit`.

    Attributes
    ----------
    records, failures : dict
        By part name.
    shown_records : dict
        The records for display: with the user's own limit for thin faces, if there is one.
    maps : str or None
        One of `SHOWN_MEASURES` where thickness maps are made as well.
    first_maps : bool
        Whether coarse maps are made before.
    """

    def __init__(self, parts, first_part, settings, profile, broken=(), thin_limit=None, maps=None, first_maps=False):
        self.parts = parts
        self.first_part = first_part
        self.broken = broken
        self.settings = settings
        self.maps, self.first_maps = maps, first_maps
        self.profile_content = profile
        self.profile = profile_from(profile)
        self.thin_limit = thin_limit
        self.records = {}
        self.shown_records = {}
        self.failures = {}

    @property
    def measuring_order(self):
        """list: the parts in the order in which they are measured, `first_part` first."""
        return [self.first_part] + [part for part in self.parts if part is not self.first_part]

    @property
    def is_complete(self):
        """Whether every part was measured or has failed."""
        return len(self.records) + len(self.failures) == len(self.parts)

    def on_message(self, response):
        """Store a message of the worker; returns its kind.

        It is ``record``, ``failure``, ``map``, ``first_map``, ``progress`` or ``done``.
        """
        if "record" in response:
            record = response["record"]
            self.records[record["name"]] = self.shown_records[record["name"]] = record
            if "thin_limit_mm" in response:
                self.shown_records[record["name"]] = shown_record(
                    record, response["thin_limit_mm"], response["thin_shares"])
        elif "failure" in response:
            self.failures[response["failure"]["part"]] = response["failure"]
        return next(iter(response))

    def set_labels(self, name, labels):
        """Set what people say of a part that was measured."""
        for records in (self.records, self.shown_records):
            if name in records:
                records[name]["labels"] = labels

    def share_done(self, progress):
        """The completed fraction of the total work, by ``part``, ``stage`` and ``fraction`` from the worker: dict."""
        position = [part.name for part in self.measuring_order].index(progress["part"])
        # Measuring takes most of the time; tessellation before it does not report a fraction.
        measured = _MEASURING_SHARE if self.maps else 1.0
        begin, end = {"measure": (0.0, measured), "map": (measured, 1.0)}.get(progress["stage"], (0.0, 0.0))
        return (position + begin + (end - begin) * progress["fraction"]) / len(self.parts)

    def info_file_content(self, document):
        """The arguments of `write_document_info`, dict, for the current file of the document: its path.

        Raises
        ------
        ThinPartError
            kind ``info_write`` if there is nothing to write.
        """
        if not self.records:
            raise ThinPartError(translate("ThinPart", "No part was measured, so no info file was written."), "info_write")
        try:
            stamp = file_stamp(document)
        except OSError:
            raise ThinPartError(
                translate("ThinPart", "The file {} no longer exists.").format(document), "missing") from None
        names = [part.name for part in self.parts]
        return {
            "document": document, "stamp": stamp,
            "settings": self.settings.content(), "profile": self.profile_content,
            "records": [self.records[name] for name in names if name in self.records],
            "failures": [self.failures[name] for name in names if name in self.failures]
            + [part.failure() for part in self.broken],
        }
