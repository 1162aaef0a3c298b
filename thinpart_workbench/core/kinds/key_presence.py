# SPDX-License-Identifier: LGPL-2.1-or-later
"""`Required` and `NotRequired` of typing, which Python lacks before 3.11; FreeCAD's own bundles may have an older one."""

import sys
from typing import Annotated

if sys.version_info >= (3, 11):
    from typing import NotRequired, Required
else:
    class NotRequired:
        """Of a key of a TypedDict: it may be missing."""

        def __class_getitem__(cls, given):
            return Annotated[given, cls]

    class Required:
        """Of a key of a TypedDict: it may not be missing, whatever holds for the others."""

        def __class_getitem__(cls, given):
            return Annotated[given, cls]

__all__ = ["NotRequired", "Required", "is_required"]


def is_required(given, key, hint):
    """Whether a TypedDict needs a key, which has this type hint."""
    marks = getattr(hint, "__metadata__", ())  # those of older Pythons, whose TypedDict does not know them
    return Required in marks or key in given.__required_keys__ and NotRequired not in marks
