"""The number by which a file system knows a file."""

import sys


def file_number(status):
    """Number of a file, to see whether it is still the same one.

    Parameters
    ----------
    status : os.stat_result

    Returns
    -------
    int
        Fits into 63 bits. Windows tells it only of files that are open, so there it is always 0.
    """
    return 0 if sys.platform == "win32" else status.st_ino & (2 ** 63 - 1)
