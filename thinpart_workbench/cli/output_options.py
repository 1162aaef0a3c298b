# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that name output files, and the check, before anything is measured, that these replace nothing of the user's."""

import os

from ..core.errors import ThinPartError
from ..core.message import message
from ..storage.output_file import check_output, writing

FOLDER = object()
"""Stands for the mark of a folder of files, each of which is checked when it is written; see `ReportFolder`."""


def add_output_option(parser, *names, mark, **settings):
    """Declare an option that names an output file, and --overwrite.

    Parameters
    ----------
    parser : ArgumentParser
    *names : str
        Of the option.
    mark : HeadMark, SealedHead, JsonMark, SealMark or dict
        What a file bears that may be replaced; by ending, where the option takes several formats; or `FOLDER`.
    **settings
        See `ArgumentParser.add_argument`.
    """
    outputs = parser.get_default("outputs") or {}
    option = parser.add_argument(*names, **settings)
    if not outputs:
        parser.add_argument("--overwrite", action="store_true",
                            help="replace output files that ThinPart did not write; never CAD files, inputs or info files")
    parser.set_defaults(outputs={**outputs, option.dest: mark})


def check_outputs(options):
    """Check all files that a command is to write; see `replacing`.

    Raises ThinPartError, kind ``usage`` if one may not be replaced, or two are the same; ``failed`` if one cannot be
    written.
    """
    files = {}
    for name, mark in getattr(options, "outputs", {}).items():
        file = getattr(options, name)
        if not file or mark is FOLDER:
            continue
        if isinstance(mark, dict):
            mark = mark.get(os.path.splitext(file)[1].lower())
            if mark is None:
                continue  # the command says which endings there are
        with writing(file):
            check_output(file, mark, **replacing(options))
        if files.setdefault(os.path.normcase(os.path.realpath(file)), name) != name:
            raise ThinPartError(message("{file} is named for two outputs: name another file for one of them.", file=file),
                                "usage")


def check_with_documents(options, documents):
    """Check the outputs again, when the documents in the folders that the options name are known: iterable of str."""
    if options.overwrite:  # else only a file with ThinPart's mark is replaced, and no document has it
        options.documents = list(documents)
        check_outputs(options)


def replacing(options):
    """The arguments ``overwrite`` and ``inputs`` of functions that write the outputs of a command: dict."""
    named = [each for name, value in vars(options).items() if name not in ("documents", *options.outputs)
             for each in (value if isinstance(value, list) else [value])]
    # Whatever else names a file is read: parts, labels, profiles, limits, lists.
    inputs = [each for each in named if isinstance(each, str) and os.path.isfile(each)]
    return {"overwrite": options.overwrite, "inputs": [*inputs, *getattr(options, "documents", ())]}
