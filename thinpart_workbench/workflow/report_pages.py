"""Pages of the parts of one document, written by the worker that measures it."""

import hashlib
import os
from dataclasses import dataclass
from urllib.parse import quote

from ..core.errors import ThinPartError
from ..storage.atomic_file import write_atomically
from ..storage.face_table import face_rows
from ..storage.info_file import stored_info
from ..storage.part_table import csv_text
from ..storage.png import png_bytes

PAGES = "pages"
"""Folder of the pages within that of the report."""

PICTURE_WIDTH, PICTURE_HEIGHT = 240, 160
"""Pixels of a part's picture in the overview."""

_LONGEST = 60
"""Bytes of a name from which on it is shortened; a page's name has two of them."""

_KEPT = ("notes", "mesh", "link")


@dataclass(frozen=True)
class ReportPages:
    """Where the pages of a document go; plain values, so that it can travel.

    Attributes
    ----------
    folder : str
        Of the report.
    place : str
        Path of the document below the folder that all documents share.
    info_file : str
        Where notes may be kept with its parts.
    """

    folder: str
    place: str
    info_file: str

    def page(self, part_name, ending=".html"):
        """Path of a part's page below the folder of the report, the same in every run."""
        *folders, name = [_safe(each) for each in self.place.split(os.sep)]
        return os.path.join(PAGES, *folders, f"{name}~{_safe(part_name)}{ending}")

    def picture(self, part_name):
        """Path of a part's small picture below the folder of the report."""
        return self.page(part_name, ".png")


def address(path):
    """A path below a folder as a page in that folder refers to it."""
    return quote(os.fsencode(path if os.sep == "/" else path.replace(os.sep, "/")))


def _safe(name):
    """A name that every file system takes and no other name gives."""
    kept = "".join(each if each.isascii() and (each.isalnum() or each in "._-") else "-" for each in name)
    if kept == name and len(kept) <= _LONGEST and not kept.startswith("."):
        return kept
    return f"{kept[:_LONGEST].lstrip('.')}~{hashlib.sha256(os.fsencode(name)).hexdigest()[:10]}"


class PageWriter:
    """Writes the pages of a document while its parts are measured.

    Parameters
    ----------
    pages : ReportPages
    source : dict
        Of the document, as in an info file.
    settings, profile : dict

    Attributes
    ----------
    faces : dict
        Lines for the table of faces, by the name of the part.
    """

    def __init__(self, pages, source, settings, profile):
        self._pages = pages
        self._about = {"source": source, "settings": settings, "profile": profile}
        stored = stored_info(pages.info_file) or {"parts": ()}
        self._kept = {each.get("name"): {key: each.get(key) for key in _KEPT} for each in stored["parts"]}
        self.faces = {}

    def write(self, part, measurement, record):
        """Write the page of a part.

        Raises
        ------
        ThinPartError
            kind ``failed``.
        """
        # The records of most runs are never drawn.
        from ..core.part_views import PartPictures
        from ..core.thickness_map import thickness_map
        from ..freecad_adapter.face_features import face_features
        from ..freecad_adapter.feature_history import feature_history
        from .part_page import part_page

        history = feature_history(part)
        features = face_features(part.shape, history) if history else []
        pictures = PartPictures(thickness_map(measurement), record)
        page = self._pages.page(part.name)
        overview = address(os.path.relpath("index.html", os.path.dirname(page)))
        about = {**self._about, "kept": self._kept.get(part.name, {})}
        content = part_page(record, pictures, features, about, self._pages.place, overview)
        self._write(self._pages.picture(part.name), png_bytes(pictures.small(PICTURE_WIDTH, PICTURE_HEIGHT)))
        self._write(page, content)
        self.faces[part.name] = csv_text(face_rows(self._pages.place, record, features))

    def _write(self, place, content):
        path = os.path.join(self._pages.folder, place)
        try:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            write_atomically(path, content, lasting=False)
        except OSError as error:
            raise ThinPartError(
                f"The page {path} could not be written ({error.strerror}): make room, or give another "
                "folder for the report.", "failed") from None
