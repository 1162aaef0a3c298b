# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages of the parts of a document, created by the worker that measures it."""

import hashlib
import os
import struct
from dataclasses import dataclass

from ...core.analysis_settings import RAY
from ...core.errors import ThinPartError
from ...core.foreign_text import safe_name, url_path
from ...core.kinds.file_marks import PAGE, PICTURE
from ...core.length_unit import MILLIMETRE, LengthUnit
from ...core.message import message
from ...core.regular_file import open_regular
from ...storage.info.info_file import stored_info
from ...storage.output_file import bears_mark, write_output
from .page_language import ENGLISH

PAGES = "pages"
"""Subfolder of the report for the pages."""

PICTURE_WIDTH, PICTURE_HEIGHT = 240, 160
"""Pixels of a part's picture in the overview."""

_LONGEST = 60
"""Maximum length of a name before it is shortened; the name of a page consists of two."""

_ANNOTATION_KEYS = ("notes", "mesh", "link", "labels", "region_notes", "face_limits")


@dataclass(frozen=True)
class ReportPages:
    """The paths of the pages of a document. Contains only plain values, so that it can be pickled.

    Attributes
    ----------
    folder : str
        Folder of the report.
    document : str
        Path of the document below the common folder of all documents.
    info_file : str
        Path of its info file, which may contain notes; empty where there is none.
    limits : tuple of WallLimits
        What the walls are checked against.
    shown_measure : str
        One of `SHOWN_MEASURES`: what the colours of the pictures stand for.
    language : str
        One of `LANGUAGES`.
    unit : LengthUnit
        Of all lengths on the pages; the tables beside them are in mm.
    overwrite : bool
        Whether files that ThinPart did not write may be replaced.
    """

    folder: str
    document: str
    info_file: str
    limits: tuple = ()
    shown_measure: str = RAY
    language: str = ENGLISH
    unit: LengthUnit = MILLIMETRE
    overwrite: bool = False

    def page(self, part_name, ending=".html"):
        """Path of a part's page relative to the folder of the report, the same in every run."""
        *folders, name = [_safe(name) for name in self.document.split(os.sep)]
        return os.path.join(PAGES, *folders, f"{name}~{_safe(part_name)}{ending}")

    def picture(self, part_name):
        """Path of a part's small picture relative to the folder of the report."""
        return self.page(part_name, ".png")

    def write(self, drawn, record):
        """Write the page of a part and the picture beside it; raises ThinPartError of kind ``failed``.

        Parameters
        ----------
        drawn : DrawnPart
        record : PartRecord
        """
        page, picture = (os.path.join(self.folder, each(record["name"])) for each in (self.page, self.picture))
        # Pictures of earlier versions have no mark, but the page that they belong to has one.
        of_page = bears_mark(page, PAGE) and _is_small_picture(picture)
        for path, content, mark, overwrite in ((picture, drawn.picture, PICTURE, self.overwrite or of_page),
                                               (page, drawn.page, PAGE, self.overwrite)):
            try:
                os.makedirs(os.path.dirname(path), exist_ok=True)
                write_output(path, content, mark, overwrite, durable=False)
            except OSError as error:
                raise ThinPartError(
                    message("The page {page} could not be written ({problem}): make room, or give another folder "
                            "for the report.", page=path, problem=error.strerror), "failed") from None


def _is_small_picture(path):
    """Whether a file is a picture of the size of those in the overview: bool."""
    try:
        with open_regular(path) as file:
            return file.read(24)[12:] == b"IHDR" + struct.pack(">II", PICTURE_WIDTH, PICTURE_HEIGHT)
    except OSError:
        return False


def address(path):
    """The relative URL of a path below the folder of a page."""
    return url_path(path if os.sep == "/" else path.replace(os.sep, "/"))


def _safe(name):
    """A file name that is valid on every file system, and unique for each name."""
    safe = safe_name(name, _LONGEST)
    return safe if safe == name else f"{safe}~{hashlib.sha256(os.fsencode(name)).hexdigest()[:10]}"


class PageMaker:
    """Creates the pages of a document while its parts are measured.

    Parameters
    ----------
    pages : ReportPages
    source : dict
        Source entry of the document, as in an info file.
    settings, profile : dict

    Attributes
    ----------
    faces : dict
        Lines for the table of faces, by part name.
    """

    def __init__(self, pages, source, settings, profile):
        self._pages = pages
        self._about = {"source": source, "settings": settings, "profile": profile}
        stored = (stored_info(pages.info_file) if pages.info_file else None) or {"parts": ()}
        self._annotations = {part.get("name"): {key: part.get(key) for key in _ANNOTATION_KEYS}
                             for part in stored["parts"]}
        self.faces = {}

    def limited(self, record):
        """A part record with the limits that are kept for its faces: the same where there are none."""
        limits = self._annotations.get(record["name"], {}).get("face_limits")
        return {**record, "face_limits": limits} if limits else record

    def make(self, part, measurement, record, features=None):
        """Create the page of a part and its small picture. Returns `page` and `picture` (bytes).

        Parameters
        ----------
        part : SolidPart or MeshedPart
        measurement : Measurement
        record : PartRecord
        features : list of str, optional
            The feature that made each face, where it is known; by default it is found out.
        """
        # Imported here: most runs create no pages.
        from ...core.maps.thickness_map import thickness_map
        from ...core.rendering.part_views import PartPictures
        from ...freecad_adapter.features.face_features import face_features
        from ...freecad_adapter.features.feature_history import feature_history
        from ...storage.face_table import FACES, face_rows
        from ...storage.png import png_bytes
        from .part_page import part_page

        if features is None:
            history = feature_history(part)
            features = face_features(part.shape, history) if history else []
        pictures = PartPictures(thickness_map(measurement, by=self._pages.shown_measure), record)
        page = self._pages.page(part.name)
        overview = address(os.path.relpath("index.html", os.path.dirname(page)))
        about = {**self._about, "kept": self._annotations.get(part.name, {}), "limits": self._pages.limits}
        content = part_page(self.limited(record), pictures, features, about, self._pages.document, overview,
                            self._pages.language, self._pages.unit)
        self.faces[part.name] = FACES.text(face_rows(self._pages.document, record, features))
        small = pictures.small(PICTURE_WIDTH, PICTURE_HEIGHT)
        return content, png_bytes(small.tobytes(), PICTURE_WIDTH, PICTURE_HEIGHT)
