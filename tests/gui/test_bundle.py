# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD from a bundle: its Python lies in a folder of its own and has numpy and scipy alone.

The folder has a space and letters outside of ASCII in its name. Its Python is Debian's, from which the other
libraries are hidden; nothing else of a bundle is here.
"""

import os
import runpy
import shutil
import subprocess
import sys
from pathlib import Path

import FreeCAD as App
import pytest
import window_actions as window

# Fixtures, and tests that run once more, in the bundle.
from folder_dialog_use import (
    dialog, folder, many, no_choices,
)
from find_panel import classified, library, no_libraries
from test_automatic import info, label, save, wait
from test_classify import (
    test_a_worker_that_cannot_begin_is_one_sentence, test_ribbed_block as test_a_part,
)
from test_classify_folder import (
    test_a_folder_becomes_rows_counts_and_info_files as test_a_folder,
    test_pausing_and_going_on, test_the_time_limit_can_be_raised_for_those_that_failed as test_a_time_limit,
)
from test_find_libraries import (
    other_profile, test_reclassify_shows_what_would_change_and_writes_it,
)
from test_find_parts import test_criteria as test_a_library
from test_report import browser, message, opened, saved, wait_for_end
from test_show_thickness import (
    test_what_is_selected_is_measured_alone as test_a_thickness_map,
)
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.freecad_adapter.python_beside_freecad import python_environment
from thinpart_workbench.gui.processes.freecad_python import python_program
from thinpart_workbench.storage.info.info_file import read_info

BARE = Path(__file__).resolve().parents[1] / "bare_python"


@pytest.fixture(autouse=True)
def bundle(tmp_path_factory, monkeypatch):
    """A bundle that FreeCAD seems to have been started from: its folder ``usr``."""
    usr = tmp_path_factory.mktemp("bundle") / "Free CAD \u00fcn\u00ef" / "usr"
    (usr / "bin").mkdir(parents=True)
    program = usr / "bin" / "python"
    program.write_text(f'#!/bin/sh\nPYTHONPATH="{BARE}:$PYTHONPATH" exec {real_python()} "$@"\n', encoding="utf-8")
    program.chmod(0o755)
    for name in ("prefix", "base_prefix"):
        monkeypatch.setattr(sys, name, str(usr))
    monkeypatch.setattr(sys, "executable", str(usr / "bin" / "freecad"))
    before = list(sys.meta_path)
    hidden = runpy.run_path(str(BARE / "sitecustomize.py"))["HIDDEN"]
    for name in hidden:
        monkeypatch.delitem(sys.modules, name, raising=False)
    lifelong.standby_worker.end()
    yield usr
    sys.meta_path[:] = before
    lifelong.standby_worker.end()


def real_python():
    return f"/usr/bin/python{sys.version_info.major}.{sys.version_info.minor}"


def test_its_python_is_found_and_has_no_libraries(bundle):
    assert python_program() == str(bundle / "bin" / "python")
    run = subprocess.run([python_program(), "-c", "import numpy, scipy\nimport sklearn"],
                         env=python_environment(), capture_output=True, encoding="utf-8")
    assert "No module named 'sklearn'" in run.stderr


def test_freecadcmd_is_taken_where_there_is_no_python(bundle, document, monkeypatch):
    (bundle / "bin" / "python").unlink()
    # FreeCAD looks for its own folder from where it lies, so this is no copy.
    program = bundle / "bin" / "freecadcmd"
    program.write_text('#!/bin/sh\nexec freecadcmd "$@"\n')
    program.chmod(0o755)
    monkeypatch.setattr(App, "getHomePath", lambda: str(bundle) + os.sep)
    assert python_program() == str(program)
    window.add_ribbed_block(document)
    window.classify()
    assert window.text("ThinPart_Headline") == "Part with thin features"


def test_the_info_file_of_a_saved_part(saved, tmp_path):
    window.classify()
    window.wait_until(lambda: info(tmp_path / "block.FCStd").is_file())
    part, = read_info(info(tmp_path / "block.FCStd"))["parts"]
    assert part["category"] == "thin_features"


def test_on_save(document, tmp_path):
    set_preference("AutomaticClassification", True)
    try:
        window.settle(50)
        window.add_ribbed_block(document)
        save(document, tmp_path / "block.FCStd")
        wait()
        assert label() == "ThinPart: Part with thin features" and info(tmp_path / "block.FCStd").is_file()
    finally:
        set_preference("AutomaticClassification", None)
        window.settle(50)


def test_a_report(saved, browser):
    opened()
    window.click("ThinPart_ReportStart")
    wait_for_end()
    assert "The report is in" in message()
    assert len(browser.opened) == 1 and Path(browser.opened[0]).stat().st_size > 1000


def test_learning_says_what_is_missing_and_installs_nothing(tmp_path):
    window.press("ThinPart_LearnThresholds")
    window.wait_until(lambda: window.is_shown("ThinPart_LearnDialog"))
    window.widget("ThinPart_LearnFolder").setCurrentText(str(tmp_path))
    window.click("ThinPart_LearnStart")
    said = window.text("ThinPart_LearnMessage")
    assert "scikit-learn" in said and "Addon Manager" in said
    assert window.widget("ThinPart_LearnStart").isEnabled()
    assert not Path(App.getUserAppDataDir(), "AdditionalPythonPackages").exists()
