# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of a search in libraries."""

import json
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, Optional, cast

from ..core.errors import ThinPartError
from ..core.record.record_types import PartRecord, PersonLabel, ProfileContent
from ..storage.index.stored_part import StoredPart
from ..storage.info.info_reading import read_info
from ..storage.info.stored_records import select_record
from ..storage.thumbnails import thumbnail_path
from ..workflow.library.find_parts import read_records
from .classified_parts import PartFailure


def stored_row(part: StoredPart) -> dict[str, Any]:
    """The fields of a part as the window shows them, JSON values: with ``place``, its file within the library, and where it
    may have one ``thumbnail``, the path of its picture.

    Examples
    --------
    >>> from thinpart_workbench.api.libraries import find
    >>> stored_row(find(samples, category="thin")[0].stored)["place"]
    'plate.step'
    """
    content = {**part._asdict(), "place": os.path.relpath(part.file, part.root)}
    thumbnail = thumbnail_path(part.sha256, part.name) if part.name else None
    if thumbnail is not None:
        content["thumbnail"] = os.fspath(thumbnail)
    return content


@dataclass(frozen=True)
class FoundPart:
    """A part from the search index.

    Attributes
    ----------
    stored : StoredPart
        All columns of the index: every quantity by its name, and the part's annotations.
    score : float or None
        Similarity from 100 to 0, in a search for similar parts.
    reasons : str
        Reasons for the score, in words.
    """

    stored: StoredPart = field(repr=False)
    score: Optional[float] = None
    reasons: str = ""

    def __repr__(self):
        what = f"failed: {self.stored.error_kind}" if self.stored.error_kind else self.category
        return f"<FoundPart {self.label!r} of {self.file!r}: {what}>"

    @property
    def file(self) -> str:
        """Path of the document."""
        return self.stored.file

    @property
    def info_file(self) -> str:
        """Path of the info file."""
        return self.stored.info_file

    @property
    def name(self) -> Optional[str]:
        """Unique name within the document; None for a failure of the whole document."""
        return self.stored.name

    @property
    def label(self) -> Optional[str]:
        """The label that people see."""
        return self.stored.label

    @property
    def instances(self) -> Optional[int]:
        """Number of occurrences of the part."""
        return self.stored.instances

    @property
    def category(self) -> Optional[str]:
        """A category of the profile, ``normal`` or ``unknown``; None for a failure."""
        return self.stored.category

    @property
    def criteria(self) -> tuple[str, ...]:
        """Ids of the criteria that hold."""
        return self.stored.criteria

    @property
    def borderline(self) -> bool:
        """Whether the part is near another category."""
        return self.stored.borderline

    @property
    def between(self) -> tuple[str, ...]:
        """The two categories that an unsure verdict leaves open, the likelier first; empty where it is sure."""
        return tuple((self.stored.unsure_between or "").split())

    @property
    def margin(self) -> Optional[float]:
        """Distance from another category, relative to the thresholds."""
        return self.stored.margin

    @property
    def thinnest_mm(self) -> Optional[float]:
        """The least distance between parallel walls."""
        return self.stored.thinnest_mm

    @property
    def box_mm(self) -> Optional[tuple[float, float, float]]:
        """Sides of the bounding box, longest first."""
        sides = self.stored.d1_mm, self.stored.d2_mm, self.stored.d3_mm
        return None if sides[0] is None else sides

    @property
    def volume_mm3(self) -> Optional[float]:
        """Volume; None if the surface is not watertight."""
        return self.stored.volume_mm3

    @property
    def area_mm2(self) -> Optional[float]:
        """Area of the surface."""
        return self.stored.area_mm2

    @property
    def notes(self) -> str:
        """The user's notes on the part."""
        return self.stored.notes or ""

    @property
    def mesh(self) -> Optional[dict[str, Any]]:
        """Mesh settings stored with the part."""
        return None if self.stored.mesh is None else json.loads(self.stored.mesh)

    @property
    def link(self) -> Optional[str]:
        """An address or file name stored with the part."""
        return self.stored.link

    @property
    def labels(self) -> list[PersonLabel]:
        """What people say the part is."""
        return [] if self.stored.labels is None else json.loads(self.stored.labels)

    @property
    def failure(self) -> Optional[PartFailure]:
        """Why the part could not be analysed; None if it was analysed."""
        stored = self.stored
        if not stored.error_kind:
            return None
        return PartFailure(stored.error_kind, stored.error_message, stored.name, stored.label, stored.file)

    def record(self) -> PartRecord:
        """The complete record of the part, read from its info file.

        Raises
        ------
        ThinPartError
            If the info file cannot be read or no longer holds the part, or if this is a failure.
        """
        record = self.line()
        if record is None:
            raise ThinPartError(f"The part {self.name} is no longer in {self.info_file}: search again.", "missing")
        if "error" in record:
            raise PartFailure(record["error"]["kind"], record["error"]["message"]).error()
        return cast(PartRecord, record)

    def line(self) -> Optional[dict[str, Any]]:
        """The record or the failure as one of `SearchResult.records`; None if the info file no longer holds the part."""
        return next(read_records([self.stored]), None)


