"""Which content of a file was measured: taken before it is read, compared before the result is used."""

import os
from pathlib import Path

from ...core.message import message
from ...storage.info.info_file import new_source, source_is_unchanged
from .analysis_outcome import failure


def source_of(file, info_file=None):
    """The ``source`` entry of a file and of those that it links to, before it is read. Runs in a worker.

    Parameters
    ----------
    file : str
    info_file : str or None, optional
        Path of the info file to be written.

    Raises
    ------
    ThinPartError
        If the file cannot be read; see `new_source`.
    """
    # Imported here since the adapter loads FreeCAD, which unchanged files do not need.
    from ...freecad_adapter.reading.linked_files import linked_files

    return new_source(file, linked_files(file), info_file)


def source_failure(source, file):
    """Why a result is not about the file as it is now.

    Parameters
    ----------
    source : dict
        From `source_of`.
    file : str

    Returns
    -------
    dict or None
        As `failure`; None where nothing has changed.
    """
    if source_is_unchanged(source, file):
        return None
    if os.path.lexists(file):
        return failure(file, "unreadable", message("{file} changed while it was read: measure it again.",
                                                   file=Path(file).name))
    return failure(file, "missing", message("The file {file} no longer exists.", file=file))
