# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user does in FreeCAD's Addon Manager, by the Addon Manager's own classes; runs inside FreeCAD.

The Addon Managers of 0.20, 1.0 and 1.1 are three programs: each has its own class of steps here.
"""

import contextlib
import os
import sys
import time

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui
if not hasattr(QtWidgets, "QApplication"):
    QtWidgets = QtGui

PREFERENCES = App.ParamGet("User parameter:BaseApp/Preferences/Addons")
MOD = os.path.join(App.getUserAppDataDir(), "Mod")
PACKAGES = ("numpy", "scipy", "scikit-learn")
VERSION = tuple(int(part) for part in App.Version()[:2])


def wait_until(true, what, seconds=40):
    end = time.monotonic() + seconds
    while not true():
        if time.monotonic() > end:
            raise RuntimeError("waited in vain: " + what)
        QtWidgets.QApplication.processEvents()
        time.sleep(0.01)


@contextlib.contextmanager
def nothing_installed(checker, packages):
    """A FreeCAD whose Python has none of some packages, which the one at hand has."""
    before = {name: sys.modules.get(name) for name in packages}
    sys.modules.update(dict.fromkeys(packages))  # None: importing it fails
    asked = getattr(checker, "package_is_installed", None)
    if asked:
        checker.package_is_installed = staticmethod(lambda name: name not in packages and asked(name))
    try:
        yield
    finally:
        for name, module in before.items():
            if module is None:
                del sys.modules[name]
            else:
                sys.modules[name] = module
        if asked:
            checker.package_is_installed = staticmethod(asked)


def _wait_for(working, ended):
    """Wait until a thread has ended and said how; `ended` has "" where all went well, else why not."""
    wait_until(lambda: working.isFinished() and ended, "installing")
    if ended != [""]:
        raise RuntimeError(str(ended))


class SinceOne:
    """Classes that are meant to be called by others."""

    def __init__(self, route):
        import NetworkManager
        from addonmanager_installer import AddonInstaller

        # 1.0 takes the zip where there is no git; 1.1 takes it wherever it is not told otherwise.
        PREFERENCES.SetBool("disableGit", route == "zip" and VERSION < (1, 1))
        NetworkManager.InitializeNetworkManager()
        # Otherwise it asks for a newer list in the internet.
        AddonInstaller._load_local_allowed_packages_list()

    def listed(self):
        """The add-on as the list shows it. The worker's run() goes on to the catalogue in the internet."""
        from addonmanager_workers_startup import CreateAddonListWorker

        worker, found = CreateAddonListWorker(), []
        worker.current_thread = QtCore.QThread.currentThread()
        worker.addon_repo.connect(found.append, QtCore.Qt.DirectConnection)
        worker._get_custom_addons()
        return found[0]

    def install(self, addon):
        """In a thread of its own, as the button does it."""
        from addonmanager_installer import AddonInstaller

        installer, thread, ended = AddonInstaller(addon), QtCore.QThread(), []
        installer.moveToThread(thread)
        installer.success.connect(lambda _: ended.append(""))
        installer.failure.connect(lambda _, why: ended.append(why or "failed"))
        installer.finished.connect(thread.quit)
        thread.started.connect(installer.run)
        thread.start()
        _wait_for(thread, ended)

    def check(self, addon):
        from addonmanager_workers_startup import CheckSingleUpdateWorker

        CheckSingleUpdateWorker(addon).do_work()
        return addon.status().name

    def remove(self, addon):
        from addonmanager_uninstaller import AddonUninstaller

        return AddonUninstaller(addon).run()

    def dependencies(self, addon):
        """What package.xml asks for, what of it is missing, and what would be where nothing is installed."""
        from Addon import MissingDependencies

        def missing():
            if not hasattr(MissingDependencies, "import_from_addon"):
                return MissingDependencies(addon, [addon])  # 1.0
            found = MissingDependencies()
            found.import_from_addon(addon, [addon])
            return found

        here = missing()
        with nothing_installed(MissingDependencies, PACKAGES):
            elsewhere = missing()
        return {"required": sorted(addon.python_requires), "optional": sorted(addon.python_optional),
                "missing": here.python_requires + here.python_optional + here.wbs + here.external_addons,
                "elsewhere": [elsewhere.python_requires, elsewhere.python_optional]}

    def readme(self, addon):
        import addonmanager_utilities

        return addonmanager_utilities.get_readme_url(addon)

    def icon(self, addon):
        return addon.metadata.icon

