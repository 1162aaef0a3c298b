# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proposed element sizes as printed text and as rows of a table."""

import os

from ..core.foreign_text import printable
from ..core.sizing.element_estimate import MANY_NODES
from ..core.sizing.sizing_settings import MOST_ERROR
from ..storage.part_table import SUBJECT, TableForm
from .terminal_table import TableColumn, category_style, print_table

_MESH_KEYS = ("elements", "nodes", "straightened", "gamma_least", "gamma_1_percent", "gamma_mean", "sicn_least",
              "sicn_1_percent", "sicn_mean", "poor_share", "layers_share", "seconds", "reason")
_PART_KEYS = ("category", "order", "wanted_layers", "layers", "layered_from", "global_size", "least_size", "thin_limit",
              "elements", "nodes", "error", "uniform_elements")

_IDEALISATION_KEYS = ("advice", "plate_volume_share", "plate_area_share", "width_to_thickness", "solid_elements",
                      "shell_elements")
_SHELL_KEYS = ("elements", "nodes", "size", "volume_share", "reason")


def flat_row(file, part):
    """The cells of a part in the table `SIZES`, list of str and numbers."""
    check = part["check"] or {"default": {}, "proposed": {}}
    shell = part.get("shell", {})
    cells = [file, part["name"], part["label"], *(part[key] for key in _PART_KEYS),
             *(check[mesh].get(key) for mesh in ("default", "proposed") for key in _MESH_KEYS),
             "; ".join(each["what"] for each in check["proposed"].get("tries", ())),
             *(part["idealisation"][key] for key in _IDEALISATION_KEYS), *(shell.get(key) for key in _SHELL_KEYS),
             " ".join(face for each in shell.get("left_solid", ()) for face in each["faces"])]
    return ["" if cell is None else cell for cell in cells]


SIZES = TableForm(
    (*SUBJECT, *_PART_KEYS, *(f"{mesh}_{key}" for mesh in ("default", "proposed") for key in _MESH_KEYS), "tries",
     *_IDEALISATION_KEYS, *(f"shell_mesh_{key}" for key in _SHELL_KEYS), "left_solid"),
    lambda file_and_part: flat_row(*file_and_part))
"""The CSV table of files and their parts; lengths in mm."""


def print_part(stream, file, part, budget=None):
    """Print the proposal for one part, made within a budget of elements: a sentence, its regions, and how it was meshed."""
    stream.write(_sentences(file, part) + "\n")
    if budget is not None and part["elements"] > budget:
        stream.write(f"No mesh of this part is expected to be within the budget, {budget:,}.\n")
    stream.write(_idealisation(part["idealisation"]) + "\n")
    if part["idealisation"]["no_shell"] and "shell" not in part:
        stream.write(printable(f"No shell: {part['idealisation']['no_shell']}") + "\n")
    if "shell" in part:
        stream.write(_shell(part["shell"]) + "\n")
    if budget is not None and part["elements"] <= budget < _meshed(part):
        stream.write(f"The mesh has {_meshed(part):,} elements, {_meshed(part) / budget:.2g} times the budget: Gmsh made it "
                     "finer than the sizes that were asked for. A smaller budget makes them larger.\n")
    if part["region_groups"]:
        stream.write("\n")
        print_table(stream, _REGION_COLUMNS, lambda: part["region_groups"])
    if part["check"] is not None:
        stream.write("\n")
        print_table(stream, _MESH_COLUMNS, lambda: [("one size", part["check"]["default"]),
                                                    ("proposed", part["check"]["proposed"])])
        if _was_changed(part):
            stream.write("\n" + _tries(part) + "\n")


def _meshed(part):
    return 0 if part["check"] is None else part["check"]["proposed"]["elements"]


def _was_changed(part):
    return part["check"] is not None and len(part["check"]["proposed"]["tries"]) > 1


def _tries(part):
    """How a part came to its mesh, or what was tried for it, str."""
    *failed, last = part["check"]["proposed"]["tries"]
    text = "Tried: " + "; ".join(f"{each['what']} ({each['reason']}, {each['seconds']:.2g} s)" for each in failed)
    return printable(text + (f"; {last['what']} ({last['reason']})." if last["reason"] else f". Meshed: {last['what']}."))


