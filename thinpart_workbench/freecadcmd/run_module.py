"""What FreeCADCmd is given to run where there is no Python: it runs a module, as ``python -m`` would.

FreeCADCmd reads further arguments as files, runs a script that raises a second time, and ends with status 0
then. So the module and its arguments come as JSON in the environment, and this script always ends the process
itself, with the module's status.
"""

import json
import os
import runpy
import sys
import traceback


def _run():
    module, *arguments = json.loads(os.environ["THINPART_RUN"])
    # FreeCADCmd has put this folder first, where no module is to be looked for.
    here = os.path.dirname(os.path.abspath(__file__))
    # Since FreeCAD 1.1 its Python looks into no PYTHON variables.
    asked = [each for each in os.environ.get("PYTHONPATH", "").split(os.pathsep) if each]
    sys.path[:] = asked + [each for each in sys.path if each not in asked and os.path.abspath(each) != here]
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


_status = 1
try:
    _status = _run()
except BaseException:  # nothing may reach FreeCADCmd: it would begin again
    traceback.print_exc()
finally:
    for _stream in (sys.stdout, sys.stderr):
        try:
            _stream.flush()
        except OSError:
            _status = _status or 1  # nobody reads it any more
    os._exit(_status)
