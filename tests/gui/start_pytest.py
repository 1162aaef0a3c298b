"""FreeCAD's start-up script: runs pytest once the window is up, then ends FreeCAD."""

import faulthandler
import json
import os
import sys


def _go():
    home = os.environ["HOME"]
    # FreeCAD shows what is printed in a panel of its window; here it has to come out.
    output = open(os.path.join(home, "output.txt"), "w", encoding="utf-8", buffering=1)
    sys.stdout = sys.stderr = output
    faulthandler.enable(output)
    faulthandler.dump_traceback_later(2640, exit=True, file=output)
    status = 1
    try:
        import pytest

        status = pytest.main(["-p", "no:cacheprovider", "--capture=sys",
                              *json.loads(os.environ["THINPART_GUI_ARGUMENTS"])])
    finally:
        # FreeCAD would ask whether to save the documents.
        output.flush()
        os._exit(int(status))


from PySide import QtCore  # noqa: E402

QtCore.QTimer.singleShot(0, _go)
