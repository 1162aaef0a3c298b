"""Where FreeCAD calls ThinPart: an error that nobody foresaw goes no further than this edge.

FreeCAD prints what an observer, a command or a proxy raises as a traceback, and shows that to the user as a
notification. So the methods that it calls are guarded: where there is a window, it is told what was raised and says it
in one sentence. Without one the error is raised as ever, for the caller to see.
"""

import functools
from fnmatch import fnmatch

_listeners = []


def on_fault(call):
    """Have a function called with every exception that ends at an edge; the first call guards them."""
    _listeners.append(call)


def guarded(call, otherwise=None):
    """A function that returns something instead of raising, once somebody wants to be told (see `on_fault`).

    Parameters
    ----------
    call : callable
    otherwise : object, optional
        What is returned instead.
    """
    @functools.wraps(call)
    def edge(*arguments, **named):
        try:
            return call(*arguments, **named)
        except Exception as error:  # not only those that are foreseen: that is what an edge is for
            if not _listeners:
                raise
            for tell in _listeners:
                tell(error)
            return otherwise

    return edge


def guarded_methods(*names, **otherwise):
    """Guard methods of a class, which FreeCAD calls; a class decorator.

    Parameters
    ----------
    *names : str
        With wildcards: ``"slot*"``. They return None instead of raising.
    **otherwise : object
        What methods of other names return instead.
    """
    def decorate(decorated):
        for name, method in list(vars(decorated).items()):
            if name not in otherwise and not any(fnmatch(name, each) for each in names):
                continue
            if isinstance(method, classmethod):
                setattr(decorated, name, classmethod(guarded(method.__func__, otherwise.get(name))))
            else:
                setattr(decorated, name, guarded(method, otherwise.get(name)))
        return decorated

    return decorate
