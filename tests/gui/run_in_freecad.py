# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the tests of the window inside the real FreeCAD, on a screen of their own.

    python3 tests/gui/run_in_freecad.py [OPTIONS] [PYTEST ARGUMENTS]
    python3 tests/gui/run_in_freecad.py --close part|folder|library|document
    python3 tests/gui/run_in_freecad.py [OPTIONS] --screenshots docs/screenshots
    python3 tests/gui/run_in_freecad.py --every-look FOLDER [LOOK...]

The last writes a picture of every panel, dialog and page for each language, scale, theme and unit: see EVERY_LOOK.

Options: --language German starts FreeCAD in that language, --scale 1.5 draws everything larger,
--theme "FreeCAD Dark" takes the colours of one of FreeCAD's own preference packs, --quick leaves out the
tests that tests/long_tests.txt names, --again runs a few tests that fail once more in a FreeCAD of their own and says which
passed only there.

The status is pytest's; a FreeCAD that crashes, hangs or ends without a complete report is a
failure of the test that it did last, and the others go on in a new one. After all tests of the window, those of
the translations run in a FreeCAD that starts in German and goes on to the other languages, and FreeCAD is closed while
it measures a part, a folder and a document that was just saved, and while it reads a library.
"""

import argparse
import compileall
import json
import os
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import NamedTuple

from virtual_screen import virtual_screen

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, os.fspath(ROOT))

from thinpart_workbench.cli.commands.test import AGAIN, MOST_AGAIN, failed_tests  # noqa: E402

SECONDS = 4800
LIVES = 8
"""FreeCADs that may die before nothing more is tried."""
TRANSLATED = "German"
"""The language of a start that is not English; test_translations.py goes on to the others."""
CLOSED_WHILE = ("part", "folder", "library", "document")

NOTHING_LEFT = 5
WRONG_USAGE = 4
"""What pytest's statuses mean."""

THEMES = "/usr/share/freecad/Gui/PreferencePacks"


class Look(NamedTuple):
    """FreeCAD's language, how much larger everything is drawn, the preference pack with its colours, and whether numbers are
    written as in that language, such as 0,5 instead of 0.5."""

    language: str = "English"
    scale: float = 1.0
    theme: str = ""
    own_numbers: bool = False


PLAIN = Look()

EVERY_LOOK = {
    "english": (PLAIN, "mm"),
    "inches": (PLAIN, "inches"),
    "german": (Look("German"), "mm"),
    "french": (Look("French"), "mm"),
    "german-commas": (Look("German", own_numbers=True), "mm"),
    "french-commas-inches": (Look("French", own_numbers=True), "inches"),
    "light": (Look(theme="FreeCAD Light"), "mm"),
    "dark": (Look(theme="FreeCAD Dark"), "mm"),
    "150": (Look(scale=1.5), "mm"),
    "200": (Look(scale=2.0), "mm"),
    "german-dark-150-inches": (Look("German", 1.5, "FreeCAD Dark", True), "inches"),
}
"""How each picture of --every-look looks, by its name, and its unit of length: each once, and all together."""


