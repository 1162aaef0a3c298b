# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart size``: element sizes that fit the walls of parts, and meshes with and without them."""

import os
import sys
from dataclasses import asdict
from pathlib import Path

from ...api.annotations import keep_mesh_settings, no_settings, settings_that_worked
from ...api.libraries import reference_part
from ...api.mesh_sizes import (
    MESH_SECONDS,
    FileChoice,
    MeshRequest,
    SizeProgress,
    check_shell_file,
    mesh_sizes,
    takes_solids,
    write_shell_file,
    write_size_script,
)
from ...core.categories import NORMAL
from ...core.errors import ThinPartError
from ...core.foreign_text import printable
from ...core.kinds.file_marks import SCRIPT, SHELLS, TABLE
from ...core.message import message
from ...core.shells.shell_settings import ShellSettings
from ...core.sizing.sizing_settings import LAYERS_OF_ORDER, SizingSettings
from ...storage.info.info_location import info_location
from ...storage.output_file import writing
from ...storage.part_table import write_table
from ..file_run import controlled_run
from ..output_options import add_output_option, check_with_documents, replacing
from ..run_options import (
    add_control_options,
    add_file_options,
    add_limit_options,
    add_measurement_options,
    limits_of,
    settings_of,
)
from ..run_report import standard_output
from ..size_text import SIZES, print_part, print_sizes


def add_arguments(parser):
    """Declare the options."""
    add_file_options(parser)
    parser.add_argument("--error", type=float, metavar="PERCENT",
                        help="the error that is aimed at, of deflections and frequencies: it decides the sizes (default: "
                             f"{100.0 * SizingSettings.error:g})")
    parser.add_argument("--layers", type=float, metavar="N",
                        help="elements through the thickness of thin walls instead; other walls have the greatest size")
    parser.add_argument("--order", type=int, choices=tuple(LAYERS_OF_ORDER),
                        help="order of the elements (default: 2); those of first order are far too stiff in thin walls, and "
                             f"have {LAYERS_OF_ORDER[1]:g} layers there by default")
    parser.add_argument("--growth", type=float, metavar="X",
                        help=f"greatest ratio of the sizes of neighbouring elements (default: {SizingSettings.growth:g})")
    parser.add_argument("--size", type=float, metavar="MM",
                        help="greatest element size (default: a tenth of the part's diagonal)")
    parser.add_argument("--budget", type=int, metavar="N",
                        help="at most so many elements: they get larger, and it says what that costs")
    parser.add_argument("--all-walls", action="store_true",
                        help="with layers: in the thin walls of normal parts too, which otherwise have one size")
    add_output_option(parser, "--geo", mark={".geo": SCRIPT}, metavar="FILE",
                      help="write the sizes of the part as a script for Gmsh, FILE.geo, which opens the part too")
    add_output_option(parser, "--shell", mark=SHELLS, metavar="FILE",
                      help="write the mid-surface of the part as triangles with the thickness of its walls, FILE.inp "
                           "(CalculiX; with what is no wall as a solid tied to it), FILE.msh (Gmsh) or FILE.unv (I-DEAS)")
    parser.add_argument("--shell-size", type=float, metavar="MM",
                        help="greatest element size of the shell (default: from the diagonal and the narrowest wall)")
    parser.add_argument("--shell-order", type=int, choices=(1, 2), default=ShellSettings.order,
                        help="order of the elements of the shell (default: %(default)s; those of first order are too stiff)")
    parser.add_argument("--part", metavar="NAME",
                        help="name or label of the part for --geo and --shell, where the document has several")
    parser.add_argument("--check", action="store_true",
                        help="mesh each part with Gmsh, at the greatest size and at the proposed ones, and compare: "
                             "elements, quality, layers in thin walls")
    parser.add_argument("--mesh-timeout", type=float, default=MESH_SECONDS, metavar="S",
                        help="time limit for each mesh, in seconds (default: %(default)g)")
    parser.add_argument("--keep", action="store_true",
                        help="with --check: keep the settings that worked with the part, in its info file")
    parser.add_argument("--like", action="append", default=[], metavar="ROOT",
                        help="take the settings that worked for this part, or for the part below this folder that is most "
                             "like it (may be repeated)")
    parser.add_argument("--info-dir", metavar="DIR",
                        help="folder of the info file for --keep and --like, if it is not beside the document")
    add_output_option(parser, "--csv", mark=TABLE, metavar="FILE", help="write one row per part to a CSV file as well")
    parser.add_argument("--force", action="store_true", help="do not take what an earlier, interrupted run has kept")
    add_measurement_options(parser)
    add_limit_options(parser)
    add_control_options(parser)


