"""What Python raises over an archive that cannot be unpacked."""

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

DAMAGED_ARCHIVE = (OSError, EOFError, KeyError, ValueError, RuntimeError, zipfile.BadZipFile, zlib.error,
                   LZMAError, ZstdError, ParseError)
"""It is damaged, encrypted or packed in a way that Python does not know, or its XML is damaged."""
