# SPDX-License-Identifier: LGPL-2.1-or-later
"""ThinPart as a custom repository in the Addon Manager of the FreeCAD at hand: install, restart, update, remove."""

import functools
import http.server
import os
import subprocess
import threading
import urllib.request
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from started_freecad import environment, start_freecad

ROOT = Path(__file__).resolve().parents[2]
STEPS = (ROOT / "tests" / "addon_manager_steps.py").read_text(encoding="utf-8")
NAME, BRANCH = "thinpart", "main"
REQUIRED, OPTIONAL = ["numpy", "scipy"], ["scikit-learn"]

CLASSIFY_A_BOX = """
import FreeCAD as App, FreeCADGui as Gui
from PySide import QtCore
import thinpart_workbench
from thinpart_workbench.gui.application.qt import QtWidgets

Gui.activateWorkbench("ThinPartWorkbench")
document = App.newDocument("Test")
box = document.addObject("Part::Box", "Plate")
box.Length, box.Width, box.Height = 100, 80, 2
document.recompute()
Gui.runCommand("ThinPart_Classify")

def look():
    headline = Gui.getMainWindow().findChild(QtWidgets.QLabel, "ThinPart_Headline")
    if headline is not None and headline.text():
        tell({"listed": "ThinPartWorkbench" in Gui.listWorkbenches(), "headline": headline.text(),
              "package": os.path.dirname(os.path.dirname(os.path.realpath(thinpart_workbench.__file__)))})

timer = QtCore.QTimer()
timer.timeout.connect(look)
timer.start(100)
"""
IS_IT_LISTED = """
import FreeCADGui as Gui
tell("ThinPartWorkbench" in Gui.listWorkbenches())
"""


def git(folder, *arguments):
    subprocess.run(["git", "-c", "user.name=Test", "-c", "user.email=", "-c", "protocol.file.allow=always", *arguments],
                   cwd=folder, check=True, capture_output=True, stdin=subprocess.DEVNULL)


class Host:
    """A host of repositories like GitLab, on this machine: git by HTTP, zips and single files of a branch."""

    def __init__(self, folder):
        self.work, self.site = folder / "work", folder / "site"
        self.site.mkdir(parents=True)
        self.repository = self.site / NAME
        subprocess.run(["cp", "-r", "--parents", *_files(), os.fspath(_made(self.work))], cwd=ROOT, check=True)
        git(self.work, "init", "-q", "-b", BRANCH)
        git(folder, "init", "-q", "--bare", "-b", BRANCH, os.fspath(self.repository))
        self.commit("first")
        handler = functools.partial(_Handler, directory=os.fspath(self.site))
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.address = f"127.0.0.1:{self.server.server_address[1]}"

    def commit(self, message):
        git(self.work, "add", "-A", "-f")
        git(self.work, "commit", "-q", "-m", message)
        git(self.work, "push", "-q", os.fspath(self.repository), BRANCH)
        git(self.repository, "update-server-info")
        archive, raw = (_made(self.repository / "-" / kind / BRANCH) for kind in ("archive", "raw"))
        git(self.work, "archive", "--format=zip", f"--prefix={NAME}-{BRANCH}/", "-o",
            os.fspath(archive / f"{NAME}-{BRANCH}.zip"), BRANCH)
        for name in ("README.md", "package.xml"):
            (raw / name).write_bytes((self.work / name).read_bytes())


class _Handler(http.server.SimpleHTTPRequestHandler):
    def translate_path(self, path):
        return super().translate_path(urlsplit(path).path)  # a proxy is asked for whole addresses

    def log_message(self, *_):
        """Nobody reads it."""


def _files():
    """What a user gets: all that git knows or would add."""
    listed = subprocess.run(["git", "-c", "safe.directory=*", "ls-files", "--cached", "--others", "--exclude-standard"],
                            cwd=ROOT, capture_output=True, encoding="utf-8")
    names = listed.stdout.splitlines() if listed.returncode == 0 else [
        each.relative_to(ROOT).as_posix() for each in ROOT.rglob("*")
        if not each.is_dir() and "__pycache__" not in each.parts]
    return [name for name in names if (ROOT / name).is_file()]


def _made(folder):
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@pytest.fixture
def host(tmp_path):
    host = Host(tmp_path / "host")
    yield host
    host.server.shutdown()
    host.server.server_close()


class User:
    """Somebody with a FreeCAD of their own who adds a custom repository."""

    def __init__(self, home, host, route, version):
        self.home, self.host, self.route, self.version = _made(home), host, route, version
        # 0.20 makes the address of a zip on hosts that it knows only: gitlab.com is one, behind a proxy here.
        behind_proxy = route == "zip" and version < (1, 0)
        self.url = "http://" + ("gitlab.com" if behind_proxy else host.address) + f"/{NAME}"
        self.proxy = host.address if behind_proxy else ""

    def does(self, step):
        """What was seen at a visit to the Addon Manager of a FreeCAD that was started for it."""
        call = f"\ntell(do{(step, NAME, self.url, BRANCH, self.route, self.proxy)!r})\n"
        return start_freecad(self.home, STEPS + call)

    @property
    def folder(self):
        """Where the add-on lies: the one that there is."""
        found = list(self.home.glob(f".local/share/FreeCAD/**/Mod/{NAME}"))
        assert len(found) == 1, found
        return found[0]


