# SPDX-License-Identifier: LGPL-2.1-or-later
"""Unpickling can run code: allow only plain data in pickles from other machines."""

import pickletools
import sys
from contextlib import contextmanager

_PLAIN = {("builtins", name) for name in ("bool", "bytearray", "bytes", "dict", "float", "frozenset", "int", "list",
                                          "set", "str", "tuple")}
"""Classes that pickles of plain values name, including those of Dask. Calling them only creates a value."""

_active_blocks = 0
_is_hooked = False


class PickleRefused(AttributeError):
    """A pickle names a class or a function that is not allowed. (Dask tolerates an AttributeError.)"""


@contextmanager
def plain_pickles_only():
    """For a ``with`` block: no thread of this process unpickles anything but numbers, texts and containers of them.

    Raises PickleRefused: by the unpickling code, if a pickle contains more than that; not by this context manager.

    A library may unpickle received data in many places, some of them before other code can check it. Python
    raises the audit event ``pickle.find_class`` before it looks up a class or function that a pickle names,
    and without such a name a pickle is harmless.
    """
    global _active_blocks, _is_hooked
    if not _is_hooked:
        sys.addaudithook(_refuse)  # permanent: audit hooks cannot be removed
        _is_hooked = True
    _active_blocks += 1
    try:
        yield
    finally:
        _active_blocks -= 1


def _refuse(event, arguments):
    if event == "pickle.find_class" and _active_blocks and arguments not in _PLAIN:
        raise PickleRefused(f"a message names {'.'.join(map(str, arguments))}, and may hold data alone")


def texts_of_pickle(content):
    """The texts in a pickle, including names of modules and their members, without unpickling it: list of str.

    In their order; if the pickle is damaged, those before the damage.
    """
    texts = []
    try:
        for _, argument, _ in pickletools.genops(content):
            if isinstance(argument, str):
                texts.append(argument)
    except (ValueError, MemoryError, OverflowError):
        pass  # damaged from here on
    return texts
