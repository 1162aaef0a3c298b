# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of the info file of an open document: beside it, or in a folder that may be unreachable."""

import os
import queue
import threading

from ...core.errors import ThinPartError
from ...core.message import message
from .info_file import info_path

PATIENCE = 15.0
"""Seconds after which a folder on a network share counts as unreachable."""


def info_location(document, folder=""):
    """The path of a document's info file: Path.

    Parameters
    ----------
    document : str
        Absolute path.
    folder : str, optional
        Mirrors the tree of all documents from the root of the file system, so that documents of the same
        name do not share an info file; empty for the document's own folder.
    """
    return info_path(document, folder or None, os.sep)


def call_in_folder(folder, call, patience=PATIENCE):
    """Call a function that accesses the folder for info files, with a time limit, and get its result.

    Raises ThinPartError, kind ``info_write`` if the folder is missing or does not respond; exceptions of `call` pass
    through.

    Parameters
    ----------
    folder : str
        Empty for the document's own folder.
    call : callable
        Called without arguments. After the time limit it keeps running, in a thread that ends with the process.
    patience : float
        Seconds.
    """
    results: queue.SimpleQueue = queue.SimpleQueue()

    def run():
        try:
            if folder:
                _check_folder(folder)
            results.put((call(), None))
        except Exception as error:  # raised again in the calling thread
            results.put((None, error))

    threading.Thread(target=run, daemon=True).start()
    try:
        result, error = results.get(timeout=patience)
    except queue.Empty:
        raise ThinPartError(not_answered(folder, patience), "info_write") from None
    if error is not None:
        raise error
    return result


def not_answered(folder, seconds):
    """Message: a folder for info files, or the document's own where that is empty, does not respond."""
    if folder:
        return message("The folder for info files {folder} has not answered for {seconds:g} s: connect it, or choose "
                       "another one in the preferences.", folder=folder, seconds=seconds)
    return message("The document's folder has not answered for {seconds:g} s: connect it, or choose a folder for "
                   "info files in the preferences.", seconds=seconds)


def _check_folder(folder):
    try:
        # Not created if missing: files for an unmounted share would be written to the local disk.
        os.listdir(folder)
    except OSError as error:
        raise ThinPartError(
            message("The folder for info files {folder} cannot be reached ({problem}): connect it, or choose "
                    "another one in the preferences.", folder=folder, problem=error.strerror), "info_write") from None
