# SPDX-License-Identifier: LGPL-2.1-or-later
"""Script for FreeCADCmd, used if there is no Python: it runs a module as ``python -m`` would.

FreeCADCmd opens further arguments as files, and runs a script that raises a second time and then exits with status 0.
So the module and its arguments are passed as JSON in the environment, and this script always ends the process itself,
with the module's exit status.
"""

import json
import os
import runpy
import sys
import traceback


def _run():
    module, *arguments = json.loads(os.environ["THINPART_RUN"])
    # FreeCADCmd puts this folder first on the path, but no module should be imported from it.
    here = os.path.dirname(os.path.abspath(__file__))
    # Since FreeCAD 1.1 its Python ignores the PYTHON* environment variables.
    python_path = [folder for folder in os.environ.get("PYTHONPATH", "").split(os.pathsep) if folder]
    sys.path[:] = python_path + [
        folder for folder in sys.path if folder not in python_path and os.path.abspath(folder) != here]
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(encoding="utf-8")
    sys.argv = [module, *arguments]
    try:
        runpy.run_module(module, run_name="__main__", alter_sys=True)
    except SystemExit as end:
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    return 0


def _run_and_exit():
    status = 1
    try:
        status = _run()
    except BaseException:  # nothing may reach FreeCADCmd, which would run the script again
        traceback.print_exc()
    finally:
        for stream in (sys.stdout, sys.stderr):
            try:
                stream.flush()
            except OSError:
                status = status or 1  # the reader has closed the pipe
        os._exit(status)


if not __package__:  # FreeCADCmd imports the script by its bare name; as a module of ThinPart it does nothing
    _run_and_exit()
