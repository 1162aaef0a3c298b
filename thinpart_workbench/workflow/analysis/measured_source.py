# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which content of a file was measured: taken before it is read, compared before the result is used."""

import os
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.message import message
from ...storage.info.info_file import new_source, source_is_unchanged


def source_of(file, info_file=None):
    """The ``source`` entry of a file and of those that it links to, before it is read. Runs in a worker.

    Raises ThinPartError if the file cannot be read; see `new_source`.

    Parameters
    ----------
    file : str
    info_file : str or None, optional
        Path of the info file to be written.
    """
    # Imported here since the adapter loads FreeCAD, which unchanged files do not need.
    from ...freecad_adapter.reading.linked_files import linked_files

    return new_source(file, linked_files(file), info_file)


def check_source(source, file):
    """Raise a ThinPartError where a result is not about the file as it is now.

    Parameters
    ----------
    source : dict
        From `source_of`.
    file : str
    """
    if source_is_unchanged(source, file):
        return
    if os.path.lexists(file):
        raise ThinPartError(message("{file} changed while it was read: measure it again.", file=Path(file).name),
                            "unreadable")
    raise ThinPartError(message("The file {file} no longer exists.", file=file), "missing")
