"""The command line: one module per command, exit status 0, 1, 2 or 130."""

import argparse
import importlib
import os
import sys

from .. import __version__
from ..core.errors import ThinPartError
from .terminal_table import printable

COMMANDS = {
    "classify": ("classify", "classify parts and folders of parts"),
    "report": ("report", "write pages with pictures about parts, for people to read"),
    "find": ("find", "find stored parts by category, thickness, size, words and conditions"),
    "similar": ("similar", "find parts with similar walls, fill and box"),
    "note": ("note", "show or set what is kept with a part"),
    "reclassify": ("reclassify", "judge stored parts by another profile, without geometry"),
    "demo": ("demo", "classify the bundled samples"),
    "gui": ("gui", "start FreeCAD with the workbench from this folder"),
    "install": ("install", "make the workbench appear in your FreeCAD"),
    "uninstall": ("install", "take the workbench out of your FreeCAD again"),
    "test": ("test", "run the test suite"),
}
"""Command: its module here, and what it does."""

ALL_CLASSIFIED, SOME_FAILED, WRONG_USAGE, INTERRUPTED = 0, 1, 2, 130


def main(arguments=None):
    """Run a command and return its exit status."""
    arguments = sys.argv[1:] if arguments is None else arguments
    for stream in (sys.stdout, sys.stderr):
        # A file name may hold bytes that are no text; they are printed as escapes.
        stream.reconfigure(errors="backslashreplace")
    parser = _parser(arguments)
    options, rest = parser.parse_known_args(arguments)
    if rest and options.command != "test":
        parser.error(f"unrecognized arguments: {' '.join(rest)}")
    options.rest = rest
    try:
        status = options.run(options)
        sys.stdout.flush()  # at its own end, Python would print a traceback
        return status
    except ThinPartError as error:
        print(f"thinpart: {printable(str(error))}", file=sys.stderr)
        return WRONG_USAGE if error.kind in ("usage", "profile") else SOME_FAILED
    except KeyboardInterrupt:
        print("thinpart: interrupted; what was done is kept.", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # The reader of a pipe (head, less) has seen enough.
        _forget_output()
        return ALL_CLASSIFIED
    except OSError as error:
        # What fails at a file has its name, and a sentence where it was opened.
        if error.filename is not None:
            raise
        _forget_output()
        print(f"thinpart: The output could not be written ({error.strerror}): make room, or write it elsewhere.",
              file=sys.stderr)
        return SOME_FAILED


def _forget_output():
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _parser(arguments):
    parser = argparse.ArgumentParser(
        prog="thinpart", description="Tells before meshing whether a CAD part is thin, and where.",
        epilog="'thinpart COMMAND --help' lists a command's options.",
    )
    parser.add_argument("--version", action="version", version=f"ThinPart {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    wanted = next((each for each in arguments if not each.startswith("-")), None)
    for name, (module, purpose) in COMMANDS.items():
        subparser = commands.add_parser(name, help=purpose, description=purpose.capitalize() + ".")
        if name == wanted:
            # Only the command that runs is imported: the others' imports would slow its start.
            chosen = importlib.import_module(f".{module}", __name__)
            chosen.add_arguments(subparser)
            subparser.set_defaults(run=chosen.run)
    return parser