class BeforeOne:
    """Workers and a window that do it all."""

    def __init__(self, route):
        import addonmanager_workers
        import NetworkManager

        NetworkManager.InitializeNetworkManager()
        # Without GitPython, which is no part of FreeCAD, it takes the zip. This is its own switch.
        addonmanager_workers.NOGIT = route == "zip"

    def listed(self):
        """The add-on as the list shows it. Lists of FreeCAD's in the internet are answered here, as empty."""
        import addonmanager_workers
        import NetworkManager

        class Offline:
            def blocking_get(self, url):
                return QtCore.QByteArray(b"{}")

        manager, NetworkManager.AM_NETWORK_MANAGER = NetworkManager.AM_NETWORK_MANAGER, Offline()
        try:
            worker, found = addonmanager_workers.UpdateWorker(), []
            worker.addon_repo.connect(found.append, QtCore.Qt.DirectConnection)
            worker.run()
        finally:
            NetworkManager.AM_NETWORK_MANAGER = manager
        return found[0]

    def install(self, addon):
        from addonmanager_workers import InstallWorkbenchWorker

        worker, ended = InstallWorkbenchWorker(addon), []
        worker.success.connect(lambda *_: ended.append(""))
        worker.failure.connect(lambda _, why: ended.append(why or "failed"))
        worker.start()
        _wait_for(worker, ended)

    def check(self, addon):
        from addonmanager_workers import CheckSingleUpdateWorker

        CheckSingleUpdateWorker(addon).do_work()
        return addon.status().name

    def remove(self, addon):
        """As its button does, in a window of which nothing else is there; the question is answered."""
        from types import SimpleNamespace

        from AddonManager import CommandAddonManager

        window = SimpleNamespace(
            dialog=Gui.getMainWindow(), remove_readonly=None, restart_required=False,
            item_model=SimpleNamespace(update_item_status=lambda *_: None),
            packageDetails=SimpleNamespace(show_repo=lambda _: None))

        def agree():
            question = QtWidgets.QApplication.activeModalWidget()
            buttons = question.findChildren(QtWidgets.QPushButton)
            next(each for each in buttons if "Yes" in each.text()).click()

        QtCore.QTimer.singleShot(300, agree)
        CommandAddonManager.remove(window, addon)
        return not os.path.exists(os.path.join(MOD, addon.name))

    def dependencies(self, addon):
        """0.20 knows no optional packages: all are asked for, by the names that they are imported by."""
        from AddonManager import CommandAddonManager

        missing = CommandAddonManager.MissingDependencies(addon, [addon])
        with nothing_installed(None, PACKAGES):
            elsewhere = CommandAddonManager.MissingDependencies(addon, [addon])
        return {"required": sorted(addon.requires),
                "missing": missing.python_required + missing.python_optional + missing.wbs,
                "elsewhere": [elsewhere.python_required, elsewhere.python_optional]}

    def readme(self, addon):
        import addonmanager_utilities

        return addonmanager_utilities.get_readme_url(addon)

    def icon(self, addon):
        return addon.metadata.Icon

def do(step, name, url, branch, route, proxy):
    """One visit to the Addon Manager.

    Parameters
    ----------
    step : str
        "install", "check", "update" or "remove".
    name, url, branch : str
        The add-on's folder, and the custom repository.
    route : str
        "git" or "zip".
    proxy : str
        "host:port", or "" for none.

    Returns
    -------
    dict
        What was seen; JSON can hold it.
    """
    PREFERENCES.SetString("CustomRepositories", f"{url} {branch}")
    PREFERENCES.SetString("force_git_in_repos", name if route == "git" else "")
    if proxy:
        PREFERENCES.SetBool("NoProxyCheck", False)
        PREFERENCES.SetBool("UserProxyCheck", True)
        PREFERENCES.SetString("ProxyUrl", proxy)
    steps = (BeforeOne if VERSION < (1, 0) else SinceOne)(route)
    addon = steps.listed()
    seen = {"before": [addon.name, addon.url, addon.branch, addon.status().name]}
    if step == "install":
        steps.install(addon)
        seen.update(workbench=addon.contains_workbench(), dependencies=steps.dependencies(addon),
                    readme=steps.readme(addon), icon=steps.icon(addon), tags=sorted(addon.tags))
    elif step == "check":
        seen["status"] = steps.check(addon)
    elif step == "update":
        seen["found"] = steps.check(addon)
        steps.install(addon)
        seen["after"] = steps.check(addon)
    elif step == "remove":
        # It was installed by a FreeCAD before: what it is, is read as the list reads it.
        addon.load_metadata_file(os.path.join(MOD, name, "package.xml"))
        seen["removed"] = steps.remove(addon)
    seen["address"] = [addon.url, addon.branch]
    return seen
