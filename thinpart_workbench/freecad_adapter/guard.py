# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guard the methods that FreeCAD calls against unexpected exceptions.

FreeCAD prints an exception from an observer, a command or a proxy as a traceback and shows it to the user as a
notification. Guarded methods report it to the window instead, which shows one sentence. Without a window the exception
propagates to the caller as usual.
"""

import functools
from fnmatch import fnmatch

from ..core.hook import Hook

FAULTS = Hook()
"""Called with every exception that a guarded function caught. Guarding starts when the first listener is added."""


def report_fault(error):
    """Report an exception to the listeners of `FAULTS`; raise it if there are none."""
    if not FAULTS:
        raise error
    FAULTS(error)


def guarded(call, otherwise=None):
    """Wrap a function so that it returns a fallback instead of raising, once `FAULTS` has a listener.

    Parameters
    ----------
    call : callable
    otherwise : object, optional
        The fallback.
    """
    @functools.wraps(call)
    def wrapper(*arguments, **named):
        try:
            return call(*arguments, **named)
        except Exception as error:  # deliberately broad: the guard is for unexpected exceptions
            report_fault(error)
            return otherwise

    return wrapper


def guarded_methods(*names, **otherwise):
    """Class decorator that guards the methods that FreeCAD calls.

    Parameters
    ----------
    *names : str
        Names of methods that return None instead of raising; may have wildcards, as in ``"slot*"``.
    **otherwise : object
        Names of further methods, with their fallbacks.
    """
    def decorate(decorated):
        for name, method in list(vars(decorated).items()):
            if name not in otherwise and not any(fnmatch(name, pattern) for pattern in names):
                continue
            if isinstance(method, classmethod):
                setattr(decorated, name, classmethod(guarded(method.__func__, otherwise.get(name))))
            else:
                setattr(decorated, name, guarded(method, otherwise.get(name)))
        return decorated

    return decorate
