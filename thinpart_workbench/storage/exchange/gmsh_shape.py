# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which files of shapes Gmsh opens as such: it runs those with other endings, and strings of names, as scripts."""

import os

from ...core.file_formats import format_of
from ...core.foreign_text import is_gmsh_text, safe_name

OPTIONS = ".opt"
"""What Gmsh appends to the name of a file that it opens: it runs the script of that name too, if there is one."""


def gmsh_ending(path):
    """The ending with which Gmsh opens a file of a shape: ``.step``, ``.iges`` or ``.brep``."""
    return format_of(path).endings[0]


def is_opened_as_shape(path, folder):
    """Whether a script of Gmsh may open a file of a shape as it is called: bool.

    Otherwise the name is no string or no path of Gmsh, or the file would be run, or a script beside it.

    Parameters
    ----------
    path : str
        As the script says it, with ``/`` as separator.
    folder : str
        Of the script.
    """
    stem, ending = os.path.splitext(path.rpartition("/")[2])
    found = format_of(path)
    return (bool(stem) and found is not None and ending in found.gmsh_spellings and is_gmsh_text(path) and path[1:2] != ":"
            and not os.path.lexists(os.path.join(folder, path + OPTIONS)))


def stem_for_gmsh(name):
    """The beginning of the name of a copy that is made for a script, from the script's own name without its ending."""
    return name if is_gmsh_text(name) and len(name.encode()) <= 100 and name[1:2] != ":" else safe_name(name) or "part"
