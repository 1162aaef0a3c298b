# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart install`` and ``uninstall``, in the folders that real FreeCADs read."""

import os
import subprocess
import sys
import types
from pathlib import Path

import pytest
from started_freecad import OWN_SETTINGS, environment, start_freecad

from thinpart_workbench.cli.commands import install
from thinpart_workbench.freecad_adapter import mod_folders
from thinpart_workbench.freecad_adapter.mod_folders import ModFolder, folders_below

ROOT = Path(__file__).resolve().parents[2]
WHAT_IS_LOADED = """
import FreeCAD as App, FreeCADGui as Gui, thinpart_workbench
tell({"listed": "ThinPartWorkbench" in Gui.listWorkbenches(), "reads": App.getUserAppDataDir(),
      "package": os.path.realpath(os.path.dirname(os.path.dirname(thinpart_workbench.__file__))),
      "folders": [each for each in App.__ModDirs__ if os.path.exists(os.path.join(each, "thinpart_workbench"))],
      "report": report()})
"""
READ_REPORT = """
import os
from PySide import QtCore
try:
    from PySide import QtWidgets
    QtWidgets.QTextEdit
except (ImportError, AttributeError):
    from PySide import QtGui as QtWidgets

def report():
    import FreeCADGui
    view = FreeCADGui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view")
    return view.toPlainText()
"""


@pytest.fixture
def home(tmp_path):
    return tmp_path


@pytest.fixture
def user_folder(home, freecad):
    """The user's folder for FreeCAD in which those of the versions lie."""
    return home / ".local" / "share" / "FreeCAD"


def thinpart(home, command):
    return subprocess.run(
        [sys.executable, "-m", "thinpart_workbench", command], env=dict(environment(home), PYTHONPATH=os.fspath(ROOT)),
        capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL)


def links(home):
    """The links below a home that lead to this checkout, by their path in it."""
    return sorted(each.parent.relative_to(home).as_posix() + "/" + each.name for each in home.rglob("*")
                  if each.is_symlink() and each.resolve() == ROOT)


def copy_of_thinpart(mod, name):
    """What the Addon Manager would have put there."""
    folder = mod / name
    folder.mkdir(parents=True)
    (folder / "package.xml").write_bytes((ROOT / "package.xml").read_bytes())
    return folder


def test_a_new_user_gets_a_link_that_this_freecad_reads_once(home):
    run = thinpart(home, "install")
    assert run.returncode == 0 and run.stderr == ""
    loaded = start_freecad(home, READ_REPORT + WHAT_IS_LOADED)
    assert loaded["listed"] and loaded["package"] == os.fspath(ROOT)
    assert loaded["folders"] == [os.path.join(loaded["reads"], "Mod", "ThinPart")]
    assert links(home) == [Path(loaded["folders"][0]).relative_to(home).as_posix()]
    assert loaded["folders"][0] in run.stdout
    assert "ThinPart" not in loaded["report"]
    again = thinpart(home, "install")
    assert again.returncode == 0 and "is installed already" in again.stdout
    removed = thinpart(home, "uninstall")
    assert removed.returncode == 0 and f"removed, {loaded['folders'][0]}" in removed.stdout
    assert links(home) == []
    assert "is not installed" in thinpart(home, "uninstall").stdout


def test_every_version_that_is_there_gets_a_link_and_is_named(home, user_folder):
    for folder in ("Macro", "v1-1/Macro", "v1-2/Mod"):
        (user_folder / folder).mkdir(parents=True)
    run = thinpart(home, "install")
    expected = [f".local/share/FreeCAD/{each}" for each in ("Mod/ThinPart", "v1-1/Mod/ThinPart", "v1-2/Mod/ThinPart")]
    assert run.returncode == 0 and links(home) == expected
    for readers, link in zip(("FreeCAD up to 1.0", "FreeCAD 1.1", "FreeCAD 1.2"), expected):
        assert f"{readers}: installed, {home}/{link}\n" in run.stdout
    run = thinpart(home, "uninstall")
    assert run.returncode == 0 and links(home) == []
    assert run.stdout.count("removed, ") == 3