def run(script, arguments, home, seconds=SECONDS, look=PLAIN):
    """Run a script inside FreeCAD, with settings and folders that nobody else uses.

    Parameters
    ----------
    script : Path
    arguments : list or dict
        The script finds them, as JSON, in the environment's THINPART_GUI_ARGUMENTS.
    home : Path
        An empty folder.
    look : Look

    Returns
    -------
    int
        Exit status; 124 where it took too long.
    """
    runtime = home / "runtime"
    runtime.mkdir(mode=0o700)
    temporary = home / "temporary"
    temporary.mkdir()
    settings = home / "user.cfg"
    settings.write_text((HERE / "user.cfg").read_text(encoding="utf-8").replace(
        "LANGUAGE", look.language).replace("NUMBERS", str(int(look.own_numbers))), encoding="utf-8")
    if look.theme:
        _add_theme(settings, look.theme)
    environment = dict(
        os.environ, HOME=os.fspath(home), XDG_RUNTIME_DIR=os.fspath(runtime),
        XDG_CONFIG_HOME=os.fspath(home), XDG_DATA_HOME=os.fspath(home), TMPDIR=os.fspath(temporary),
        LC_ALL="C.UTF-8", THINPART_GUI_ARGUMENTS=json.dumps(arguments), PYTHONDONTWRITEBYTECODE="1",
        QT_SCALE_FACTOR=str(look.scale),
    )
    for name in ("WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        environment.pop(name, None)
    # FreeCAD's own options come after the script; before it, they would be taken for Python's.
    command = ["timeout", "--kill-after=10", str(seconds), "freecad", os.fspath(script),
               "-u", os.fspath(settings), "-M", os.fspath(ROOT)]
    with open(home / "freecad.log", "w", encoding="utf-8") as log, virtual_screen(
            round(1400 * look.scale), round(900 * look.scale)) as display:
        return subprocess.run(command, env=dict(environment, DISPLAY=display), stdin=subprocess.DEVNULL,
                              stdout=log, stderr=subprocess.STDOUT, cwd=ROOT).returncode


def _add_theme(settings, name):
    """Add what a preference pack of this FreeCAD says to settings: what choosing the theme does."""
    into = ElementTree.parse(settings)
    pack = ElementTree.parse(os.path.join(THEMES, name, f"{name}.cfg"))
    _add_settings(into.getroot(), pack.getroot())
    into.write(settings, encoding="UTF-8", xml_declaration=True)


def _add_settings(into, more):
    there = {(each.tag, each.get("Name")): each for each in into}
    for each in more:
        old = there.get((each.tag, each.get("Name")))
        if each.tag == "FCParamGroup" and old is not None:
            _add_settings(old, each)
        else:
            into.append(each)


def main(arguments):
    """Run the tests, or make the screenshots, and return the status."""
    parser = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    parser.add_argument("--screenshots")
    parser.add_argument("--every-look")
    parser.add_argument("--close", choices=CLOSED_WHILE)
    parser.add_argument("--language", default=PLAIN.language)
    parser.add_argument("--scale", type=float, default=PLAIN.scale)
    parser.add_argument("--theme", default=PLAIN.theme)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--quick", action="store_true")
    options, rest = parser.parse_known_args(arguments)
    look = Look(options.language, options.scale, options.theme)
    # FreeCAD starts hundreds of processes that measure, none of which keeps what it has compiled.
    compileall.compile_dir(ROOT / "thinpart_workbench", quiet=2)
    if options.screenshots:
        return _in_a_home(lambda home: _make_screenshots(Path(options.screenshots), home, look))
    if options.every_look:
        return max(_in_a_home(lambda home, name=name: _make_contact_sheet(Path(options.every_look), home, name))
                   for name in rest or EVERY_LOOK)
    everything = not {*arguments} - {"--again", "--quick"}
    if options.quick:
        rest.append("--quick")
    status = 0 if options.close else _run_tests(rest, look, options.again)
    if status == 0 and everything:
        status = _run_tests([os.fspath(HERE / "test_translations.py")], Look(TRANSLATED), options.again)
    for what in CLOSED_WHILE:
        if status == 0 and (everything or options.close == what):
            with tempfile.TemporaryDirectory(prefix="thinpart-gui-") as home:
                status = _closes_cleanly(Path(home), what)
    return status


def _in_a_home(do):
    with tempfile.TemporaryDirectory(prefix="thinpart-gui-", ignore_cleanup_errors=True) as home:
        return do(Path(home))


def _make_screenshots(folder, home, look):
    folder = folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    arguments = [os.fspath(HERE), os.fspath(folder)]
    return _shown(run(HERE / "make_screenshots.py", arguments, home, look=look), home)


def _make_contact_sheet(folder, home, name):
    look, unit = EVERY_LOOK[name]
    folder.mkdir(parents=True, exist_ok=True)
    arguments = [os.fspath(HERE), os.fspath(folder.resolve() / f"{name}.png"), unit]
    return _shown(run(HERE / "make_contact_sheet.py", arguments, home, look=look), home)


def _run_tests(arguments, look, again=False):
    """Run tests, where asked for those that failed once more in a FreeCAD of their own; pytest's status, or 1."""
    with tempfile.TemporaryDirectory(prefix="thinpart-tests-") as cache:
        arguments = ["-o", f"cache_dir={cache}", *_with_path(arguments)]
        status, died = _run_all(arguments, look)
        failed = failed_tests(cache) if again and status == 1 and not died else []
        if not 0 < len(failed) <= MOST_AGAIN:
            return status
        print(AGAIN.format("\n".join(failed)), flush=True)
        return _run_all([*arguments, "--last-failed"], look)[0]


def _run_all(arguments, look):
    """Run tests in one FreeCAD, and in another what is left when it has died: (pytest's status or 1, whether it died)."""
    done, died = [], []
    end = time.monotonic() + SECONDS

    def go_on(home):
        return _run_once(arguments, done, home, look, end - time.monotonic())

    while True:
        status, ended, last = _in_a_home(go_on)
        if last is None:
            break
        died.append(last or "before the first test")
        if not last or len(died) == LIVES or time.monotonic() > end:
            break
        done += [*ended, last]
    if died:
        print(f"FreeCAD died in {len(died)} tests" + (":" if last is None else ", and what is left was not tried:"))
        print("\n".join(died), flush=True)
    return 1 if died and status in (0, NOTHING_LEFT) else status, bool(died)


def _run_once(arguments, done, home, look, seconds):
    """(status, tests that have ended, the test in which FreeCAD died or "" where none had begun, None where it did not)."""
    report = home / "report.xml"
    given = {"pytest": ["--junitxml", os.fspath(report), *arguments], "done": done}
    status = run(HERE / "start_pytest.py", given, home, max(1, round(seconds)), look)
    whole = _is_complete(report) or not _text(home / "tests.txt") and status in (NOTHING_LEFT, WRONG_USAGE)
    if not whole:
        # pytest would have told them at its end.
        print(_text(home / "failures.txt"), end="")
    _shown(status, home)
    began, ended = ([line.partition(" ")[2] for line in _text(home / "tests.txt").splitlines()
                     if line.startswith(word)] for word in ("began", "ended"))
    if whole:
        return status, ended, None
    print(f"FreeCAD has died{' in ' + began[-1] if began else ''} (status {status}); "
          f"{len(ended)} tests had ended.", flush=True)
    return status or 1, ended, began[-1] if began else ""


def _closes_cleanly(home, what):
    """0 where a FreeCAD that is closed while it works ends and leaves nothing behind, or 1."""
    status = _shown(run(HERE / "close_while_working.py", [os.fspath(HERE), what], home, 120), home)
    left = [each.name for each in (home / "temporary").glob("thinpart-*")]
    left += _working(os.fspath(home))
    if what == "folder" and not _some_are_done(home / "parts"):
        left.append("no info files, or unfinished ones")
    if what == "library":
        kept = _text(home / "parts" / "block.step.thinpart.json")
        left += [f"{what} that nobody has kept" for what in ("written last", "Anna", "Bert") if what not in kept]
    print(f"Closed while working on a {what}: " + (
        "left behind " + ", ".join(left) if left else f"status {status}, nothing left behind."))
    return 1 if status or left else 0


def _working(home):
    """Command lines of processes of this home that measure.

    The screen's own server has this home too, and takes a moment to end.
    """
    for process in Path("/proc").glob("[0-9]*"):
        command = _text(process / "cmdline").replace("\0", " ")
        if home in _text(process / "environ") and any(
                each in command for each in (
                    "snapshot_worker", "classify", " report ", "multiprocessing", "library_worker",
                    "request_worker")):
            yield command


def _some_are_done(parts):
    """Whether some of the documents, and not all, have an info file, each of them whole."""
    files = list(parts.glob("*.thinpart.json"))
    whole = [json.loads(each.read_text(encoding="utf-8"))["parts"] for each in files]
    return 0 < len(whole) < len(list(parts.glob("*.FCStd"))) and all(whole)


def _text(file):
    try:
        return file.read_text(errors="replace")
    except OSError:
        return ""  # a process that has ended meanwhile


def _with_path(arguments):
    """All tests of the window, unless some are named."""
    named = [each for each in arguments if (ROOT / each.partition("::")[0]).exists()]
    return arguments if named else [*arguments, os.fspath(HERE)]


def _shown(status, home):
    """Print what came out of FreeCAD and pass the status on."""
    output = home / "output.txt"
    if output.is_file():
        print(output.read_text(encoding="utf-8", errors="replace"))
    if status:
        print(f"FreeCAD ended with status {status}. Its last words:")
        print((home / "freecad.log").read_text(encoding="utf-8", errors="replace")[-4000:])
    return status


def _is_complete(report):
    """Whether pytest came to its end and wrote a report with at least one test."""
    try:
        suites = list(ElementTree.parse(report).getroot().iter("testsuite"))
    except (OSError, ElementTree.ParseError):
        return False
    return sum(int(suite.get("tests", 0)) for suite in suites) > 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
