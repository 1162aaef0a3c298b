# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a report, with its marker file, overview and tables; and a report about an open document."""

import os
import tempfile
from collections import Counter, namedtuple

from ...core.analysis_settings import RAY
from ...core.errors import ThinPartError
from ...core.foreign_text import csv_form
from ...core.judging.criteria import NORMAL, UNKNOWN, profile_from
from ...core.judging.wall_check import check_walls
from ...core.kinds.file_marks import PAGE, TABLE
from ...core.length_unit import MILLIMETRE, UNITS
from ...core.message import message
from ...core.record.thinnest_sentence import thinnest_kind
from ...core.record.verdict_chances import named_between
from ...freecad_adapter.reading.linked_files import linked_files
from ...storage.face_table import FACES
from ...storage.info.info_file import new_source
from ...storage.info.info_location import call_in_folder, info_location
from ...storage.output_file import write_output
from ...storage.part_table import checked_row, failed_row, part_table, write_table
from ...storage.user_limits import limits_named
from ...workflow.report import page_language
from ...workflow.report.marked_folder import prepare_folder
from ...workflow.report.overview_page import overview_page
from ...workflow.report.page_language import ENGLISH
from ...workflow.report.report_pages import PageMaker, ReportPages, address

OVERVIEW = "index.html"

_FILES = {OVERVIEW: PAGE, "parts.csv": TABLE, "faces.csv": TABLE}
"""Files of a report beside its pages, and their marks."""

LANGUAGES = page_language.LANGUAGES
"""Of pages: codes, English first."""

PartSummary = namedtuple("PartSummary", (
    "file", "label", "instances", "category", "between", "thinnest", "place", "thin_share", "margin", "borderline",
    "box", "diagonal", "warnings", "page", "picture", "checks"))
FailureSummary = namedtuple("FailureSummary", "file label kind message")
_Drawn = namedtuple("_Drawn", "page picture")


class ReportFolder:
    """Collects a row per part for the overview and the tables.

    Parameters
    ----------
    folder : str
    tree : Path
        Common folder of all documents.
    profile : dict
    info_for : callable
        Maps the path of a document to that of its info file, which may contain notes.
    limits : tuple of WallLimits, optional
        What the walls are checked against.
    shown_measure : str, optional
        One of `SHOWN_MEASURES`: what the colours of the pictures stand for.
    subject : str, optional
        What the overview names as the place of the documents; by default their common folder.
    language : str, optional
        Of the pages: one of `LANGUAGES`.
    unit : LengthUnit, optional
        Of all lengths on the pages; tables are in mm.
    overwrite, inputs
        See `storage.output_file.check_output`: for each file of the report. A folder that holds anything but a report is
        only taken with `overwrite`.

    Raises
    ------
    ThinPartError
        kind ``usage`` if the folder cannot be written, contains anything but a report, or a file that must not be
        replaced.
    """

    def __init__(self, folder, tree, profile, info_for, limits=(), shown_measure=RAY, subject=None,
                 language=ENGLISH, unit=MILLIMETRE, overwrite=False, inputs=()):
        self.folder = os.path.abspath(folder)
        self._tree = tree
        self._subject = os.fspath(tree) if subject is None else subject
        self._profile, self._limits = profile, limits
        self._form = part_table(each.name for each in limits)
        self._info_for = info_for
        self._shown_measure, self._language, self._unit = shown_measure, language, unit
        self._parts, self._failures, self._part_blocks = [], [], []
        self._face_blocks = []  # (document, start, length) of its rows in the temporary file
        self._replacing = {"overwrite": overwrite, "inputs": inputs}
        prepare_folder(self.folder, folder, _FILES, **self._replacing)
        self._faces = tempfile.TemporaryFile(dir=self.folder)

    @property
    def overview(self):
        """str: path of the overview page."""
        return os.path.join(self.folder, OVERVIEW)

    def pages_for(self, file):
        """ReportPages of a document."""
        return ReportPages(self.folder, os.path.relpath(file, self._tree), self._info_for(file),
                           self._limits, self._shown_measure, self._language, self._unit, self._replacing["overwrite"])

    def add(self, outcome):
        """Add the outcome of one document."""
        pages = self.pages_for(outcome["file"])
        document = pages.document
        errors = [outcome["error"]] if "error" in outcome else outcome["failures"]
        rows = []
        for record in outcome.get("parts", ()):
            checks = [check_walls(record, limits).content() for limits in self._limits]
            self._parts.append(_summary(record, pages, checks))
            rows.append(checked_row(document, {**record, "checks": checks}))
        for error in errors:
            self._failures.append(FailureSummary(document, error.get("label"), error["kind"], error["message"]))
            rows.append(failed_row(document, error.get("part"), error.get("label"), error))
        self._part_blocks.append((document, self._form.text(rows)))
        start = self._faces.tell()
        # Lines from a worker, which a file may control.
        self._faces.write(csv_form("".join(outcome.get("faces", {}).values())).encode())
        self._face_blocks.append((document, start, self._faces.tell() - start))

    def finish(self):
        """Write tables and overview.

        Raises
        ------
        ThinPartError
            kind ``failed`` if there is no space for them.
        """
        try:
            blocks = [text for _, text in sorted(self._part_blocks)]
            write_table(os.path.join(self.folder, "parts.csv"), self._form, blocks, **self._replacing)
            write_table(os.path.join(self.folder, "faces.csv"), FACES, self._all_faces(), **self._replacing)
            write_output(self.overview, self._overview_page(), PAGE, **self._replacing)
        except OSError as error:
            raise ThinPartError(
                message("The overview of the report could not be written into {folder} ({problem}): make room for "
                        "it, and start again.", folder=self.folder, problem=error.strerror), "failed") from None

    def close(self):
        """Remove the temporary file."""
        self._faces.close()

    def _all_faces(self):
        for _, start, length in sorted(self._face_blocks):
            self._faces.seek(start)
            yield self._faces.read(length).decode()

    def _overview_page(self):
        profile = profile_from(self._profile)
        names = [category.name for category in profile.categories] + [NORMAL, UNKNOWN]
        count = Counter(part.category for part in self._parts)
        return overview_page(
            self._language, self._unit, self._subject, self._profile,
            {category.name: category.title for category in profile.categories},
            [(name, count[name]) for name in names if count[name]], self._limits,
            sorted(self._parts, key=lambda part: (part.file, part.page)),
            sorted(self._failures, key=lambda failure: failure.file))


