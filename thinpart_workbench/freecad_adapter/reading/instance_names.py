# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an instance is called in the tree."""

import re

from ..occurrence import objects_along

_NO_NAME = re.compile(
    r"(none|solid|shell|compound|unnamed|unknown|=>\[.*\]|open\scascade\sstep\stranslator.*)?", re.IGNORECASE)
"""What STEP files and FreeCAD's import call what nobody named, without the number that FreeCAD adds."""

_DIGITS, _BEFORE_DIGITS = "0123456789", " _\t\r\n"


def telling_label(top, path, leaf):
    """The label of the object at a path; where nobody named it, that of the nearest instance or assembly around it.

    Returns a str: such as ``Bracket`` for the solid ``NONE001`` of an imported product ``Bracket``.

    Parameters
    ----------
    top : App.DocumentObject
    path : str
        Below the top object.
    leaf : App.DocumentObject
        The one at its end.
    """
    for candidate in (leaf, *reversed(objects_along(top, path))):
        # Not by the pattern, which would try every length of what comes before the number.
        if not _NO_NAME.fullmatch(candidate.Label.strip().rstrip(_DIGITS).rstrip(_BEFORE_DIGITS)):
            return candidate.Label
    return leaf.Label