@dataclass(frozen=True)
class LibraryProblem:
    """A problem that keeps a search from finding all parts.

    Attributes
    ----------
    root : str
        The folder to be searched.
    kind : str
        ``folder`` if the folder, or some below it, could not be searched; ``info_file`` if an info file cannot be
        used; ``index`` if the index cannot be stored, which only costs time.
    message : str
        One sentence.
    """

    root: str
    kind: str
    message: str


@dataclass(frozen=True)
class SearchResult(Sequence):
    """The result of a search: a sequence of `FoundPart`.

    Attributes
    ----------
    parts : list of FoundPart
    total : int
        Number of matching parts without the limit.
    problems : tuple of LibraryProblem
    """

    parts: list[FoundPart]
    total: int
    problems: tuple[LibraryProblem, ...] = ()

    def __len__(self):
        return len(self.parts)

    def __getitem__(self, index):
        return self.parts[index]

    def records(self) -> Iterator[dict]:
        """Records with ``file`` and ``info_file``, or with ``error`` for a failure, as printed by ``find --json``."""
        return read_records(part.stored for part in self.parts)


def record_and_profile(info_file, name) -> tuple[PartRecord, ProfileContent]:
    """The record of a part in an info file, by name or label, and the profile by which the part was judged.

    Raises a ThinPartError if the info file cannot be read or does not hold the part.

    Examples
    --------
    >>> found, judged_by = record_and_profile(plate + ".thinpart.json", record["name"])
    >>> found["category"], judged_by["name"]
    ('thin', 'calibrated')
    """
    content = read_info(info_file)
    return select_record(content["parts"], name, info_file), content["profile"]


class DuplicateGroups(Sequence):
    """Groups of parts: identical ones first, then mirrored, scaled, and alike ones, the largest groups first.

    Attributes
    ----------
    compared : int
        Number of parts that were compared.
    without_form : int
        Number of parts that an earlier version has measured: their documents have to be classified again first.
    failures : list of dict
        Documents that could not be read again, with ``file`` and ``error``: what is said of them comes from their records.
    problems : tuple of LibraryProblem
        Folders and info files that could not be read.
    """

    def __init__(self, found, problems):
        self._groups = found.groups
        self.compared, self.without_form, self.failures = found.compared, found.without_form, found.failures
        self.problems = problems

    def __len__(self):
        return len(self._groups)

    def __getitem__(self, number):
        return self._groups[number]

    def lines(self):
        """One dict a group, as ``duplicates --json`` prints them: ``group``, ``kind`` and ``parts``."""
        for number, group in enumerate(self._groups, 1):
            yield {"group": number, "kind": group.kind, "parts": [
                {"file": part.stored.file, "name": part.stored.name, "label": part.stored.label, "kind": part.kind,
                 "evidence": part.evidence} for part in group.parts]}


class FamilyList(Sequence):
    """Families of parts, the largest first: each with ``parts``, and ``varies``, the dimensions in which they differ."""

    def __init__(self, families, problems):
        self._families, self.problems = families, problems

    def __len__(self):
        return len(self._families)

    def __getitem__(self, number):
        return self._families[number]

    def lines(self):
        """One dict a family, as ``duplicates --families --json`` prints them; its dimensions are the evidence of a part."""
        for number, family in enumerate(self._families, 1):
            yield {"group": number, "kind": "family", "varies": list(family.varies), "parts": [
                {"file": part.file, "name": part.name, "label": part.label, "kind": "family",
                 "evidence": {name: values[row] for name, values in family.varies.items()}}
                for row, part in enumerate(family.parts)]}
