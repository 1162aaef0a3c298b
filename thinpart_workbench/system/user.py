# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user who runs this program, and the owner of a file."""

import getpass
import os


def is_root():
    """Whether this process runs as root on Unix."""
    return hasattr(os, "geteuid") and os.geteuid() == 0


def is_own(status):
    """Whether a file belongs to this user, from its `os.stat_result`. Always True on Windows, which gives no owner."""
    return not hasattr(os, "geteuid") or status.st_uid == os.geteuid()


def user_name():
    """The login name of the user on this computer; "someone" where it has none."""
    try:
        return getpass.getuser()
    except (KeyError, OSError, ImportError):  # a user without an entry, such as in a container; on Windows no pwd
        return "someone"