@pytest.fixture(params=["git", "zip"])
def user(request, tmp_path, host, freecad):
    return User(tmp_path / "home", host, request.param, tuple(map(int, freecad.Version()[:2])))


def files_in(folder):
    return {each.relative_to(folder).as_posix(): each.read_bytes() for each in folder.rglob("*")
            if each.is_file() and ".git" not in each.relative_to(folder).parts and "__pycache__" not in each.parts}


@pytest.mark.timeout(240)  # starts seven FreeCADs, one after the other as their user does
def test_it_is_installed_runs_is_updated_and_goes(user, host):
    # It is in the list, and installing it brings all of it.
    done = user.does("install")
    assert done["before"] == [NAME, user.url, BRANCH, "NOT_INSTALLED"]
    assert done["workbench"]
    assert files_in(user.folder) == files_in(host.work)
    assert (user.folder / ".git").is_dir() == (user.route == "git")

    # Updates will come from where it came from, as will the readme.
    assert done["address"] == [user.url, BRANCH]
    with urllib.request.urlopen(done["readme"].replace("gitlab.com", host.address)) as page:
        assert page.read() == (ROOT / "README.md").read_bytes()
    assert done["tags"] == ["fem", "mesh", "sheetmetal", "thickness"]
    assert (user.folder / done["icon"]).is_file()

    # Nothing is missing here; elsewhere the packages would be, the optional ones as such where those are known. Before 1.1
    # they are looked for by the names that Python imports them by, which scikit-learn's is not.
    missing = OPTIONAL if user.version < (1, 1) else []
    if user.version < (1, 0):
        assert done["dependencies"] == {"required": sorted(REQUIRED + OPTIONAL), "missing": missing,
                                        "elsewhere": [sorted(REQUIRED + OPTIONAL), []]}
    else:
        assert done["dependencies"] == {"required": REQUIRED, "optional": OPTIONAL, "missing": missing,
                                        "elsewhere": [REQUIRED, OPTIONAL]}

    # FreeCAD, started anew, has the workbench, and its processes find their files.
    started = start_freecad(user.home, CLASSIFY_A_BOX)
    assert started["listed"] and "thin" in started["headline"].lower()
    assert started["package"] == os.fspath(user.folder)

    # On the command line it runs without the bit that zips lose.
    assert os.access(user.folder / "thinpart", os.X_OK) == (user.route == "git")
    run = subprocess.run(["sh", user.folder / "thinpart", "install"], capture_output=True, encoding="utf-8",
                         env=dict(environment(user.home), THINPART_NO_INSTALL="1"), stdin=subprocess.DEVNULL)
    assert run.returncode == 0 and f"is installed already, {user.folder}" in run.stdout

    # A new commit arrives, and what it removes goes.
    checked = user.does("check")
    assert checked["status"] != "UPDATE_AVAILABLE" and checked["address"] == [user.url, BRANCH]
    (host.work / "CHANGELOG.md").unlink()
    (host.work / "thinpart_workbench" / "new_module.py").write_text('"""New."""\n')
    host.commit("second")
    updated = user.does("update")
    if user.route == "git":
        assert updated["found"] == "UPDATE_AVAILABLE" and updated["after"] == "NO_UPDATE_AVAILABLE"
    assert files_in(user.folder) == files_in(host.work)

    # And it goes without leaving anything.
    assert user.does("remove")["removed"]
    assert not [each for each in user.home.rglob("*") if each.name.startswith(NAME) and each.parent.name == "Mod"]
    assert start_freecad(user.home, IS_IT_LISTED) is False


def test_package_xml_tells_all_and_invents_no_address():
    package = ElementTree.parse(ROOT / "package.xml").getroot()
    texts = {each.tag.rpartition("}")[2]: each.text for each in package}
    for name in ("name", "description", "version", "date", "maintainer", "license", "icon", "freecadmin", "pythonmin",
                 "tag"):
        assert texts[name]
    assert (ROOT / texts["icon"]).is_file()
    assert [each for each in package.iter() if each.tag.endswith("url")] == []
    from thinpart_workbench import __version__

    assert texts["version"] == __version__


def test_freecad_itself_accepts_package_xml(freecad):
    package = freecad.Metadata(os.fspath(ROOT / "package.xml"))
    assert package.supportsCurrentFreeCAD() and package.FreeCADMin == "0.20.2"
    assert [each["package"] for each in package.Depend] == REQUIRED + OPTIONAL
    assert package.Content["workbench"][0].Classname == "ThinPartWorkbench"
    assert not package.Urls
