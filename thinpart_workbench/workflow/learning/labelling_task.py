# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a document that are to be labelled by a program. Most of it runs in a worker process."""

import os
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.kinds.compound_kinds import ListOf, Record
from ...core.kinds.value_kinds import OrNull, Text
from ...core.message import message
from .automatic_labels import Labelling


@dataclass(frozen=True)
class LabellingTask:
    """The parts of one document that are to be labelled.

    Attributes
    ----------
    file : str
        Its path.
    source : dict
        Of its info file.
    diagonals : dict of str to float
        Diagonal of the box by part name, mm.
    labelling : Labelling
    """

    file: str
    source: Mapping
    diagonals: dict
    labelling: Labelling


def measure_document(task):
    """What a program makes of the parts of a document: list of dict.

    Each has ``part``, ``failure`` (str; why the part cannot be given to the program) and ``measured``, see `Labelling`, None
    where that failed. Raises ThinPartError if the document cannot be read.
    """
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.reading.part_files import read_parts

    parts = {part.name: part for part in read_parts(task.file).parts}
    return [_measured(parts.get(name), name, diagonal, task.labelling) for name, diagonal in task.diagonals.items()]


def _measured(part, name, diagonal, labelling):
    failure, measured = "", None
    with tempfile.TemporaryDirectory(prefix="thinpart-label-") as folder:
        shape = os.path.join(folder, "part.brep")
        if part is None:
            failure = message("The document has no such part any more: classify it again.")
        else:
            try:
                part.write_brep(shape)
            except ThinPartError as error:
                failure = str(error)
            else:
                measured = labelling.measured(shape, diagonal, folder)
    return {"part": name, "failure": failure, "measured": measured}


def answer_fault(answer, task):
    """Why an answer of a worker is none to a task, in a few words; None if it is one."""
    kind = ListOf(Record({"part": Text(), "failure": Text(), "measured": OrNull(Record(task.labelling.kinds))}),
                  most=1_000_000, distinct="part")
    fault = kind.fault(answer, "")
    if fault:
        return fault
    if [each["part"] for each in answer] != list(task.diagonals):
        return message("its parts are not those of {file}", file=Path(task.file).name)
    if any((each["measured"] is None) == (not each["failure"]) for each in answer):
        return message("a part of {file} is neither measured nor refused", file=Path(task.file).name)
    return None
