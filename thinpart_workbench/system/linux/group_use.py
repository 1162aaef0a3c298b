# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all processes of a group use together: the limits of Linux are for each of them."""

import os

MOST_PROCESSES = 32
"""Processes of a group: a reader, the program that it runs, and what starts that."""

_MEMORY_FACTOR = 2
"""Times the limit of memory of a process that a group may use: a reader waits for one program at a time."""


def is_too_much(group):
    """Whether a process group has more than `MOST_PROCESSES`, or uses more than twice the memory that one of them may: bool.

    Not counting what another system or a container hides.
    """
    import resource  # not on other systems, where nothing is forked

    count, pages = 0, 0
    try:
        names = os.listdir("/proc")
    except OSError:
        return False  # nothing can be seen
    for name in names:
        if name.isdigit() and _group_of(name) == group:
            count += 1
            pages += _resident_pages(name)
    most = resource.getrlimit(resource.RLIMIT_AS)[0]
    return count > MOST_PROCESSES or (
        most != resource.RLIM_INFINITY and pages * resource.getpagesize() > _MEMORY_FACTOR * most)


def _group_of(name):
    try:
        return os.getpgid(int(name))
    except OSError:
        return None  # it has ended meanwhile


def _resident_pages(name):
    try:
        with open(f"/proc/{name}/statm", "rb") as file:
            return int(file.read().split()[1])
    except (OSError, IndexError):
        return 0
