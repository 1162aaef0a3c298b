"""The folder of a report: whose it is, its overview and its tables."""

import json
import os
import tempfile
from collections import Counter, namedtuple

from .. import __version__
from ..core.criteria import NORMAL, UNKNOWN, profile_from
from ..core.errors import ThinPartError
from ..storage.atomic_file import write_atomically
from ..storage.face_table import FACE_COLUMNS
from ..storage.part_table import csv_text, failed_row, measured_row, write_part_table
from .page_templates import check_templates, fill_in
from .report_pages import ReportPages, address

MARK = "thinpart-report.json"
"""File that tells the folder of a report from any other; it is there before the first page."""

OVERVIEW = "index.html"

PartSummary = namedtuple("PartSummary", (
    "file", "label", "instances", "category", "thinnest", "thin_share", "margin", "borderline", "box",
    "diagonal", "warnings", "page", "picture"))
FailureSummary = namedtuple("FailureSummary", "file label kind message")


class ReportFolder:
    """Collects what there is to say about all parts, a row each.

    Parameters
    ----------
    folder : str
    tree : Path
        Folder that all documents share.
    profile : dict
    info_for : callable
        From the path of a document to that of the info file with which notes may be kept.

    Raises
    ------
    ThinPartError
        kind ``usage`` where the folder cannot be written or holds something else; ``unsupported`` where pages
        cannot be filled in.
    """

    def __init__(self, folder, tree, profile, info_for):
        self.folder = os.path.abspath(folder)
        self._tree = tree
        self._profile = profile
        self._info_for = info_for
        self._parts, self._failures, self._texts = [], [], []
        self._places = []  # of the rows of each document in the file of all faces
        check_templates()
        _prepare(self.folder, folder)
        self._faces = tempfile.TemporaryFile(dir=self.folder)

    @property
    def overview(self):
        """str: path of the page to begin with."""
        return os.path.join(self.folder, OVERVIEW)

    def pages_for(self, file):
        """ReportPages of a document."""
        return ReportPages(self.folder, os.path.relpath(file, self._tree), self._info_for(file))

    def add(self, outcome):
        """Take the outcome of one document."""
        pages = self.pages_for(outcome["file"])
        place = pages.place
        errors = [outcome["error"]] if "error" in outcome else outcome["failures"]
        rows = []
        for record in outcome.get("parts", ()):
            self._parts.append(_summary(record, pages))
            rows.append(measured_row(place, record))
        for error in errors:
            self._failures.append(FailureSummary(place, error.get("label"), error["kind"], error["message"]))
            rows.append(failed_row(place, error.get("part"), error.get("label"), error))
        self._texts.append((place, csv_text(rows)))
        start = self._faces.tell()
        self._faces.write("".join(outcome.get("faces", {}).values()).encode("utf-8", "backslashreplace"))
        self._places.append((place, start, self._faces.tell() - start))

    def finish(self):
        """Write tables and overview.

        Raises
        ------
        ThinPartError
            kind ``failed`` when there is no room for them.
        """
        try:
            texts = [text for _, text in sorted(self._texts)]
            write_part_table(os.path.join(self.folder, "parts.csv"), texts)
            write_atomically(os.path.join(self.folder, "faces.csv"), self._all_faces())
            write_atomically(self.overview, self._overview_page())
        except OSError as error:
            raise ThinPartError(
                f"The overview of the report could not be written into {self.folder} ({error.strerror}): "
                "make room for it, and start again.", "failed") from None

    def close(self):
        """Remove what was only kept meanwhile."""
        self._faces.close()

    def _all_faces(self):
        pieces = [csv_text([FACE_COLUMNS]).encode()]
        for _, start, length in sorted(self._places):
            self._faces.seek(start)
            pieces.append(self._faces.read(length))
        return b"".join(pieces)

    def _overview_page(self):
        profile = profile_from(self._profile)
        names = [each.name for each in profile.categories] + [NORMAL, UNKNOWN]
        count = Counter(part.category for part in self._parts)
        return fill_in(
            "index.html", software=__version__, tree=os.fspath(self._tree), profile=self._profile,
            titles={each.name: each.title for each in profile.categories},
            counts={"parts": len(self._parts),
                    "categories": [(name, count[name]) for name in names if count[name]]},
            rows=sorted(self._parts, key=lambda each: (each.file, each.page)),
            failures=sorted(self._failures, key=lambda each: each.file),
        )


def _summary(record, pages):
    measured = record["descriptors"]
    thin = sum(face["area_mm2"] * face["thin_share"] for face in record["faces"])
    return PartSummary(
        pages.place, record["label"], record["instances"], record["category"],
        measured["thickness_mm"]["min"], thin / measured["area_mm2"], record["margin"], record["borderline"],
        tuple(measured["box_mm"]), measured["diagonal_mm"], len(record["warnings"]), address(pages.page(record["name"])),
        address(pages.picture(record["name"])),
    )


def _prepare(path, named):
    """Make the folder, or take that of an earlier report."""
    try:
        os.makedirs(path, exist_ok=True)
        there = os.listdir(path)
        if there and MARK not in there:
            raise ThinPartError(
                f"{named} is there already and holds something else than a report: it was left as it is; "
                "give a new or an empty folder.", "usage")
        mark = {"format": "thinpart-report", "version": 1, "software": __version__}
        write_atomically(os.path.join(path, MARK), json.dumps(mark).encode() + b"\n")
    except FileExistsError:
        raise _refused(named, "it is a file") from None
    except OSError as error:
        raise _refused(named, error.strerror) from None


def _refused(named, why):
    return ThinPartError(f"No report can be written into {named} ({why}): give another folder.", "usage")
