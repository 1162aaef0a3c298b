# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window says of a part that libraries have already."""

import os

from ...core.message import message
from ...core.reuse.likeness import ALIKE, IDENTICAL, MIRRORED
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
        ``sentence``, ``file`` and ``name``; None where there is none.

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
    return {"sentence": sentence, "file": found.stored.file, "name": found.stored.name}