class OpenDocumentReport:
    """Writes a report about an open document, saved or not, while its snapshot is measured.

    Parameters
    ----------
    settings, profile : dict
        Those of the snapshot.
    output : str
        Absolute path of the report's folder.
    document : str
        Absolute path of the document's file; empty where it has none.
    label : str
        Name of the document for people.
    is_saved : bool
        Whether the file has what is measured. Otherwise the pages say that it is not saved.
    info_folder : str
        See `info_location`: notes are taken from the info file there.
    checks : str
        Names of processes with commas between them, against whose limits the walls are checked.
    failures : list of dict
        Objects that cannot be read as parts.
    language : str, optional
        Of the pages: one of `LANGUAGES`.
    unit : str, optional
        Symbol of the unit of all lengths on the pages; tables are in mm.

    Raises
    ------
    ThinPartError
        As `ReportFolder`, and where the folder of info files does not answer.
    """

    def __init__(self, settings, profile, output, document, label, is_saved, info_folder, checks, failures,
                 language=ENGLISH, unit=MILLIMETRE.symbol):
        self._file = document or os.path.join(os.path.dirname(output), label.replace(os.sep, "_"))
        self._outcome = {"file": self._file, "parts": [], "failures": list(failures), "faces": {}}
        info_file = os.fspath(info_location(document, info_folder)) if document else ""
        self._folder = ReportFolder(
            output, os.path.dirname(self._file), profile, lambda _: info_file,
            limits_named(checks.split(","), None) if checks.strip() else (), RAY,
            subject=os.path.dirname(document) if document else "", language=language, unit=UNITS[unit])
        self._pages = self._folder.pages_for(self._file)
        source = new_source(document, linked_files(document), info_file) if is_saved else {"file": document or label}
        self._maker = call_in_folder(info_folder, lambda: PageMaker(self._pages, source, settings, profile))

    def add(self, part, measurement, record, features):
        """Write the page of a part that was measured.

        Parameters
        ----------
        part : SolidPart or MeshedPart
        measurement : Measurement
        record : PartRecord
        features : list of str
            The feature that made each face; may be empty.
        """
        self._pages.write(_Drawn(*self._maker.make(part, measurement, record, features)), record)
        self._outcome["parts"].append(self._maker.limited(record))

    def add_failure(self, failure):
        """Add a part that could not be measured: PartFailure."""
        # A part whose page could not be written is a failure alone.
        self._outcome["failures"].append({
            "part": failure.part, "label": failure.label, "kind": failure.kind, "message": failure.message})

    def finish(self):
        """Write the overview and the tables."""
        self._folder.add({**self._outcome, "faces": self._maker.faces})
        self._folder.finish()

    def close(self):
        """Remove the temporary file."""
        self._folder.close()


def _summary(record, pages, checks):
    measured = record["descriptors"]
    thin = sum(face["area_mm2"] * face["thin_share"] for face in record["faces"])
    return PartSummary(
        pages.document, record["label"], record["instances"], record["category"], named_between(record),
        measured["thickness_mm"]["min"], thinnest_kind(record), thin / measured["area_mm2"],
        record["margin"], record["borderline"], tuple(measured["box_mm"]), measured["diagonal_mm"], len(record["warnings"]),
        address(pages.page(record["name"])), address(pages.picture(record["name"])), checks,
    )
