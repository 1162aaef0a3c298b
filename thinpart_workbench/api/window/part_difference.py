# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between a part of an open document and one of a library: a process finds it, the window draws it."""

import os

import numpy as np

from ...core.analysis_limits import Limits
from ...core.errors import ThinPartError
from ...core.forms.recorded_form import form_of_record
from ...core.message import message
from ...storage.info.stored_records import single_record
from ...workflow.reuse.comparison_task import ComparedPart
from ...workflow.reuse.difference_task import DifferenceTask, part_difference

_FILE = "difference.npz"
_SIDES = ("part", "reference")


def write_difference(snapshot, own, file, info_file, name, seconds=Limits.seconds, megabytes=Limits.megabytes,
                     control=None):
    """Find what differs between a part and one of a library, and write into the snapshot what `shown_difference` reads.

    Parameters
    ----------
    snapshot : str
        Folder of a snapshot with the part.
    own : dict
        The part's record, or ``info_file`` and ``name``, by which that is found.
    file, info_file, name : str
        Document, info file and name of the other part.
    seconds : float, optional
    megabytes : int, optional
    control : RunControl, optional

    Returns
    -------
    dict
        ``tolerance_mm``, up to which surfaces are the same; ``share`` and ``reference_share`` of the surfaces that lie
        apart, and ``greatest_mm``, how far.

    Raises
    ------
    ThinPartError
        Where the two cannot be compared.

    Examples
    --------
    >>> sorted(write_difference(snapshot, record, plate, f"{plate}.thinpart.json", record["name"]))
    ['greatest_mm', 'reference_share', 'share', 'tolerance_mm']
    """
    record = single_record(own["info_file"], own["name"]) if "info_file" in own else own
    form, other = form_of_record(record), form_of_record(single_record(info_file, name))
    if form is None or other is None:
        raise ThinPartError(message("An earlier version has measured {file}: classify it again, to compare it.",
                                    file=os.path.basename(file)), "older")
    task = DifferenceTask(snapshot, form, ComparedPart(file, "", name, other))
    found = part_difference(task, Limits(seconds, megabytes, 1), control)
    with open(os.path.join(snapshot, _FILE), "wb") as stream:
        np.savez(stream, **{f"{side}_{key}": found[side][key] for side in _SIDES
                            for key in ("corners", "normals", "is_apart", "lines")})
    return {"tolerance_mm": found["tolerance_mm"], "share": found["part"]["share"],
            "reference_share": found["reference"]["share"],
            "greatest_mm": max(found[side]["greatest_mm"] for side in _SIDES)}


def shown_difference(snapshot):
    """What `write_difference` wrote: two dicts, of the part and of the other one, in the coordinates of the part.

    ``corners`` and ``normals``, ndarray of shape (k, 3, 3), of pieces of the surface; ``is_apart``, ndarray of shape (k,),
    bool, of those that the other surface does not have; ``lines``, ndarray of shape (l, 2, 3), its edges.

    Examples
    --------
    >>> answer = write_difference(snapshot, record, plate, f"{plate}.thinpart.json", record["name"])
    >>> part, other = shown_difference(snapshot)
    >>> len(part["corners"]) == len(part["is_apart"])
    True
    """
    with open(os.path.join(snapshot, _FILE), "rb") as stream, np.load(stream, allow_pickle=False) as file:
        return tuple({key.partition("_")[2]: file[key] for key in file.files if key.startswith(f"{side}_")}
                     for side in _SIDES)
