# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exceptions that Python raises for an archive that cannot be unpacked."""

import zipfile
import zlib
from xml.etree.ElementTree import ParseError

try:
    from lzma import LZMAError
except ImportError:
    LZMAError = zlib.error  # a Python without that library
try:
    from compression.zstd import ZstdError
except ImportError:
    ZstdError = zlib.error  # before Python 3.14

DAMAGED_ARCHIVE = (OSError, EOFError, LookupError, ValueError, RuntimeError, zipfile.BadZipFile, zlib.error,
                   LZMAError, ZstdError, ParseError)
"""Raised for an archive that is damaged, encrypted or packed by an unknown method, and for damaged XML."""
