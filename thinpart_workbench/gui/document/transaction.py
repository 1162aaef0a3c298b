# SPDX-License-Identifier: LGPL-2.1-or-later
"""One step of FreeCAD's Undo."""

from contextlib import contextmanager


@contextmanager
def transaction(document, name):
    """Context whose changes to a document are one undo step; an exception aborts the transaction."""
    document.openTransaction(name)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