def run(options):
    """Propose sizes and return the exit status."""
    if options.keep and not options.check:
        raise ThinPartError(message("--keep goes with --check, which shows what works."), "usage")
    settings, sizes = _settings(options)
    if options.geo is not None and not options.geo.lower().endswith(".geo"):
        raise ThinPartError(message("{file} is no name for a script of Gmsh: give it the ending .geo.", file=options.geo),
                            "usage")
    shell = None
    if options.shell is not None:
        check_shell_file(options.shell)
        shell = ShellSettings(options.shell_size, options.shell_order, has_rest=takes_solids(options.shell))
    request = MeshRequest(settings, tuple(sizes.items()), options.all_walls, options.check, shell, options.mesh_timeout,
                          has_sources=options.geo is not None,
                          part=None if options.geo is None and options.shell is None else options.part or "")
    found, failed, refused = [], 0, None
    try:
        with controlled_run(options) as (report, control, _):
            for outcome in mesh_sizes(
                    options.paths, request, options.profile, analysis=settings_of(options), limits=limits_of(options),
                    files=FileChoice(options.include, options.exclude, options.force,
                                     lambda documents: check_with_documents(options, documents)),
                    control=control, progress=SizeProgress(report.started, report.counted, report.step)):
                if outcome.get("error", {}).get("kind") == "usage":
                    refused = outcome["error"]["message"]
                    continue
                failed += "error" in outcome or bool(outcome["failures"])
                found.append(outcome)
                report.failures({**outcome, "parts": [_without_places(part) for part in outcome.get("parts", ())]})
    finally:
        parts = [(outcome["file"], part) for outcome in found for part in outcome.get("parts", ())]
        if options.csv and parts:
            with writing(options.csv):
                write_table(options.csv, SIZES, [SIZES.text(parts)], **replacing(options))
        if parts and not options.json:
            with standard_output() as stream:
                if len(parts) == 1:
                    print_part(stream, *parts[0], budget=options.budget)
                else:
                    print_sizes(stream, parts)
    if refused is not None:
        raise ThinPartError(refused, "usage")
    if options.geo is not None:
        outcome, part = _chosen(options, found, options.geo)
        copy = write_size_script(options.geo, part, outcome["file"], outcome["solids"], **replacing(options))
        _say(options, message("The sizes were written to {file}: open it in Gmsh.", file=Path(options.geo).name))
        if copy is not None:
            _say(options, message("The script opens {copy}, a copy of the part beside it.", copy=copy))
    if options.shell is not None:
        part = _chosen(options, found, options.shell)[1]
        write_shell_file(options.shell, part, **replacing(options))
        _say(options, _written(Path(options.shell).name, part["shell"]))
    if options.keep:
        for file, part in parts:
            failed += not _keep(options, settings, sizes, file, part)
    return 1 if failed else 0


def _written(file, shell):
    solid = shell["solid"]
    if solid is None:
        return message("The shell was written to {file}: {elements} elements, {nodes} nodes.", file=file,
                       elements=shell["elements"], nodes=shell["nodes"])
    return message("The shell and what is solid, tied to it, were written to {file}: {elements} elements, {nodes} nodes.",
                   file=file, elements=shell["elements"] + solid["elements"], nodes=shell["nodes"] + solid["nodes"])


def _settings(options):
    """The settings, and the sizes of walls by number, that the options ask for or that worked for a part like this one."""
    given = {"order": options.order, "layers": options.layers, "growth": options.growth, "size": options.size,
             "error": None if options.error is None else 0.01 * options.error}
    if options.error is not None and (options.layers is not None or options.order == 1):
        raise ThinPartError(message("--error decides the sizes of elements of second order: leave out --layers and "
                                    "--order 1."), "usage")
    if not options.like:
        if given["error"] is None and options.layers is None:
            given["error"] = SizingSettings.error
        given["order"] = given["order"] or SizingSettings.order
        given["growth"] = given["growth"] or SizingSettings.growth
        return SizingSettings(**given, budget=options.budget), {}
    if len(options.paths) != 1 or not os.path.isfile(options.paths[0]):
        raise ThinPartError(message("--like is for one part: name one file."), "usage")
    record, _ = reference_part(options.paths[0], options.part)
    offer = settings_that_worked(record, options.like, info_location(options.paths[0], options.info_dir))
    if offer is None:
        _say(options, no_settings(record["label"]))
        offer = {"settings": {"error": SizingSettings.error}, "sizes": ()}
    else:
        _say(options, message("Settings that worked for {part} ({alike:.0f} % alike) in {file}.", part=offer["label"],
                              alike=offer["alike"], file=offer["file"]))
    known = {key: value for key, value in offer["settings"].items() if value is not None}
    wanted = {**known, **{key: value for key, value in given.items() if value is not None}}
    if options.error is not None or options.order not in (None, known.get("order")) and options.layers is None:
        wanted.pop("layers", None)  # those of the other order
    if options.error is not None:
        wanted["order"] = 2
    if options.layers is not None:
        wanted.pop("error", None)
    return SizingSettings(**{"error": None, **wanted, "budget": options.budget}), dict(map(tuple, offer["sizes"]))


def _keep(options, settings, sizes, file, part):
    """Keep what worked for a part; whether that was possible."""
    figures = part["check"]["proposed"]
    if not figures["elements"]:
        return True
    rows = [{"kind": row["kind"], "thickness": row["thickness"], "size": row["size"],
             "is_changed": part["category"] == NORMAL or any(number - 1 in sizes for number in row["regions"])}
            for row in part["region_groups"]]
    try:
        keep_mesh_settings(file, part["name"], asdict(settings), part["global_size"], part["diagonal"], rows, figures,
                           options.info_dir)
    except ThinPartError as error:
        print(printable(error), file=sys.stderr)
        return False
    _say(options, message("The settings were kept with {part}.", part=part["label"]))
    return True


def _without_places(part):
    """What is proposed for a part, without the places that scripts are made of, and the nodes of its shell."""
    shown = {key: value for key, value in part.items() if key not in ("sources", "box", "inner", "mended_shape")}
    if "shell" in shown:
        shown["shell"] = {key: value for key, value in shown["shell"].items()
                          if key not in ("points", "triangles", "wall", "thickness")}
        if shown["shell"]["solid"] is not None:
            shown["shell"]["solid"] = {key: shown["shell"]["solid"][key] for key in ("nodes", "elements", "volume_share")}
    return shown


def _chosen(options, found, path):
    """The outcome and the part that a file is for."""
    files = [outcome for outcome in found if outcome.get("parts")]
    chosen = [(outcome, part) for outcome in files for part in outcome["parts"]
              if options.part in (None, part["name"], part["label"])]
    if not chosen:
        raise ThinPartError(message("There is no part that could be written to {file}.", file=path), "empty")
    if len(chosen) > 1:
        raise ThinPartError(message("{file} is for one part, and there are {count}: name one after --part, as {example}.",
                                    file=path, count=len(chosen), example=chosen[0][1]["label"]), "usage")
    return chosen[0]


def _say(options, sentence):
    if not options.json:
        print(printable(sentence))
