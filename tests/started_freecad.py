# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD as a user starts it: with the folders of a home of its own, and whatever add-ons lie there."""

import json
import os
import subprocess
import time
from pathlib import Path

from gui.virtual_screen import virtual_screen

SECONDS = 50
SETTINGS = Path(__file__).resolve().parent / "gui" / "user.cfg"
OWN_SETTINGS = ".config/FreeCAD/user.cfg"

_OWN_FOLDERS = ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "FREECAD_USER_HOME", "FREECAD_USER_DATA",
                "FREECAD_USER_TEMP", "PYTHONPATH", "PYTHONSAFEPATH", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")

# FreeCAD runs the script before its window is up. What is printed there goes to a panel of the window.
# FreeCAD runs an InitGui.py inside a function, whose names the functions in it do not see.
_START = """
from PySide import QtCore

def tell(value):
    import json, os, FreeCAD
    told = os.path.join(os.environ["HOME"], "told.json")
    with open(told + ".part", "w", encoding="utf-8") as file:
        json.dump(value, file)
    os.replace(told + ".part", told)
    FreeCAD.saveParameter()
    os._exit(0)

def go(tell=tell):
    import os, traceback
    try:
        with open(os.environ["THINPART_SCRIPT"], encoding="utf-8") as file:
            # One namespace, so that what the script defines is seen everywhere in it.
            exec(compile(file.read(), "script", "exec"), {"tell": tell, "os": os, "__name__": "script"})
    except BaseException:
        tell({"error": traceback.format_exc()})

QtCore.QTimer.singleShot(0, go)
"""


def environment(home):
    """dict of the environment in which FreeCAD, and ``thinpart``, use the folders below a home."""
    own = {name: value for name, value in os.environ.items() if name not in _OWN_FOLDERS}
    runtime = home / "runtime"
    runtime.mkdir(mode=0o700, exist_ok=True)
    return dict(own, HOME=os.fspath(home), XDG_RUNTIME_DIR=os.fspath(runtime), LC_ALL="C.UTF-8",
                PYTHONDONTWRITEBYTECODE="1", THINPART_CACHE=os.fspath(home / "thinpart-cache"))


def start_freecad(home, script, *options, early=False, settings="user.cfg", seconds=SECONDS):
    """Start FreeCAD with its window, run a script in it, and end it.

    Parameters
    ----------
    home : Path
        The user's home; settings in it outlast the FreeCAD that made them.
    script : str
        Python. FreeCAD ends when it calls ``tell`` with what JSON can hold, now or from a timer.
    options : str
        FreeCAD's own.
    early : bool
        Whether it runs before what FreeCAD may ask at its first start, in a dialog that holds up everything else.
    settings : str
        Where in the home they are; ``.config/FreeCAD/user.cfg`` is where FreeCAD up to 1.0 keeps them itself.

    Returns
    -------
    What the script told.
    """
    file = home / settings
    if not file.exists():
        file.parent.mkdir(parents=True, exist_ok=True)
        wanted = SETTINGS.read_text(encoding="utf-8").replace("LANGUAGE", "English").replace("NUMBERS", "0")
        # ThinPart may not be there, and the workbench that comes then is a web page in 0.20.
        file.write_text(wanted.replace("ThinPartWorkbench", "PartWorkbench"), encoding="utf-8")
    if settings != OWN_SETTINGS:
        options = (*options, "-u", os.fspath(file))
    addon = home / "addon"
    addon.mkdir(exist_ok=True)
    start = addon / "InitGui.py" if early else home / "start.py"
    inside, told = home / "script.py", home / "told.json"
    start.write_text(_START, encoding="utf-8")
    inside.write_text(script, encoding="utf-8")
    told.unlink(missing_ok=True)
    options = ("-M", os.fspath(addon), *options) if early else (os.fspath(start), *options)
    log = home / "freecad.log"
    with virtual_screen(1400, 900) as display, open(log, "wb") as output:
        run = subprocess.run(
            ["timeout", "--kill-after=5", str(seconds), "freecad", *options],
            env=dict(environment(home), DISPLAY=display, THINPART_SCRIPT=os.fspath(inside)),
            stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT, cwd=home)
        # One that restarts itself is another process, which ends with the screen.
        end = time.monotonic() + (seconds if early and run.returncode == 0 else 0)
        while not told.is_file() and time.monotonic() < end:
            time.sleep(0.1)
    assert told.is_file(), f"FreeCAD ended with status {run.returncode}: {log.read_text(errors='replace')[-4000:]}"
    answer = json.loads(told.read_text(encoding="utf-8"))
    assert not (isinstance(answer, dict) and "error" in answer), answer["error"] + log.read_text(errors="replace")[-4000:]
    return answer
