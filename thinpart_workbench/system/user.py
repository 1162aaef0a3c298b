"""Whose a file is, and who runs this program."""

import os


def is_root():
    """Whether this is Unix's user who may do everything."""
    return hasattr(os, "geteuid") and os.geteuid() == 0


def is_own(status):
    """Whether a file is this user's, as far as its `os.stat_result` tells: Windows names no owner there."""
    return not hasattr(os, "geteuid") or status.st_uid == os.geteuid()
