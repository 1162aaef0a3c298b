# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links of a document to pipes, devices and sockets. FreeCAD opens whatever has the name, and waits there for ever."""

import os

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.regular_file import is_special
from ..bootstrap import load_freecad
from .linked_files import linked_files

_MOST_NAMED = 5


def special_links(document):
    """Files that the document at a path links to, directly or through others, and that must not be opened: list of Path."""
    return [file for file in linked_files(document) if is_special(file)]


def check_links(document):
    """Reject a file if opening it would open a pipe, a device or a socket; raises ThinPartError of kind ``unsafe``."""
    found = special_links(document)
    if found:
        raise ThinPartError(message("{file} was not opened: it links to {links}, which is a pipe, a device or a socket, and "
                                    "FreeCAD would wait there for ever. Get it from a source that you trust.",
                                    file=os.path.basename(document), links=_names(found)), "unsafe")


def keep_closed(files):
    """Keep FreeCAD from opening what `special_links` found for the links to it: to each leads a link as to a missing file.

    FreeCAD opens no document twice. So an empty one, which is closed with the others at the end of a task, is said to be
    that file.
    """
    freecad = load_freecad()
    for file in files:
        try:
            name = os.fspath(file)
            name.encode()
        except UnicodeEncodeError:
            continue  # FreeCAD finds no file of such a name
        freecad.newDocument("Closed", "Closed", True, True).FileName = name


def closed_links_warning(files):
    """The sentence about links that were not followed; empty if there are none."""
    return message("The document links to {links}, which is a pipe, a device or a socket: it was not opened, and what is "
                   "linked to is missing.", links=_names(files)) if files else ""


def _names(files):
    named = ", ".join(file.name for file in files[:_MOST_NAMED])
    return named + (", ..." if len(files) > _MOST_NAMED else "")
