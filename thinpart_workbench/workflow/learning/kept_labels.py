# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels that people keep in the info files of a library."""

import json
import os

from ...core.message import message
from ...storage.index.library_index import LibraryIndex
from ...storage.index.part_query import PartQuery
from ...storage.info.info_file import SUFFIX
from ...storage.labels_file import Label, refused_label
from ..library.find_parts import find_parts


def kept_labels(library, categories, report=None):
    """The labels of a library, found by its index: list of Label.

    Raises ThinPartError if the folder cannot be reached, or a label is of another category.

    Parameters
    ----------
    library : str or Path
    categories : sequence of str
        Those that may be given.
    report : callable, optional
        Called with the numbers of info files read and to be read; may raise to stop.
    """
    with LibraryIndex(library) as index:
        index.refresh(report)
        return [_label(part, label, index.root, categories) for part in find_parts(index, PartQuery(labelled=True))
                for label in json.loads(part.labels)]


def _label(part, label, root, categories):
    info_file = os.path.relpath(part.info_file, root)
    place = message("{file}, part {part}", file=info_file, part=part.name)
    if label["category"] not in categories:
        raise refused_label(place, message(
            "{person} calls it {category!r}, which is no category of the start: there are {known}",
            person=label["person"], category=label["category"], known=", ".join(categories)))
    file = info_file[:-len(SUFFIX)].replace(os.sep, "/")
    return Label(place, file, part.name, label["category"], "", label["sure"], label["person"], None, True)