def print_sizes(stream, parts):
    """Print a table with a row per part: (file, part)."""
    has_check = any(part["check"] is not None for _, part in parts)
    print_table(stream, _PART_COLUMNS + (_CHECK_COLUMNS if has_check else ()), lambda: parts)


def _sentences(file, part):
    name = printable(f"{os.path.basename(file)}: {part['label']}")
    text = f"{name}: {_count(part)}, {_sizes(part)}"
    if part["nodes"] > MANY_NODES:
        triangles = part["idealisation"]["shell_elements"]
        offers = ["--budget N takes at most N elements, and says what that costs"]
        offers += [f"a shell (--shell) would take about {triangles:,} triangles"] if triangles else []
        text = f"{name}: about {part['nodes']:,} nodes, which few computers solve: {'; '.join(offers)}.\n{text}"
    if part["order"] == 1:
        text += "\nElements of first order are far too stiff in bending: take their results for thin walls as too small."
    wider = part["unbounded"]
    if wider is not None and part["error"] is not None:
        text += (f"\nThe budget costs accuracy: without it, about {wider['nodes']:,} nodes ({wider['elements']:,} "
                 f"elements), from {wider['least_size']:.3g} mm.")
    elif wider is not None and part["layers"]:
        text += (f"\nThe budget costs layers: {wider['layers']:.3g} layers in all thin walls would take about "
                 f"{wider['elements']:,} elements, from {wider['least_size']:.3g} mm.")
    if part["layered_from"]:
        text += f"\nWalls under {part['layered_from']:.3g} mm have fewer layers: they would take most of the elements."
    return text


def _count(part):
    return f"about {part['nodes']:,} nodes ({part['elements']:,} elements of {('first', 'second')[part['order'] - 1]} order)"


def _sizes(part):
    """The sizes of a part, and why they are such, str."""
    if part["least_size"] >= part["global_size"]:
        why = "no wall is thinner than {:.4g} mm".format(part["thin_limit"])
        if part["unbounded"] is not None:
            why = "the budget allows no finer one"
        elif part["left_out"]:
            walls, them = (("a thin wall of this normal part is", "it") if part["left_out"] == 1 else
                           (f"{part['left_out']} thin walls of this normal part are", "them"))
            why = f"{walls} meshed as the rest (--all-walls gives {them} layers)"
        elif part["regions"] or _was_changed(part):
            why = "nothing finer is meshed"
        elif part["error"] is not None:
            why = f"for an error of {_percent(part['error'])} it needs no finer one"
        return f"of one size, {part['global_size']:.4g} mm; {why}."
    sizes = f"from {part['least_size']:.3g} to {part['global_size']:.4g} mm"
    if part["error"] is not None:
        return f"{sizes}, for an error of {_percent(part['error'])} in deflections and frequencies."
    if not part["layers"]:
        return f"{sizes}: small where it is curved or slender, since it is not meshed with larger ones."
    return (f"{sizes}, {part['layers']:.3g} layers in walls under {part['thin_limit']:.4g} mm (one size of "
            f"{part['least_size']:.3g} mm everywhere: {part['uniform_elements']:,} elements).")


def _percent(share):
    return f"{100.0 * share:.2g} %" if share <= MOST_ERROR else f"more than {100.0 * MOST_ERROR:.2g} %"


_ADVICE = {"shell": "Shell or solid: a shell suits it", "mixed": "Shell or solid: shells for its walls, solids for the rest",
           "solid": "Shell or solid: a solid"}


def _idealisation(found):
    """Which idealisation suits a part, and the figures for both, str."""
    figures = [f"{_share(found['plate_volume_share'])} of its volume in plate-like walls"]
    if found["width_to_thickness"] is not None:
        figures.append(f"these {found['width_to_thickness']:.3g} times as wide as thick")
    text = f"{_ADVICE[found['advice']]} ({', '.join(figures)}). About {found['solid_elements']:,} elements as a solid"
    return text + (f", {found['shell_elements']:,} as a shell." if found["shell_elements"] else ".")