def test_what_is_not_this_checkout_is_named_and_left(home, user_folder):
    for folder in ("Mod", "v1-1/Mod", "v1-2/Mod", "v1-3/Mod"):
        (user_folder / folder).mkdir(parents=True)
    other = copy_of_thinpart(home, "another checkout")
    copied = copy_of_thinpart(user_folder / "v1-1" / "Mod", "thinpart-of-mine")
    (user_folder / "v1-2" / "Mod" / "ThinPart").symlink_to(other)
    (user_folder / "v1-3" / "Mod" / "ThinPart").symlink_to(home / "gone")
    run = thinpart(home, "install")
    assert run.returncode == 1 and links(home) == [".local/share/FreeCAD/Mod/ThinPart"]
    for left, how in ((copied, "in FreeCAD's Addon Manager, or by hand"),
                      (user_folder / "v1-2" / "Mod" / "ThinPart", "by hand"),
                      (user_folder / "v1-3" / "Mod" / "ThinPart", "by hand")):
        assert f"{left} already exists and is not this checkout: remove it {how} and install again." in run.stderr
    run = thinpart(home, "uninstall")
    assert run.returncode == 1 and links(home) == []
    for left in (copied, user_folder / "v1-2" / "Mod" / "ThinPart", user_folder / "v1-3" / "Mod" / "ThinPart"):
        assert os.path.lexists(left) and f"{left} (remove it " in run.stderr
    assert (other / "package.xml").is_file()


def test_a_folder_of_that_name_that_is_something_else_is_left(home, user_folder):
    mine = user_folder / "v1-1" / "Mod" / "ThinPart"
    mine.mkdir(parents=True)
    (mine / "notes.txt").write_text("mine")
    run = thinpart(home, "install")
    assert run.returncode == 1 and f"{mine} already exists and is not ThinPart" in run.stderr
    thinpart(home, "uninstall")
    assert (mine / "notes.txt").read_text() == "mine"


def test_a_link_by_another_name_is_ours_too(home, user_folder):
    (user_folder / "v1-1" / "Mod").mkdir(parents=True)
    (user_folder / "v1-1" / "Mod" / "thin").symlink_to(ROOT)
    assert f"is installed already, {user_folder}/v1-1/Mod/thin" in thinpart(home, "install").stdout
    assert thinpart(home, "uninstall").returncode == 0 and links(home) == []


def test_a_folder_that_may_not_be_written_leaves_the_others(home, user_folder):
    (user_folder / "v1-1").mkdir(parents=True)
    (user_folder / "v1-1" / "Mod").write_text("a file where the folder belongs")
    (user_folder / "v1-2").mkdir()
    run = thinpart(home, "install")
    assert run.returncode == 1 and f"the link {user_folder}/v1-1/Mod/ThinPart could not be created" in run.stderr
    assert ".local/share/FreeCAD/v1-2/Mod/ThinPart" in links(home)


@pytest.mark.parametrize("there, read, version, expected", [
    ([], "FreeCAD", (1, 0), [("Mod", None, None)]),
    ([], "FreeCAD/v1-1", (1, 1), [("v1-1/Mod", (1, 1), None)]),
    # Not asked yet whether to copy the settings, it reads what is there.
    (["Mod"], "FreeCAD", (1, 1), [("Mod", None, (1, 1))]),
    (["Mod", "v1-1"], "FreeCAD/v1-1", (1, 1), [("v1-1/Mod", (1, 1), None), ("Mod", None, None)]),
    (["Mod", "v1-1"], "FreeCAD", (0, 20), [("Mod", None, None), ("v1-1/Mod", (1, 1), None)]),
    (["v1-1", "v1-2"], "FreeCAD/v1-2", (1, 3), [("v1-2/Mod", (1, 2), (1, 3)), ("v1-1/Mod", (1, 1), None)]),
    (["v1-10", "v1-9", "Macro"], "FreeCAD/v1-10", (1, 10),
     [("v1-10/Mod", (1, 10), None), ("Mod", None, None), ("v1-9/Mod", (1, 9), None)]),
])
def test_the_folders_of_the_versions(tmp_path, there, read, version, expected):
    for each in there:
        (tmp_path / "FreeCAD" / each).mkdir(parents=True)
    found = folders_below(tmp_path / read, version)
    assert [(each.path.relative_to(tmp_path / "FreeCAD").as_posix(), *each[1:]) for each in found] == expected


