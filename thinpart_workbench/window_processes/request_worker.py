# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that calls functions of `api` for the window, whose folders may be slow or unreachable.

It handles requests in their order until the end of its input: JSON objects with ``ask``, module and name of a function of
`api` such as ``document_info.keep_label``, its ``arguments``, and ``preferred``, from which it gets what else it has
parameters for. A request is answered by ``{"answer": result}``, of an object its attributes, or ``{"refused": sentence}``.

A function with the parameter ``report`` has every call of it sent as ``{"progress": [arguments]}``. One with ``report`` or
``control`` is stopped at the end of the input; every other one is finished, and so is what was asked before the end.
"""

import inspect
import os
import threading
import time
from dataclasses import asdict, is_dataclass
from importlib import import_module

from ..core.errors import Cancelled, ThinPartError
from ..core.run_control import RunControl
from .json_lines import JsonLines

_SECONDS_TO_STOP = 2.5
"""Seconds until the process is ended even if what is to stop is blocked, for example by a lost share."""


class RequestWorker:
    """Answers the requests.

    Parameters
    ----------
    parent : JsonLines
    """

    def __init__(self, parent):
        self._parent = parent
        self._control = RunControl()
        self._can_stop = False

    def serve(self):
        """Handle requests until the parent closes the pipe."""
        threading.Thread(target=self._stop_at_end_of_input, daemon=True).start()
        while (request := self._parent.incoming.get()) is not None:
            try:
                self._parent.send(answer=self._answer(**request))
            except ThinPartError as error:
                self._parent.send(refused=error.args[0])
            except Cancelled:
                pass  # the parent no longer waits for a response

    def _answer(self, ask, arguments, preferred):
        module, _, name = ask.rpartition(".")
        function = getattr(import_module(f"..api.{module}", __package__), name)
        offered = {**preferred, "report": self._report, "control": self._control}
        parameters = inspect.signature(function).parameters
        taken = {key: value for key, value in offered.items() if key in parameters}
        self._can_stop = "report" in taken or "control" in taken
        try:
            result = function(**{**taken, **arguments})
        finally:
            self._can_stop = False
        return asdict(result) if is_dataclass(result) else result  # type: ignore[arg-type]

    def _report(self, *progress):
        self._control.check()
        self._parent.send(progress=progress)

    def _stop_at_end_of_input(self):
        self._parent.ended.wait()
        self._control.stop()
        time.sleep(_SECONDS_TO_STOP)
        while not self._can_stop:
            time.sleep(_SECONDS_TO_STOP)
        os._exit(1)


def main():
    """Handle requests until the parent closes the pipe."""
    parent = JsonLines()
    with parent.reporting_failures():
        RequestWorker(parent).serve()
    parent.end()


if __name__ == "__main__":
    main()
