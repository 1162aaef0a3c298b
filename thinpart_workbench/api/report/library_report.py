# SPDX-License-Identifier: LGPL-2.1-or-later
"""A page about a library: its parts, what it has more than once, families, and a map."""

import hashlib
import io
import os
from contextlib import suppress
from dataclasses import dataclass

from ...core.categories import NORMAL
from ...core.errors import ThinPartError
from ...core.file_formats import format_of
from ...core.judging.criteria import UNKNOWN, profile_from
from ...core.kinds.file_marks import PAGE, PICTURE
from ...core.length_unit import MILLIMETRE, UNITS
from ...core.message import message
from ...core.regular_file import open_regular
from ...core.run_control import RunControl, seldom
from ...storage.common_folder import common_folder
from ...storage.index.written_query import part_query
from ...storage.info.info_file import info_path
from ...storage.info.info_reading import read_info
from ...storage.output_file import write_output
from ...storage.thumbnails import thumbnail_path
from ...workflow.analysis.find_documents import find_documents
from ...workflow.report.library_content import (
    LibraryContent,
    LibraryPart,
    LikenessGroup,
    PartFamily,
    picture_address,
)
from ...workflow.report.library_page import library_page
from ...workflow.report.marked_folder import prepare_folder
from ...workflow.report.page_language import ENGLISH
from ...workflow.report.report_pages import address
from ..libraries import Libraries, duplicates, families
from .report_folder import FailureSummary

LIBRARY_PAGE = "library.html"

_LARGEST_PICTURE = 1 << 18
"""Bytes of a picture of 160 x 120 pixels that is not packed at all, and more."""


@dataclass(frozen=True)
class WrittenLibrary:
    """A page about a library that was written.

    Attributes
    ----------
    page : str
        Its path.
    parts : int
        Number of parts on it.
    unclassified : int
        Number of documents without an info file, which are not on it.
    problems : tuple of LibraryProblem
        Folders and info files that could not be read.
    """

    page: str
    parts: int
    unclassified: int
    problems: tuple


def library_report(roots, folder, *, language=ENGLISH, unit=MILLIMETRE.symbol, overwrite=False, inputs=(), control=None,
                   report=None):
    """Write a page about folders of info files, with the pictures of their parts. No document is read.

    Parameters
    ----------
    roots : list of str
        Folders with info files; see `find`.
    folder : str
        New, empty, or that of an earlier report.
    language : str, optional
        One of `LANGUAGES`.
    unit : str, optional
        Symbol of the unit of all lengths on the page.
    overwrite, inputs
        See `storage.output_file.check_output`: for each file that is written.
    control : RunControl, optional
    report : callable, optional
        See `duplicates`.

    Returns
    -------
    WrittenLibrary

    Raises
    ------
    ThinPartError
        kind ``usage`` if the folder cannot be written, contains anything but a report, or a file that must not be
        replaced; ``missing`` if none of the roots exists; ``failed`` if there is no space.
    Cancelled
        When `control` was asked to stop: pictures that were copied stay.

    Examples
    --------
    >>> written = library_report([samples], os.path.join(samples, "..", "library report"))
    >>> written.parts, os.path.basename(written.page)
    (2, 'library.html')
    """
    target, control = os.path.abspath(folder), control or RunControl()
    found, places, problems, files = _found(roots)
    # No document has ThinPart's mark: without `overwrite`, none can be replaced.
    replacing = {"overwrite": overwrite, "inputs": [*inputs, *(files if overwrite else ())]}
    prepare_folder(target, folder, {LIBRARY_PAGE: PAGE}, **replacing)
    page = os.path.join(target, LIBRARY_PAGE)
    documents = _Documents(common_folder(roots), target)
    parts = [each for each in found if not each.stored.error_kind]
    unclassified = _unclassified(files, found)
    numbers = {(part.info_file, part.name): number for number, part in enumerate(parts)}
    try:
        # What may be refused comes before what takes time.
        pictures = _Pictures(target, {"overwrite": overwrite, "inputs": inputs})
        shown = []
        for part in parts:
            control.check()
            shown.append(_part(part, documents, pictures.of(part.stored)))
        alike = duplicates(roots, reads_documents=False, control=control, report=seldom(report))
        content = LibraryContent(
            place=", ".join(places), base=documents.base or "", titles=_titles(parts), parts=shown,
            groups=list(_groups(alike, numbers)), families=list(_families(families(roots), numbers)),
            failures=[FailureSummary(documents.name(each.file), each.label, each.stored.error_kind,
                                     each.stored.error_message) for each in found if each.stored.error_kind],
            unclassified=[documents.name(file) for file in unclassified], without_form=alike.without_form,
            problems=[problem.message for problem in problems if problem.kind != "info_file"])
        write_output(page, library_page(language, UNITS[unit], content), PAGE, **replacing)
    except OSError as error:
        raise ThinPartError(
            message("The page about the library could not be written into {folder} ({problem}): make room for it, and start "
                    "again.", folder=target, problem=error.strerror), "failed") from None
    return WrittenLibrary(page, len(parts), len(unclassified), tuple(problems))