def test_without_the_right_to_link_windows_gets_a_junction(tmp_path, monkeypatch, capsys):
    """A simulated Windows: what it raises and offers."""
    made = []

    def refuse(*_, **__):
        error = OSError(22, "A required privilege is not held by the client")
        error.winerror = 1314
        raise error

    monkeypatch.setattr(Path, "symlink_to", refuse)
    monkeypatch.setitem(sys.modules, "_winapi", types.SimpleNamespace(CreateJunction=lambda *paths: made.append(paths)))
    monkeypatch.setattr(mod_folders, "mod_folders", lambda: [ModFolder(tmp_path, (1, 1), None)])
    options = types.SimpleNamespace(command="install")
    assert install.run(options) == 0
    assert made == [(os.fspath(ROOT), os.fspath(tmp_path / "ThinPart"))]
    monkeypatch.delattr(sys.modules["_winapi"], "CreateJunction")
    monkeypatch.setattr(Path, "symlink_to", lambda *_, **__: os.mkdir("/proc/nothing"))
    assert install.run(options) == 1 and "could not be created" in capsys.readouterr().err


COPY_THE_CONFIGURATION = """
import FreeCAD as App

def look():
    if App.getUserAppDataDir().endswith("v1-1/"):
        timer.stop()
        load()
    for dialog in QtWidgets.QApplication.topLevelWidgets():
        if dialog.isVisible() and "DlgVersionMigrator" in dialog.objectName():
            with open(os.path.join(os.environ["HOME"], "read-before"), "w") as file:
                file.write(App.getUserAppDataDir())
            copying = [each for each in dialog.findChildren(QtWidgets.QPushButton) if "Copy" in each.text()]
            copying[0].click()

timer = QtCore.QTimer()
timer.timeout.connect(look)
timer.start(500)

def load():
""" + "".join(f"    {line}\n" for line in WHAT_IS_LOADED.splitlines())


@pytest.mark.timeout(120)  # FreeCAD copies, ends and starts again
def test_it_survives_the_copy_of_the_settings_and_is_loaded_once(home, user_folder, freecad):
    """What FreeCAD 1.1 does at its first start where an older version was used; then it restarts itself."""
    if tuple(map(int, freecad.Version()[:2])) < (1, 1):
        pytest.skip("this FreeCAD has one folder for all versions")
    (user_folder / "Mod").mkdir(parents=True)
    run = thinpart(home, "install")
    assert ("FreeCAD up to 1.0, and 1.1 until it has a folder of its own: "
            f"installed, {user_folder}/Mod/ThinPart") in run.stdout
    assert links(home) == [".local/share/FreeCAD/Mod/ThinPart"]  # a folder for 1.1 would keep FreeCAD from copying
    loaded = start_freecad(home, READ_REPORT + COPY_THE_CONFIGURATION, early=True, settings=OWN_SETTINGS)
    assert Path((home / "read-before").read_text()) == user_folder
    both = [".local/share/FreeCAD/Mod/ThinPart", ".local/share/FreeCAD/v1-1/Mod/ThinPart"]
    assert links(home) == both
    assert loaded["folders"] == [f"{user_folder}/v1-1/Mod/ThinPart"]
    assert loaded["listed"] and "ThinPart" not in loaded["report"]
    assert thinpart(home, "install").stdout.count("is installed already") == 2
    assert thinpart(home, "uninstall").stdout.count("removed, ") == 2
    assert links(home) == []


def test_of_two_copies_one_runs_and_the_report_view_names_both(home, tmp_path):
    """An add-on and a folder given by -M: the package is one of theirs, and so is all that is started."""
    thinpart(home, "install")
    copied = tmp_path / "copy"
    copied.mkdir()
    for name in ("Init.py", "InitGui.py", "package.xml", "thinpart_workbench", "resources"):
        (copied / name).symlink_to(ROOT / name) if name == "resources" else subprocess.run(
            ["cp", "-r", ROOT / name, copied / name], check=True)
    loaded = start_freecad(home, READ_REPORT + WHAT_IS_LOADED, "-M", os.fspath(copied))
    assert len(loaded["folders"]) == 2 and loaded["listed"]
    not_used = ({os.fspath(ROOT), os.fspath(copied)} - {loaded["package"]}).pop()
    said = f"ThinPart is installed twice: {loaded['package']} is used, {not_used} is not."
    assert loaded["report"].count(said) == 1


def test_the_same_checkout_found_twice_is_no_matter(home):
    thinpart(home, "install")
    loaded = start_freecad(home, READ_REPORT + WHAT_IS_LOADED, "-M", os.fspath(ROOT))
    assert len(loaded["folders"]) == 2 and loaded["listed"] and "ThinPart" not in loaded["report"]


