# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check whether a file is a FreeCAD document."""

import zipfile
import zlib

DOCUMENT_XML = "Document.xml"


def is_fcstd(file):
    """Whether an open binary file, whatever its name, is a FreeCAD document: a ZIP archive that contains Document.xml.

    Raises OSError.
    """
    try:
        with zipfile.ZipFile(file) as archive:
            return DOCUMENT_XML in archive.namelist()
    except (zipfile.BadZipFile, zlib.error, EOFError, ValueError, RuntimeError, KeyError):
        return False
