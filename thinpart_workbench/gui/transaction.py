"""One step of FreeCAD's Undo."""

from contextlib import contextmanager


@contextmanager
def transaction(document, name):
    """What is changed in a document within it is undone together; nothing of it stays after an error."""
    document.openTransaction(name)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
