# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of libraries with what they are compared by."""

import os
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...core.errors import ThinPartError
from ...core.file_formats import DOCUMENT, MESH, format_of
from ...core.forms.recorded_form import (
    form_of_record,
    packed_form,
    second_moments,
    third_moments,
    unpacked_form,
    unpacked_numbers,
)
from ..library.find_parts import stored_parts

_TINY = np.finfo(float).tiny


@dataclass(frozen=True)
class FormedParts:
    """All parts of some libraries whose form is known, in the order of the libraries, and of their paths.

    Attributes
    ----------
    indexes : list of LibraryIndex
    library, id : ndarray of shape (n,), int64
        Position of the index among those, and the id of the part in it.
    numbers : ndarray of shape (n, NUMBERS)
        See `unpacked_numbers`.
    volume : ndarray of shape (n,), mm3
        nan where the surface is not closed.
    sides : ndarray of shape (n, 3), mm
        Of the box, the longest first.
    standing : list of tuple
        By which the one of several that is kept is chosen, greatest first: see `_STANDING`.
    without_form : int
        Number of parts that an earlier version has measured, which cannot be compared.
    more : tuple of Form
        Those of the last parts, which are in no index: their library is -1.
    """

    indexes: list
    library: np.ndarray
    id: np.ndarray
    numbers: np.ndarray
    volume: np.ndarray
    sides: np.ndarray
    standing: list
    without_form: int
    more: tuple = ()

    def __len__(self):
        return len(self.id)

    @property
    def area(self):
        """ndarray of shape (n,), mm2."""
        return self.numbers[:, 0]

    @cached_property
    def radii(self):
        """ndarray of shape (n, 3), mm: radii of gyration of the surfaces, greatest first."""
        squares = np.linalg.eigvalsh(second_moments(self.numbers))[:, ::-1]
        return np.sqrt(np.maximum(squares, 0.0))

    @cached_property
    def proportions(self):
        """ndarray of shape (n, 6): what stays the same when a part is moved, mirrored or scaled.

        Of the radii, and of the third moments, which tell parts of one box from each other.
        """
        greatest = np.maximum(self.radii[:, 0], _TINY)
        slender = np.log(greatest / np.sqrt(np.maximum(self.area, _TINY)))
        third = third_moments(self.numbers) / greatest[:, None, None, None] ** 3
        drawn = np.einsum("nijj->ni", third)
        along = np.einsum("ni,nij,nj->n", drawn, second_moments(self.numbers), drawn) / greatest ** 2
        skew = np.column_stack([np.linalg.norm(third.reshape(-1, 27), axis=1), np.linalg.norm(drawn, axis=1),
                                np.sqrt(np.maximum(along, 0.0))])
        return np.column_stack([slender, self.radii[:, 1:] / greatest[:, None], skew / 3.0])

    def form(self, part):
        """The `Form` of a part, None where its outline is damaged."""
        if self.library[part] < 0:
            return self.more[part - len(self)]
        (outline,), = self.indexes[self.library[part]].query(
            "SELECT outline FROM distributions WHERE id = ?", (int(self.id[part]),)) or [(b"",)]
        try:
            return unpacked_form(self.numbers[part], outline)
        except ThinPartError:
            return None

    def stored(self, parts):
        """The StoredParts of some parts: dict by number."""
        found: dict = {}
        for position, index in enumerate(self.indexes):
            own = [part for part in parts if self.library[part] == position]
            by_id = {each.id: each for each in stored_parts(index, [int(self.id[part]) for part in own])}
            found.update((part, by_id[self.id[part]]) for part in own if self.id[part] in by_id)
        return found

    def alone(self, chosen):
        """Some of these parts with their forms, in no library: `FormedParts` that another process can be given.

        Parameters
        ----------
        chosen : ndarray of shape (k,), int64
        """
        nowhere = np.full(len(chosen), -1)
        return FormedParts([], nowhere, nowhere, self.numbers[chosen], self.volume[chosen], self.sides[chosen],
                           [self.standing[part] for part in chosen], 0, tuple(self.form(part) for part in chosen))

    def with_record(self, record):
        """These parts and one more, the last, of a part record that has a form."""
        numbers, _ = packed_form(record)
        measured = record["descriptors"]
        volume = measured["volume_mm3"]
        return replace(
            self, library=np.append(self.library, -1), id=np.append(self.id, -1),
            numbers=np.concatenate([self.numbers, unpacked_numbers([numbers])]),
            volume=np.append(self.volume, np.nan if volume is None else volume),
            sides=np.concatenate([self.sides, [measured["box_mm"]]]), standing=[*self.standing, ()],
            more=(*self.more, form_of_record(record)))


_STANDING = ("has_geometry", "instances", "has_notes", "is_native", "is_named", "modified")
"""What counts for the part that is kept: geometry before triangles; how often it is used, whether somebody wrote about it, a
document that can be edited before an exchanged one, a name that somebody chose, and the latest."""

_SELECT = """
    SELECT parts.id, form, volume_mm3, d1_mm, d2_mm, d3_mm, instances, notes != '' OR mesh IS NOT NULL OR link IS NOT NULL,
           name, label, document, modified, path
    FROM parts JOIN files ON files.id = parts.file JOIN distributions ON distributions.id = parts.id
    WHERE error_kind IS NULL ORDER BY files.path, parts.id
"""


def formed_parts(indexes, excluding=None):
    """The `FormedParts` of refreshed LibraryIndexes.

    Parameters
    ----------
    indexes : list of LibraryIndex
    excluding : str, optional
        Path of an info file whose parts are left out.
    """
    excluded = None if excluding is None else os.path.realpath(excluding)
    rows, without, seen = [], 0, set()
    for position, index in enumerate(indexes):
        for row in index.query(_SELECT):
            key = os.path.realpath(os.path.join(index.root, os.fsdecode(row[12]))), row[8]
            if key in seen or key[0] == excluded:  # one library lies within another
                continue
            seen.add(key)
            if row[1] is None:
                without += 1
            else:
                rows.append((position, row))
    volume = np.array([np.nan if row[2] is None else row[2] for _, row in rows], dtype=float)
    return FormedParts(
        indexes, np.array([position for position, _ in rows], dtype=np.int64),
        np.array([row[0] for _, row in rows], dtype=np.int64), unpacked_numbers([row[1] for _, row in rows]), volume,
        np.array([row[3:6] for _, row in rows], dtype=float).reshape(-1, 3), [_standing(row) for _, row in rows], without)


def _standing(row):
    instances, has_notes, name, label, document, modified = row[6:12]
    return standing(os.fsdecode(document or b""), instances, has_notes, label or name, modified)


def standing(file, instances, has_notes, name, modified):
    """What counts for a part that is there several times, as `_STANDING`: tuple, the greatest of which is kept."""
    found = format_of(file)
    kind = found and found.kind
    return kind != MESH, int(instances or 1), bool(has_notes), kind == DOCUMENT, _is_named(name or ""), modified or ""


def _is_named(label):
    """Whether a label is more than what programs call a body by themselves."""
    word = label.casefold().rstrip("0123456789_-. ()").replace(" ", "")
    return word not in _GENERIC and any(letter.isalpha() for letter in word)


_GENERIC = {"", "body", "solid", "part", "part__feature", "shape", "cut", "fusion", "common", "pad", "pocket", "compound",
            "opencascadesteptranslator", "unnamed", "import", "mesh", "component", "product", "feature"}