def _found(roots):
    """What the folders have: parts and failures, the folders themselves, problems, and documents."""
    with Libraries(roots) as libraries:
        if not libraries.indexes and libraries.problems:
            raise ThinPartError(libraries.problems[0].message, "missing")
        places = [index.root for index in libraries.indexes]
        found = list(libraries.find(part_query(failed=None)))
        problems = libraries.problems
    return found, places, problems, [document.path for document in find_documents(places).documents]


def _unclassified(documents, found):
    """Those documents that have no info file, be it in a folder of their own."""
    # Paths that info files name are not looked at: they may lead to another computer.
    known = {os.path.normcase(part.file) for part in found}
    return [file for file in documents if not os.path.lexists(info_path(file))
            and not known & {os.path.normcase(os.path.abspath(file)), os.path.normcase(os.path.realpath(file))}]


class _Documents:
    """Where documents lie: below the library, and as seen from the page."""

    def __init__(self, library, folder):
        self._library = os.path.realpath(library)
        below = _relative(self._library, os.path.realpath(folder))
        self.base = None if below is None else f"{address(below)}/"

    def name(self, file):
        """The path of a document below the library."""
        return (_relative(file, self._library) or file).replace(os.sep, "/")

    def address(self, file):
        """Its address on the page; None where there is no such file, or it is none that ThinPart reads."""
        below = _relative(file, self._library)
        if below is None or self.base is None or format_of(file) is None or not os.path.isfile(file):
            return None
        return self.base + address(below)


def _relative(path, folder):
    """A path as seen from a folder; None where it is on another drive or computer, on Windows."""
    try:
        return os.path.relpath(path, folder)
    except ValueError:
        return None


class _Pictures:
    """Copies thumbnails from the user's cache into the folder of the page."""

    def __init__(self, folder, replacing):
        self._folder, self._replacing = folder, replacing
        self._made: dict = {}

    def of(self, stored):
        """The name of the picture of a StoredPart, see `picture_address`; None where there is no thumbnail."""
        key = stored.sha256, stored.name
        if key not in self._made:
            self._made[key] = self._copy(*key)
        return self._made[key]

    def _copy(self, sha256, part_name):
        content = _thumbnail(sha256, part_name)
        if content is None:
            return None
        name = hashlib.sha256(f"{sha256} {part_name}".encode("utf-8", "surrogatepass")).hexdigest()[:20]
        path = os.path.join(self._folder, *picture_address(name).split("/"))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        write_output(path, content, PICTURE, durable=False, **self._replacing)
        return name


def _thumbnail(sha256, part_name):
    """The thumbnail of a part, bytes; None where there is none that ThinPart has drawn."""
    try:
        path = thumbnail_path(sha256, part_name)
        if path is None:
            return None
        with open_regular(path) as file:
            content = file.read(_LARGEST_PICTURE)
    except OSError:
        return None
    return content if PICTURE.is_in(io.BytesIO(content)) else None


def _part(part, documents, picture):
    stored = part.stored
    return LibraryPart(
        label=part.label, file=documents.name(part.file), address=documents.address(part.file), picture=picture,
        instances=part.instances, category=part.category, borderline=part.borderline, between=part.between,
        thinnest_mm=part.thinnest_mm, place=stored.thinnest_at, median_mm=stored.median_mm, diagonal_mm=stored.diagonal_mm,
        volume_ratio=stored.volume_ratio, box_mm=part.box_mm, risk=stored.risk)


def _titles(parts):
    """Titles of the categories, of the profiles by which parts were judged: dict of str by name."""
    titles: dict = {}
    for part in parts:
        if part.category not in titles and part.category not in (NORMAL, UNKNOWN):
            titles[part.category] = part.category
            with suppress(ThinPartError):
                titles.update((category.name, category.title)
                              for category in profile_from(read_info(part.info_file)["profile"]).categories)
    return titles


def _groups(alike, numbers):
    for group in alike:
        members = [(numbers.get((part.stored.info_file, part.stored.name)), part) for part in group.parts]
        members = [(number, part) for number, part in members if number is not None]  # the others have gone meanwhile
        if len(members) > 1:
            yield LikenessGroup(group.kind, [number for number, _part in members],
                            [part.evidence.get("says", "") for _number, part in members])


def _families(found, numbers):
    for family in found:
        rows = [(row, numbers[part.info_file, part.name]) for row, part in enumerate(family.parts)
                if (part.info_file, part.name) in numbers]
        if len(rows) > 1:
            yield PartFamily([number for _row, number in rows],
                             {name: [values[row] for row, _number in rows] for name, values in family.varies.items()})
