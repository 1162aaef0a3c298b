# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder that holds several files and folders."""

import os
from pathlib import Path

from ..core.errors import ThinPartError
from ..core.message import message


def common_folder(paths):
    """The innermost folder that holds all of these files and folders: the top of their tree.

    Two documents of the same name in different folders have different paths below it. Raises ThinPartError, kind ``usage``
    if there is none, on Windows.
    """
    folders = [path if os.path.isdir(path) else path.parent for path in map(Path, paths)]
    try:
        return Path(os.path.commonpath([os.path.abspath(folder) for folder in folders]))
    except ValueError:
        raise ThinPartError(message("The parts lie on several drives: name those of one drive at a time."),
                            "usage") from None
