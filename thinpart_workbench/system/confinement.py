# SPDX-License-Identifier: LGPL-2.1-or-later
"""Confine a process that reads foreign files: it writes into one folder only, has no network, and affects no other."""

import os
from contextlib import suppress

from .bubblewrap import bubblewrap, has_bubblewrap
from .landlock import landlock_version, write_only_below
from .linux.privileges import give_up_capabilities
from .system_call_filter import install_system_call_filter

VARIABLE = "THINPART_CONFINEMENT"
"""Environment variable that selects the confinement: ``landlock``, ``bubblewrap`` or ``none``."""

LANDLOCK, BUBBLEWRAP, SECCOMP, NONE = "landlock", "bubblewrap", "seccomp", "none"

UNCONFINED = {"files": NONE, "network": NONE}


def chosen_confinement():
    """The kind of confinement that is used here: str.

    ``landlock`` if the kernel has it, else ``bubblewrap`` if it is installed, else ``none``.
    """
    chosen = os.environ.get(VARIABLE)
    if chosen != BUBBLEWRAP and chosen != NONE and landlock_version():
        return LANDLOCK
    if chosen != LANDLOCK and chosen != NONE and has_bubblewrap():
        return BUBBLEWRAP
    return NONE


def confined_command(command, confinement, folder):
    """The command that starts a confined process, list of str.

    Parameters
    ----------
    command : list of str
    confinement : str
        From `chosen_confinement`.
    folder : str
        The folder that it may write to.
    """
    return [*bubblewrap(folder), *command] if confinement == BUBBLEWRAP else command


def confine_writing(confinement, folder):
    """Restrict this process to writing into one folder, for good, where `confine` would; it may still do all else."""
    if confinement == LANDLOCK:
        with suppress(OSError):  # `confine` reports it
            write_only_below([folder])


def confine(confinement, *folders, with_programs=False):
    """Confine this process permanently. Call this first, before the process has a second thread.

    Returns a dict: the confinement in effect: ``files`` is ``landlock``, ``bubblewrap`` or ``none``; ``network`` is
    ``seccomp``, ``bubblewrap`` or ``none``.

    Parameters
    ----------
    confinement, folders
        The same as for the command that started the process; only where it was not started as a confined one, several.
    with_programs : bool, optional
        Whether this process may run programs, which are confined like itself.
    """
    if confinement == NONE:
        return UNCONFINED
    holds = {"files": confinement, "network": confinement}
    if confinement == LANDLOCK:
        try:
            write_only_below(list(folders))
        except OSError:
            holds["files"] = NONE
        holds["network"] = NONE
    with suppress(OSError):  # the filter takes most of them away too
        give_up_capabilities()
    try:
        install_system_call_filter(with_programs)
        holds["network"] = SECCOMP if confinement == LANDLOCK else confinement
    except OSError:
        pass  # bubblewrap may have taken the network away already
    return holds


def confine_running_process(*folders, with_programs=False):
    """Confine this process if it was not started as a confined one, as far as possible: dict, as `confine`.

    Parameters
    ----------
    *folders : str
        The folders that it may write to.
    with_programs : bool, optional
        See `confine`.
    """
    return confine(LANDLOCK, *folders, with_programs=with_programs) if chosen_confinement() == LANDLOCK else UNCONFINED
