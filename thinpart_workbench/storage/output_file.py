# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes every file that a command or the window was asked to write: what people have is never replaced by it.

A file is written anew where there is none, or an empty one, or one that bears ThinPart's mark (`core.kinds.file_marks`);
otherwise only where the user says so. Never replaced are files with names of CAD formats, info files, inputs of the same
run, and what a link leads to unless it bears the mark.
"""

import errno
import os
from contextlib import contextmanager
from typing import NamedTuple, Optional

from ..core.errors import ThinPartError
from ..core.file_formats import ENDINGS, INFO_ENDING
from ..core.kinds.file_marks import INFO
from ..core.message import message
from ..core.regular_file import open_regular
from .atomic_file import place_new, write_atomically


class ForeignFile(ThinPartError):
    """A file that ThinPart did not write and may replace if the user says so."""

    kind = "usage"


class _Place(NamedTuple):
    """Where an output goes, and the `os.stat_result` of the file that it replaces there."""

    path: str
    replaced: Optional[os.stat_result]


def check_output(path, mark, overwrite=False, inputs=()):
    """Check that a file may be written, before minutes are spent on its content.

    Raises ForeignFile, kind ``usage`` where `overwrite` would allow it. Raises ThinPartError, kind ``usage`` where nothing
    does; also for folders, pipes and devices. Raises OSError if it cannot be read, or its folder cannot be written.

    Parameters
    ----------
    path : str or Path
    mark : HeadMark, SealedHead, JsonMark or SealMark
        What a file bears that may be replaced.
    overwrite : bool, optional
        Whether the user has said that a file without the mark may be replaced.
    inputs : iterable of str or Path, optional
        Files that the run reads. They are not looked at where there is no file yet.
    """
    place = _place(path, mark, overwrite, inputs)
    folder = os.path.dirname(place.path)
    if not os.access(folder, os.W_OK):
        os.stat(folder)
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), folder)


def write_output(path, content, mark, overwrite=False, inputs=(), durable=True):
    """Write a file atomically, if it may be written.

    Raises ForeignFile, ThinPartError: see `check_output`. Raises OSError: the old file is then still there.

    Parameters
    ----------
    path : str or Path
        Where it is a link to a file with the mark, that file is written and the link stays.
    content : bytes
        With the mark.
    durable : bool, optional
        See `write_atomically`.
    mark, overwrite, inputs
        See `check_output`.
    """
    place = _place(path, mark, overwrite, inputs)

    def give_name(temporary, new):
        if place.replaced is None:
            place_new(temporary, new)
        elif _identity(os.lstat(new)) == _identity(place.replaced):
            os.replace(temporary, new)
        else:
            raise FileExistsError

    try:
        write_atomically(place.path, content, durable, place=give_name)
    except FileExistsError:
        raise ForeignFile(message("{file} was written by another program meanwhile and was not changed: name another file.",
                                  file=os.fspath(path)), "usage") from None


@contextmanager
def writing(path):
    """Context manager that checks or writes an output: an OSError becomes a ThinPartError.

    Of the kind ``usage`` where the folder is not there, else ``failed``.
    """
    try:
        yield
    except OSError as error:
        kind = "usage" if isinstance(error, FileNotFoundError) else "failed"
        raise ThinPartError(message("{file} cannot be written ({problem}): name another place.", file=os.fspath(path),
                                    problem=error.strerror), kind) from None


def bears_mark(path, mark):
    """Whether a file is there, and bears the mark of ThinPart: bool."""
    try:
        with open_regular(path) as file:
            return mark.is_in(file)
    except OSError:
        return False


def _place(path, mark, overwrite, inputs):
    """The place of an output, if it may be written."""
    given, is_link = os.path.abspath(path), os.path.islink(path)
    place = os.path.realpath(given) if is_link else given
    ending = os.path.splitext(given)[1].lower()
    if _has_name_of(given, (INFO_ENDING,)):
        raise _info_refused(given)
    if _has_name_of(given, ENDINGS) and not given.lower().endswith(mark.endings or ("\0",)):
        raise _refused(message("{file} has the name of a CAD file and was not changed: name another file.", file=given))
    try:
        with open_regular(place) as file:
            status = os.fstat(file.fileno())
            is_ours = status.st_size == 0 or mark.is_in(file)
            file.seek(0)
            is_info = not is_ours and INFO.is_in(file)
    except FileNotFoundError:
        if is_link:
            raise _refused(message("{file} is a link to a file that is missing, and was not changed: name the file itself.",
                                   file=given)) from None
        return _Place(place, None)
    except OSError as error:
        if error.errno not in (errno.EISDIR, errno.EINVAL, errno.ELOOP):
            raise
        raise _refused(message("{file} cannot be written ({problem}): name another place.", file=given,
                               problem=error.strerror)) from None
    if any(_is_same(each, status) for each in inputs):
        raise _refused(message("{file} is an input of this run and was not changed: name another file.", file=given))
    if is_info or _has_name_of(place, (INFO_ENDING,)):
        raise _info_refused(given)
    if is_link and not (is_ours and ending and _has_name_of(place, [ending])):
        raise _refused(message("{file} is a link to {target}, which is not an output of ThinPart and was not changed: name "
                               "another file.", file=given, target=place))
    if not is_ours and _has_name_of(given, ENDINGS):
        raise _refused(message("{file} is a CAD file that ThinPart did not write, and was not changed: name another file.",
                               file=given))
    if not (is_ours or overwrite):
        raise ForeignFile(message("{file} was not written by ThinPart and was not changed: name another file, or allow it "
                                  "to be overwritten (--overwrite).", file=given), "usage")
    return _Place(place, status)


def _has_name_of(path, endings):
    """Whether a path has one of these endings, also in the spellings that Windows takes for the same."""
    name = os.path.basename(path).casefold().rstrip(". ")
    if os.sep == "\\":
        name = name.partition(":")[0]  # what follows is a stream of the file
    return name.endswith(tuple(endings))


def _refused(sentence):
    return ThinPartError(sentence, "usage")


def _info_refused(file):
    return _refused(message("{file} is an info file and was not changed: name another file.", file=file))


def _is_same(path, status):
    """Whether a path leads to a file with this status: by any link, and in any spelling that its file system takes."""
    try:
        return os.path.samestat(os.stat(path), status)
    except OSError:
        return False


def _identity(status):
    return status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns
