# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart learn``: thresholds from parts that people have labelled, and how good they are."""

import argparse

from ...api.learning import ERROR, LABELLING_LIMITS, export_labels, label_by_meshing, label_by_solver, learn
from ...core.analysis_settings import DEFAULT_PROFILE
from ...core.descriptors.automatic_mesh import AUTOMATIC_SHARE
from ...core.errors import ThinPartError
from ...core.foreign_text import json_text, printable
from ...core.kinds.file_marks import LABELS, PROFILE
from ...core.run_control import RunControl
from ..labelling_text import labelling_progress, print_labelling
from ..learned_text import print_learned
from ..output_options import add_output_option, replacing
from ..run_options import add_limit_options, limits_of
from ..stop_signals import stop_signals


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("library", metavar="LIBRARY", help="folder with info files, as classify writes them")
    parser.add_argument("--labels", action="append", default=[], metavar="FILE",
                        help="CSV with the columns file and category, and as you like part, person, sure, second, group; "
                             "may be given several times")
    parser.add_argument("--kept-labels", action=argparse.BooleanOptionalAction, default=True,
                        help="take the labels too that people keep in the info files, by the window or by 'note --label' "
                             "(default), or not")
    add_output_option(parser, "--export-labels", mark=LABELS, metavar="FILE",
                      help="only write all these labels as one CSV file")
    program = parser.add_mutually_exclusive_group()
    program.add_argument("--from-meshing", action="store_true",
                         help="label the parts of LIBRARY by Gmsh instead, without a person: mesh them, say how well each "
                              "quantity foretells trouble, and learn from these labels if there is -o; --export-labels "
                              "writes them")
    program.add_argument("--from-solver", action="store_true",
                         help="the same by CalculiX: normal is what the automatic mesh gets right, by its first six elastic "
                              "frequencies")
    size = parser.add_mutually_exclusive_group()
    size.add_argument("--mesh-size", type=float, metavar="SHARE",
                      help="with --from-solver: greatest size of the elements, as a share of the diagonal "
                           f"(default: {AUTOMATIC_SHARE:g})")
    size.add_argument("--mesh-size-mm", type=float, metavar="MM", help="with --from-solver: the same in mm")
    parser.add_argument("--error", type=float, metavar="SHARE",
                        help="with --from-solver: error of the frequencies up to which a mesh is right "
                             f"(default: {ERROR:g})")
    add_limit_options(parser, LABELLING_LIMITS, "with --from-meshing or --from-solver: ")
    parser.add_argument("--profile", default=DEFAULT_PROFILE, metavar="NAME-or-FILE",
                        help="where to start: its categories, criteria and quantities are taken (default: %(default)s)")
    add_output_option(parser, "-o", "--output", mark=PROFILE, metavar="FILE",
                      help="write the new profile; otherwise it is only described")
    parser.add_argument("--json", action="store_true", help="print the result as one JSON object")


def run(options):
    """Learn and return the exit status."""
    if _solver_options(options) and not options.from_solver:
        raise ThinPartError("--mesh-size, --mesh-size-mm and --error belong to --from-solver: leave them out.", "usage")
    if options.from_meshing or options.from_solver:
        return _label(options)
    if options.export_labels is not None:
        return _export(options)
    learned = learn(options.library, options.labels, options.profile, kept_labels=options.kept_labels,
                    output=options.output, **replacing(options))
    if options.json:
        print(json_text(learned.as_dict()))
    else:
        print_learned(learned, options.output)
    return 0


def _solver_options(options):
    given = {"size": options.mesh_size, "size_mm": options.mesh_size_mm, "error": options.error}
    return {name: value for name, value in given.items() if value is not None}


def _label(options):
    name, label_by = ("--from-solver", label_by_solver) if options.from_solver else ("--from-meshing", label_by_meshing)
    if options.labels:
        raise ThinPartError(f"{name} stands instead of --labels: leave one of them out.", "usage")
    control = RunControl()
    with stop_signals(control), labelling_progress() as report:
        labels = label_by(options.library, options.profile, limits_of(options), output=options.export_labels,
                          control=control, report=report, **_solver_options(options), **replacing(options))
    learned = None
    if options.output is not None:
        learned = learn(options.library, labels, options.profile, kept_labels=False, output=options.output,
                        **replacing(options))
    if options.json:
        content = labels.as_dict()
        if learned is not None:
            content["learned"] = learned.as_dict()
        print(json_text(content))
    else:
        print_labelling(labels, options.export_labels)
        if learned is not None:
            print()
            print_learned(learned, options.output)
    return 1 if labels.failures else 0


def _export(options):
    if options.output is not None:
        raise ThinPartError("--export-labels learns nothing: leave -o out.", "usage")
    count = export_labels(options.library, options.export_labels, options.labels, options.profile,
                          kept_labels=options.kept_labels, **replacing(options))
    if options.json:
        print(json_text({"labels": count, "file": options.export_labels}))
    else:
        print(f"{count} labels were written to {printable(options.export_labels)}.")
    return 0
