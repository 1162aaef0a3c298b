# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: one module per command, exit status 0, 1, 2, 3 (a part failed a check) or 130."""

import argparse
import importlib
import json
import os
import sys

from .. import __version__
from ..core.errors import ThinPartError
from ..core.foreign_text import printable
from ..core.message import message, with_messages
from .output_options import check_outputs
from .stop_signals import interrupting_signals

COMMANDS = {
    "classify": ("classify", "classify parts and folders of parts"),
    "report": ("report", "write pages with pictures about parts, for people to read"),
    "map": ("map", "draw the thickness map of a part, or write it as triangles with values"),
    "find": ("find", "find stored parts by category, thickness, size, words and conditions"),
    "similar": ("similar", "find parts with similar walls, fill and box"),
    "duplicates": ("duplicates", "find parts that a library has more than once: the same, mirrored, scaled, or alike"),
    "note": ("note", "show or set notes, mesh settings and link of a part"),
    "reclassify": ("reclassify", "judge stored parts by another profile, without geometry"),
    "size": ("size", "propose element sizes for a mesh that works, and try them with Gmsh"),
    "learn": ("learn", "learn thresholds from parts that people have labelled"),
    "demo": ("demo", "classify the bundled samples"),
    "gui": ("gui", "start FreeCAD with the workbench from this folder"),
    "install": ("install", "make the workbench appear in your FreeCAD"),
    "uninstall": ("install", "remove the workbench from your FreeCAD"),
    "test": ("test", "run the test suite"),
    "release": ("release", "make the tag and the zip for FreeCAD's index of add-ons"),
}
"""Command: its module in `commands`, and its description."""

ALL_CLASSIFIED, SOME_FAILED, WRONG_USAGE, INTERRUPTED = 0, 1, 2, 130


def main(arguments=None):
    """Run a command and return its exit status."""
    arguments = sys.argv[1:] if arguments is None else arguments
    for stream in (sys.stdout, sys.stderr):
        # A file name may hold bytes that are not valid text; print them as escapes.
        stream.reconfigure(errors="backslashreplace")
    try:
        parser = _parser(arguments)
        options, rest = parser.parse_known_args(arguments)
        if rest and options.command != "test":
            parser.error(f"unrecognized arguments: {' '.join(rest)}")
        options.rest = rest
        with interrupting_signals():
            check_outputs(options)
            status = options.run(options)
            sys.stdout.flush()  # here, because an error at Python's own flush would print a traceback
        return status
    except ThinPartError as error:
        return _failed(error, arguments)
    except KeyboardInterrupt:
        print("thinpart: interrupted; finished results are saved.", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # The reader of the pipe (head, less) closed it.
        _discard_output()
        return ALL_CLASSIFIED
    except OSError as error:
        sentence = _not_about_output(error)
        if sentence is not None:
            return _failed(ThinPartError(sentence), arguments)
        _discard_output()
        print(f"thinpart: The output could not be written ({error.strerror}): make room, or write it elsewhere.",
              file=sys.stderr)
        return SOME_FAILED


def _not_about_output(error):
    """The sentence for an OSError that is not about standard output; None for one that is."""
    if error.filename is not None:
        return message("{file} cannot be read or written ({problem}): check its name, its permissions and the room on its "
                       "disk.", file=error.filename, problem=error.strerror)
    if isinstance(error, FileNotFoundError):  # by os.getcwd
        return message("The current folder no longer exists: change to another one.")
    return None


def _failed(error, arguments):
    """Say why a command failed, and return its exit status."""
    if "--control" in arguments:
        failure = {"kind": error.kind, "message": str(error)}
        print(json.dumps(with_messages({"failure": failure})), file=sys.stderr)
    print(f"thinpart: {printable(str(error))}", file=sys.stderr)
    return WRONG_USAGE if error.kind in ("usage", "profile") else SOME_FAILED


def _discard_output():
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


class _Parser(argparse.ArgumentParser):
    """A parser whose sentences command no terminal: ``*`` makes arguments of all names in a folder."""

    def error(self, message):
        super().error(printable(message))


def _parser(arguments):
    parser = _Parser(
        prog="thinpart", description="Check before meshing whether a CAD part is thin, and where.",
        epilog="'thinpart COMMAND --help' lists a command's options.",
    )
    parser.add_argument("--version", action="version", version=f"ThinPart {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    command = next((argument for argument in arguments if not argument.startswith("-")), None)
    for name, (module, purpose) in COMMANDS.items():
        subparser = commands.add_parser(name, help=purpose, description=purpose.capitalize() + ".")
        if name == command:
            # Import only the command that runs, because importing the others would slow its start.
            chosen = importlib.import_module(f".commands.{module}", __name__)
            chosen.add_arguments(subparser)
            subparser.set_defaults(run=chosen.run)
    return parser
