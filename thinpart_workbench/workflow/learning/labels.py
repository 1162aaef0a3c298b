# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels of several people, brought together with the parts that they are about."""

import os
from collections import defaultdict
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple, Optional

from ...core.categories import NORMAL
from ...core.descriptors.descriptor_table import Descriptors
from ...core.errors import ThinPartError
from ...core.foreign_text import csv_form
from ...core.message import message
from ...core.record.part_record import descriptors_of
from ...storage.info.info_file import SUFFIX, read_info
from ...storage.info.info_tree import scan
from ...storage.labels_file import refused_label
from .validation import CountedShare, share_of

UNSURE = 0.5
"""Weight of an answer that its giver is not sure of."""

SECOND_ANSWER = 0.5
"""What a second answer counts, beside the first."""


class LabelledPart(NamedTuple):
    """A part and what people say of it.

    Attributes
    ----------
    file, part : str
        Path of the document below the library; name of the part.
    group : str
        What is left out together.
    category : str
        What most say; where as many say another, the first of the profile.
    second : str or None
        A second answer that is right too.
    is_sure : bool
        Whether all say the same and somebody is sure of it.
    answers : dict of str to str
        The category by person.
    descriptors : Descriptors
    labels : tuple of Label
        What is merged, one by person, with the names of file and part as here.
    """

    file: str
    part: str
    group: str
    category: str
    second: Optional[str]
    is_sure: bool
    answers: dict
    descriptors: Descriptors
    labels: tuple

    @property
    def weight(self):
        """float: what the part counts when thresholds are chosen."""
        return 1.0 if self.is_sure else UNSURE


@dataclass(frozen=True)
class Disagreement:
    """How often people who labelled the same part gave different answers.

    Attributes
    ----------
    pairs : CountedShare
        Of two answers to the same part: how many differ.
    parts : tuple of dict
        Those with different answers: ``file``, ``part``, and ``answers`` by person.
    """

    pairs: CountedShare
    parts: tuple


def categories_of(profile):
    """Names of the categories that a part may be labelled with: list of str, normal last."""
    return [*(category.name for category in profile.categories), NORMAL]


def labelled_parts(library, labels, categories):
    """Find the parts of labels in a library, and merge what several people say: list of LabelledPart.

    Raises ThinPartError where a row is about no part of the library, or repeats or contradicts another row.

    Parameters
    ----------
    library : str or Path
        Folder with info files.
    labels : list of Label
    categories : sequence of str
        In the order of the profile.
    """
    documents = info_files(library)
    contents: dict = {}
    rows: dict = {}
    for label in labels:
        document = _document(label, documents, library)
        if document not in contents:
            contents[document] = read_info(os.path.join(library, os.fsdecode(documents[document])))
        record = _record(label, contents[document]["parts"], document)
        people = rows.setdefault((document, record["name"]), {})
        earlier = people.setdefault(label.person, label)
        if earlier is label:
            continue
        if not (label.is_kept or earlier.is_kept) or not label.answers_as(earlier):
            raise refused_label(label.place, _repeated(label, earlier))
        if earlier.is_kept:
            people[label.person] = label  # the table may say more: a second answer, a group
    parts = []
    for (document, name), people in rows.items():
        record = next(each for each in contents[document]["parts"] if each["name"] == name)
        parts.append(_merged(document, name, list(people.values()), categories, descriptors_of(record)))
    return parts


def disagreement(parts):
    """How far people agree who labelled the same parts: Disagreement."""
    pairs = [one != other for part in parts for one, other in combinations(part.answers.values(), 2)]
    different = tuple({"file": part.file, "part": part.part, "answers": part.answers}
                      for part in parts if len(set(part.answers.values())) > 1)
    return Disagreement(share_of(pairs), different)


def check_library(library):
    """Raise a ThinPartError of kind ``missing`` where there is no such folder."""
    if not os.path.isdir(library):
        raise ThinPartError(message("There is no folder {folder}: name the one with the info files.",
                                    folder=os.fspath(library)), "missing")


def info_files(library):
    """Info files by the path of their document, both below the library, with slashes."""
    check_library(library)
    found, unreachable = scan(library)
    for folder, error in unreachable.items():
        raise ThinPartError(message("The folder {folder} cannot be listed ({problem}): make it readable, or move it away.",
                                    folder=os.path.join(library, os.fsdecode(folder)), problem=error.strerror), "usage")
    if not found:
        raise ThinPartError(message("There are no info files (*{ending}) in {paths}: classify the parts first.",
                                    ending=SUFFIX, paths=library), "empty")
    return {os.fsdecode(name)[:-len(SUFFIX)].replace(os.sep, "/"): name for name in found}


def _document(label, documents, library):
    named = label.file
    if os.path.isabs(named):
        named = os.path.relpath(named, os.path.abspath(library))
    path = os.path.normpath(named).replace(os.sep, "/")
    if path in documents:
        return path
    forms = {document: csv_form(document) for document in documents}
    same = ([document for document, form in forms.items() if path == form]
            or [each for each, form in forms.items() if path in (each.rpartition("/")[2], form.rpartition("/")[2])])
    if len(same) > 1:
        raise refused_label(label.place, message("{count} documents of the library are called {file!r}: write the path",
                                                 count=len(same), file=label.file))
    if not same:
        raise refused_label(label.place, message("there is no info file of {file!r} in {library}: classify it first, "
                                                 "write its path as it is below that folder, or take the row out",
                                                 file=label.file, library=os.fspath(library)))
    return same[0]


def _record(label, records, document):
    if not label.part:
        matching = records
    else:
        matching = ([record for record in records if label.part in (record["name"], csv_form(record["name"]))]
                    or [record for record in records if label.part in (record["label"], csv_form(record["label"]))])
    if len(matching) == 1:
        return matching[0]
    names = ", ".join(record["name"] for record in records)
    if matching:
        raise refused_label(label.place, message("{file} holds {count} parts: name one in the column part: {parts}",
                                                 file=document, count=len(matching), parts=names))
    raise refused_label(label.place, message("{file} has no part {part!r}: it has {parts}",
                                             file=document, part=label.part, parts=names))


def _repeated(label, earlier):
    if label.answers_as(earlier) and label.second == earlier.second:
        return message("{person} has labelled this part already ({earlier})", person=label.person, earlier=earlier.place)
    if label.category == earlier.category:
        return message("{person} is sure of {category} in one place and not in the other ({earlier})", person=label.person,
                       category=label.category, earlier=earlier.place)
    return message("{person} calls this part {category} here and {other} before ({earlier})", person=label.person,
                   category=label.category, other=earlier.category, earlier=earlier.place)


def _merged(document, name, labels, categories, descriptors):
    votes: defaultdict[str, float] = defaultdict(float)
    for label in labels:
        weight = 1.0 if label.is_sure else UNSURE
        votes[label.category] += weight
        if label.second:
            votes[label.second] += SECOND_ANSWER * weight
    ranked = sorted(votes, key=lambda category: (-votes[category], categories.index(category)))
    answers = {label.person: label.category for label in sorted(labels, key=lambda label: label.person)}
    agreed = len(set(answers.values())) == 1
    group = next((label.group for label in labels if label.group), None)
    return LabelledPart(document, name, group or (document.partition("/")[0] if "/" in document else ""),
                        ranked[0], ranked[1] if len(ranked) > 1 else None,
                        agreed and any(label.is_sure for label in labels), answers, descriptors,
                        tuple(label._replace(file=document, part=name) for label in labels))
