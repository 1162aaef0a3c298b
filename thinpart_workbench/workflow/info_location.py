"""Where the info file of an open document lies: beside it, or in a folder that may not answer."""

import os
import queue
import threading

from ..core.errors import ThinPartError
from ..freecad_adapter.settings import preference
from ..storage.info_file import info_path

PATIENCE = 15.0
"""Seconds after which a folder on another computer is taken for unreachable."""


def info_location(document, folder=""):
    """Place of a document's info file.

    Parameters
    ----------
    document : str
        Absolute path.
    folder : str, optional
        Repeats the folders of all documents from the root of the file system on, so that documents
        of one name do not share an info file; empty for the document's own folder.

    Returns
    -------
    Path
    """
    return info_path(document, folder or None, os.sep)


def preferred_info_location(document):
    """As `info_location`, with the folder that the user prefers."""
    return info_location(document, preference("InfoFolder"))


def reach(folder, call, patience=PATIENCE):
    """Do something in the folder for info files, and wait only so long for it.

    Parameters
    ----------
    folder : str
        Empty for the document's own folder.
    call : callable
        Without arguments. It may still be at it afterwards, in a thread that ends with the process.
    patience : float
        Seconds.

    Returns
    -------
    object
        What `call` returned.

    Raises
    ------
    ThinPartError
        kind ``info_write`` where the folder is not there or does not answer, or what `call` raised.
    """
    answers = queue.SimpleQueue()

    def work():
        try:
            if folder:
                _demand(folder)
            answers.put((call(), None))
        except Exception as error:  # whatever it is: it is raised again for whoever waits
            answers.put((None, error))

    threading.Thread(target=work, daemon=True).start()
    try:
        answer, error = answers.get(timeout=patience)
    except queue.Empty:
        sentence = (
            f"The folder for info files {folder} has not answered for {patience:g} s: connect it, or choose "
            "another one in the preferences." if folder else
            f"The document's folder has not answered for {patience:g} s: connect it, or choose a folder for "
            "info files in the preferences.")
        raise ThinPartError(sentence, "info_write") from None
    if error is not None:
        raise error
    return answer


def _demand(folder):
    try:
        # Not made where it is missing: a share that is not connected would be filled up locally.
        os.listdir(folder)
    except OSError as error:
        raise ThinPartError(
            f"The folder for info files {folder} cannot be reached ({error.strerror}): connect it, or "
            "choose another one in the preferences.", "info_write") from None
