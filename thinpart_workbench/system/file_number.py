# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inode number of a file."""

import sys


def file_number(status):
    """Inode number by an `os.stat_result`, to detect that a file was replaced: int.

    Fits into 63 bits. Always 0 on Windows, which gives the number for open files only.
    """
    return 0 if sys.platform == "win32" else status.st_ino & (2 ** 63 - 1)