def _shell(shell):
    """What the shell is, or why there is none, str."""
    if not shell["elements"]:
        return printable(f"No shell: {shell['reason']}")
    thick = [wall["thickness"] for wall in shell["walls"]]
    least, most = f"{min(thick):.3g}", f"{max(thick):.3g}"
    walls = (f"a wall {most}" if len(thick) == 1 else
             f"{len(thick)} walls {most}" if least == most else f"{len(thick)} walls from {least} to {most}")
    text = (f"Shell: {shell['elements']:,} triangles of up to {shell['size']:.3g} mm, {walls} mm thick, "
            f"{_share(shell['volume_share'])} of the part's volume.")
    solid = shell["solid"]
    if solid is not None:
        text += (f"\nThe rest, {_share(solid['volume_share'])} of the volume, is solid: {solid['elements']:,} tetrahedra, "
                 f"{solid['nodes']:,} nodes, tied to the shell.")
    for each in shell["left_solid"]:
        text += f"\nLeft solid: a {each['kind']} {each['thickness']:.3g} mm thick, {printable(_some(each['faces']))}."
    return "\n".join([text, *map(printable, shell["warnings"])])


def _share(value):
    return "-" if value is None else f"{100.0 * value:.3g} %"


def _number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}"


def _outcome(figures):
    return f"{figures['elements']:,}" if figures["elements"] else f"none: {figures['reason']}"


_REGION_COLUMNS = (
    TableColumn("Region", lambda row: str(row["regions"][0]), True),
    TableColumn("Kind", lambda row: (f"{row['count']} x " if row["count"] > 1 else "") + row["word"]),
    TableColumn("Thickness mm", lambda row: _number(row["thickness"]), True),
    TableColumn("Width mm", lambda row: _number(row["width"]), True),
    TableColumn("Area mm2", lambda row: _number(row["area"]), True),
    TableColumn("Element mm", lambda row: _number(row["size"]), True),
    TableColumn("Layers", lambda row: _number(row["layers"], 2), True),
    TableColumn("Elements", lambda row: f"{row['elements']:,}", True),
    TableColumn("Faces", lambda row: _some(row["faces"])),
)

_MESH_COLUMNS = (
    TableColumn("Mesh", lambda row: row[0]),
    TableColumn("Elements", lambda row: _outcome(row[1]), True),
    TableColumn("Nodes", lambda row: f"{row[1]['nodes']:,}", True),
    TableColumn("Worst gamma", lambda row: _number(row[1]["gamma_least"]), True),
    TableColumn("Worst 1 %", lambda row: _number(row[1]["gamma_1_percent"]), True),
    TableColumn("Mean", lambda row: _number(row[1]["gamma_mean"]), True),
    TableColumn("Worst minSICN", lambda row: _number(row[1]["sicn_least"]), True),
    TableColumn("Worst 1 %", lambda row: _number(row[1]["sicn_1_percent"]), True),
    TableColumn("Mean", lambda row: _number(row[1]["sicn_mean"]), True),
    TableColumn("Under 0.3", lambda row: _share(row[1]["poor_share"]), True),
    TableColumn("Has layers", lambda row: _share(row[1]["layers_share"]), True),
    TableColumn("Seconds", lambda row: _number(row[1]["seconds"], 2), True),
)

_PART_COLUMNS = (
    TableColumn("Part", lambda row: f"{os.path.basename(row[0])}: {row[1]['label']}"),
    TableColumn("Category", lambda row: row[1]["category"], style=lambda row: category_style(row[1]["category"])),
    TableColumn("Element mm", lambda row: f"{row[1]['least_size']:.3g} to {row[1]['global_size']:.3g}", True),
    TableColumn("Layers", lambda row: _number(row[1]["layers"], 2) if row[1]["layers"] else "-", True),
    TableColumn("Elements", lambda row: f"{row[1]['elements']:,}", True),
    TableColumn("Nodes", lambda row: f"{row[1]['nodes']:,}", True),
)

_CHECK_COLUMNS = (
    TableColumn("Meshed at one size", lambda row: _outcome(row[1]["check"]["default"]), True),
    TableColumn("Under 0.3", lambda row: _share(row[1]["check"]["default"]["poor_share"]), True),
    TableColumn("Meshed as proposed", lambda row: _outcome(row[1]["check"]["proposed"]), True),
    TableColumn("Under 0.3", lambda row: _share(row[1]["check"]["proposed"]["poor_share"]), True),
    TableColumn("Has layers", lambda row: _share(row[1]["check"]["proposed"]["layers_share"]), True),
)


def _some(names, most=4):
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")
