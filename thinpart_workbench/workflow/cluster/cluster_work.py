# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cluster does with tasks of one kind, and how these reach its workers and come back: as JSON."""

from dataclasses import dataclass
from importlib import import_module
from typing import Callable


@dataclass(frozen=True)
class ClusterWork:
    """A kind of work.

    Attributes
    ----------
    name : str
        Module below `workflow` and name in it, by which processes on other machines find this: ``cluster.file_work.FILES``.
    content : callable
        Maps a task to a JSON object, with absolute paths, so that a process on another machine finds the files.
    task : callable
        Maps such an object to an equal task.
    doer : callable
        ``doer(limits)`` is a context manager, which gives ``do(task, control)``: it does a task in a process with limits and
        returns the outcome, JSON values.
    done : callable
        ``done(task, outcome)`` gives the `Done` of a task. Raises ValueError, whose text says why, where the outcome is
        none: it comes from a worker that is not trusted.
    files : callable
        Maps a task to the paths of the files that a worker has to see.
    """

    name: str
    content: Callable
    task: Callable
    doer: Callable
    done: Callable
    files: Callable


def work_named(name):
    """The `ClusterWork` of a name."""
    module, _, attribute = name.rpartition(".")
    return getattr(import_module(f"..{module}", __package__), attribute)
