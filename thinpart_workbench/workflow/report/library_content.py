# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the page of a library shows: its parts, and which of them belong together."""

from dataclasses import dataclass
from typing import Optional


@dataclass(frozen=True)
class LibraryPart:
    """A part, as the page shows it.

    Attributes
    ----------
    label : str
    file : str
        Path of the document below the library, with ``/`` between folders.
    address : str or None
        Relative URL of the document, for a link; None where there is no such file.
    picture : str or None
        Name of its picture, see `picture_address`; None where there is none.
    instances : int
    category : str
    borderline : bool
    between : tuple of str
        See `named_between`.
    thinnest_mm, median_mm : float or None
    place : str or None
        What the thinnest wall is, as `thinnest_kind` has it.
    diagonal_mm : float
    volume_ratio : float or None
        V/VBB; None where the surface is not closed.
    box_mm : tuple of float
        Sides, longest first.
    risk : float or None
        Of the automatic mesh.
    """

    label: str
    file: str
    address: Optional[str]
    picture: Optional[str]
    instances: int
    category: str
    borderline: bool
    between: tuple
    thinnest_mm: Optional[float]
    place: Optional[str]
    median_mm: Optional[float]
    diagonal_mm: float
    volume_ratio: Optional[float]
    box_mm: tuple
    risk: Optional[float]


@dataclass(frozen=True)
class LikenessGroup:
    """Parts of one form, or alike but for something, the one to keep first.

    Attributes
    ----------
    kind : str
        One of `core.reuse.likeness.KINDS`.
    parts : list of int
        Numbers of the parts.
    said : list of str
        What shows it, of each part; empty for the first.
    """

    kind: str
    parts: list
    said: list


@dataclass(frozen=True)
class PartFamily:
    """Parts whose faces are the same but for their sizes.

    Attributes
    ----------
    parts : list of int
        Numbers of the parts.
    varies : dict of list of float
        By dimension: its values in mm, in the order of the parts.
    """

    parts: list
    varies: dict


@dataclass(frozen=True)
class LibraryContent:
    """Everything on the page.

    Attributes
    ----------
    place : str
        The folders, as they were named.
    base : str
        Relative URL of the folder below which the documents lie, with ``/`` at its end.
    titles : dict of str
        Titles of the categories by their names.
    parts : list of LibraryPart
    groups : list of LikenessGroup
    families : list of PartFamily
    failures : list of FailureSummary
        Documents and parts that could not be measured.
    unclassified : list of str
        Documents without an info file, as `LibraryPart.file`.
    without_form : int
        Parts that an earlier version has measured, which are not compared.
    problems : list of str
        Folders and info files that could not be read: sentences.
    """

    place: str
    base: str
    titles: dict
    parts: list
    groups: list
    families: list
    failures: list
    unclassified: list
    without_form: int
    problems: list


def picture_address(name):
    """Relative URL of a picture by its name: a folder for each two first digits."""
    return f"pictures/{name[:2]}/{name}.png"


def numbered_lists(lists):
    """By number of a part: the numbers, from 1 on, of the lists that it is in, as dict of list of int.

    Parameters
    ----------
    lists : iterable of LikenessGroup or PartFamily
    """
    found: dict = {}
    for number, each in enumerate(lists, 1):
        for part in each.parts:
            found.setdefault(part, []).append(number)
    return found
