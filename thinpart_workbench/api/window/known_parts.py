# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window says of a part that libraries have already."""

import os

from ...core.message import message
from ...core.reuse.likeness import ALIKE, IDENTICAL, MIRRORED
from ...storage.info.stored_records import stored_records
from ...workflow.reuse.known_part import known_part
from ..libraries import Libraries


def part_in_libraries(record, roots, info_file=None):
    """The part of libraries that is the same as another, or most like it.

    Parameters
    ----------
    record : PartRecord
    roots : list of str
        Folders of the libraries; those that cannot be reached are left out.
    info_file : str, optional
        That of the document of the part, whose parts are left out.

    Returns
    -------
    dict or None
        ``sentence``; ``kind``, one of `likeness.KINDS`; ``file``, ``info_file`` and ``name`` of the part of a library. None
        where there is none.

    Examples
    --------
    >>> part_in_libraries(record, [samples])["file"].endswith("plate.step")
    True
    """
    with Libraries(roots) as libraries:
        found = known_part(libraries.indexes, record, info_file)
    if found is None:
        return None
    file = os.path.basename(found.stored.file)
    if found.kind == IDENTICAL:
        sentence = message("Your libraries have this part: {file}.", file=file)
    elif found.kind == MIRRORED:
        sentence = message("Your libraries have its mirror image: {file}.", file=file)
    elif found.kind == ALIKE:
        sentence = message("Your libraries have one like it: {file}. {evidence}", file=file, evidence=found.evidence["says"])
    else:
        sentence = message("Your libraries have it in another size: this is {scale:.6g} times {file}.",
                           scale=found.evidence["scale"], file=file)
    return {"sentence": sentence, "kind": found.kind, "file": found.stored.file, "info_file": found.stored.info_file,
            "name": found.stored.name}


def document_in_libraries(info_file, roots):
    """What libraries have of the parts of a document: list of str, a sentence for each part that they have, or one like it.

    Parameters
    ----------
    info_file : str
        Of the document; its own parts are left out.
    roots : list of str
        See `part_in_libraries`.

    Examples
    --------
    >>> document_in_libraries(f"{plate}.thinpart.json", [samples])
    []
    """
    records = stored_records(info_file)
    known = [(record["label"], part_in_libraries(record, roots, info_file)) for record in records]
    return list(dict.fromkeys(
        each["sentence"] if len(records) == 1 else message("{part}: {sentence}", part=label, sentence=each["sentence"])
        for label, each in known if each is not None))
