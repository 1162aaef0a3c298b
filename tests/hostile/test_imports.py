# SPDX-License-Identifier: LGPL-2.1-or-later
"""Modules of ThinPart do nothing when they are imported, whoever names them: a document can name every one."""

import ast
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from hostile_documents import changed, harmless, with_module
from program import failures, records, thinpart
from started_freecad import start_freecad

import thinpart_workbench
from thinpart_workbench.freecad_adapter.proxy_modules import PROXY_MODULES
from thinpart_workbench.freecad_adapter.reading.document_safety import named_modules

ROOT = Path(__file__).resolve().parents[2]
RUNNER = "thinpart_workbench.freecadcmd.run_module"

_WATCH = """
import importlib, json, os, sys
done = []

def watch(event, arguments):
    if event == "open":
        path, mode, flags = arguments
        if isinstance(flags, int) and flags & (os.O_WRONLY | os.O_RDWR) and path != os.devnull:
            done.append([event, str(path)])
    elif event.split(".")[0] in ("subprocess", "socket", "shutil") or event in (
            "os.system", "os.fork", "os.forkpty", "os.exec", "os.posix_spawn", "os.spawn", "os.kill", "os.mkdir",
            "os.remove", "os.rename", "os.rmdir", "os.link", "os.symlink", "os.truncate", "os.chmod", "os.chdir"):
        done.append([event, repr(arguments)[:200]])
"""

_IMPORT = """
absent = set()
for name in {names!r}:
    before = len(done)
    try:
        importlib.import_module(name)
    except ImportError as error:
        absent.add((error.name or "").partition(".")[0])
    done[before:] = [[name, *each] for each in done[before:]]
"""


def _own_modules():
    """Names of all modules by their files, also those in folders that are no packages, which Python imports too."""
    package = Path(thinpart_workbench.__file__).parent
    return [".".join(("thinpart_workbench", *file.relative_to(package).with_suffix("").parts)).removesuffix(".__init__")
            for file in sorted(package.rglob("*.py"))]


def _of_the_window(name):
    return name.startswith("thinpart_workbench.gui")


def test_importing_a_module_prints_writes_starts_and_ends_nothing(tmp_path):
    """All others need FreeCAD's window: they are imported there by the last test."""
    names = [name for name in _own_modules() if not _of_the_window(name)]
    assert RUNNER in names and len(names) > 200
    libraries = ("import numpy, scipy.spatial, scipy.optimize, scipy.sparse.csgraph, asyncio, ctypes, sqlite3, tempfile\n"
                 "from thinpart_workbench.freecad_adapter.bootstrap import load_meshing\nload_meshing()\n"
                 "try:\n    import distributed\nexcept ImportError:\n    pass\n")
    program = (_WATCH + libraries + "sys.addaudithook(watch)\n" + _IMPORT.format(names=names)
               + "json.dump([done, sorted(absent)], sys.__stdout__)\n")
    run = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, encoding="utf-8",
                         stdin=subprocess.DEVNULL,
                         env={**os.environ, "PYTHONPATH": str(ROOT), "PYTHONDONTWRITEBYTECODE": "1"})
    assert run.returncode == 0, run.stderr
    done, absent = json.loads(run.stdout)  # so nothing else was printed
    assert done == [] and set(absent) <= {"sklearn", "distributed", "pyarrow"}
    assert run.stderr == "" and not any(tmp_path.iterdir())


def test_only_the_modules_of_objects_are_trusted_in_documents(freecad, tmp_path):
    document = harmless(freecad, tmp_path / "harmless.FCStd")
    for name in ("thinpart_workbench", RUNNER, "thinpart_workbench.gui.activate_workbench", "thinpart_workbench.__main__"):
        assert named_modules(changed(document, tmp_path / "h.FCStd", with_module(name))).others == (name,)
    for name in PROXY_MODULES:
        assert named_modules(changed(document, tmp_path / "h.FCStd", with_module(name))).others == ()


def test_every_class_that_documents_name_is_of_a_trusted_module():
    package = Path(thinpart_workbench.__file__).parent
    found = set()
    for name in _own_modules():
        path = package.joinpath(*name.split(".")[1:]).with_suffix(".py")
        if path.is_file():
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Assign) and ast.unparse(node.value) == "self" and any(
                        isinstance(each, ast.Attribute) and each.attr == "Proxy" for each in node.targets):
                    found.add(name)
    assert len(found) >= 3 and found <= PROXY_MODULES <= set(_own_modules())


def test_a_document_that_names_the_runner_is_read(freecad, tmp_path):
    document = harmless(freecad, tmp_path / "harmless.FCStd")
    changed(document, tmp_path / "hostile.FCStd", with_module(RUNNER))
    run = thinpart("classify", tmp_path / "hostile.FCStd", "--json", "--no-info", "--no-thumbnails")
    said, = records(run)
    assert failures(run) == {} and said["category"] == "normal"
    assert any("run_module" in each and "not loaded" in each for each in said["warnings"])


@pytest.mark.skipif(not (shutil.which("Xvfb") and shutil.which("freecad")), reason="needs FreeCAD's program and a screen")
def test_freecad_goes_on_after_opening_such_a_document_and_after_importing_everything(freecad, tmp_path):
    """FreeCAD before 1.1.2 imports whatever a document names, and here nothing of ThinPart looks at it before."""
    document = harmless(freecad, tmp_path / "harmless.FCStd")
    hostile = changed(document, tmp_path / "hostile.FCStd", with_module(RUNNER))
    names = [name for name in _own_modules() if _of_the_window(name)]
    home = tmp_path / "home"
    home.mkdir()
    told = start_freecad(home, _WATCH + f"""
import FreeCAD as App, FreeCADGui as Gui
opened = [each.Name for each in App.openDocument({os.fspath(hostile)!r}).Objects]
shown = Gui.activeWorkbench().name()
sys.addaudithook(watch)
{_IMPORT.format(names=names)}
processes = [each for each in done if each[1] != "open"]
tell([opened, processes, sorted(absent), [shown, Gui.activeWorkbench().name()]])
""", "-M", os.fspath(ROOT))
    opened, done, absent, (before, after) = told
    assert "Block" in opened and "Helper" in opened
    assert done == [] and absent == [] and after == before
