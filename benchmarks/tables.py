"""Results as tables for people: on the terminal, and in Markdown for the README."""

from collections import namedtuple
from statistics import geometric_mean

from rich.table import Table

from .targets import box_ratio, growth_exponents, place, ratio, seconds, size_class

MISSING = "-"

_VERDICT_STYLE = {"stretch": "bold green", "reached": "green", "missed": "red", "not measured": "dim"}

Column = namedtuple("Column", "title text")
"""A heading, and a function from the row of a mesh to the text under it."""


def _time(name):
    return lambda row: _number(seconds(row, name))


def _ratio(name, other):
    return lambda row: _number(ratio(row, name, other))


def _million_rays(row):
    samples, time = row["found"].get("whole", {}).get("samples"), seconds(row, "whole")
    return f"{samples / time / 1e6:.3f}" if samples and time else MISSING


def _found(name, key, form):
    def text(row):
        value = row["found"].get(name, {}).get(key)
        return MISSING if value is None else form.format(value)
    return text


def _bytes(kind):
    def text(row):
        value = row["bytes_per_triangle"].get(kind)
        return MISSING if value is None else f"{value:,.0f}"
    return text


WHICH_MESH = (
    Column("solid", lambda row: row["solid"].replace("_", " ")),
    Column("triangles", lambda row: f"{row['triangles']:,}"),
    Column("placed", lambda row: row["placement"]),
)

RAYS = (
    *WHICH_MESH,
    Column("tessel-\nlation s", _time("tessellation")),
    Column("core s", _time("core")),
    Column("core / tes-\nsellation", _ratio("core", "tessellation")),
    Column("trimesh s", _time("trimesh")),
    Column("core /\ntrimesh", _ratio("core", "trimesh")),
    Column("open3d s", _time("open3d")),
    Column("core /\nopen3d", _ratio("core", "open3d")),
    Column("whole s", _time("whole")),
    Column("bytes per\ntriangle", _bytes("core")),
)

REST = (
    *WHICH_MESH,
    Column("whole:\nsamples", _found("whole", "samples", "{:,}")),
    Column("million\nper s", _million_rays),
    Column("bytes per\ntriangle", _bytes("whole")),
    Column("box s", _time("box")),
    Column("box /\ntrimesh's", lambda row: _number(box_ratio(row), 6)),
    Column("trimesh's\nbox s", _time("trimesh_box")),
    Column("non-par-\nallel s", _time("nonparallel")),
    Column("pymeshlab s", _time("pymeshlab")),
    Column("its rays", _found("pymeshlab", "rays", "{:,}")),
    Column("pair\nloop s", _time("pair_loop")),
    Column("same as\ntrimesh", _found("trimesh", "same", "{:.2%}")),
)


def print_results(console, results):
    """Print everything.

    Parameters
    ----------
    console : rich.console.Console
    results : dict
        As `run.py` writes them, with the summary.
    """
    rows = results["meshes"]
    console.print(_mesh_table("Rays: medians of alternating turns", RAYS, rows))
    console.print(_mesh_table("The same meshes: the whole measurement, boxes, slow peers", REST, rows))
    for line in _notes(results):
        console.print(line, style="yellow", markup=False, highlight=False)
    if any(solids for _, solids in _exponents(rows)):
        console.print(_growth_table(rows))
    if results.get("command_line"):
        console.print(_command_line_table(results["command_line"]))
    console.print(_summary_table(results["summary"]))


def markdown(results):
    """The ratios by size, and the targets, as Markdown.

    Parameters
    ----------
    results : dict

    Returns
    -------
    str
    """
    ratios = (("FreeCAD's tessellation", "tessellation"), ("trimesh + embreex", "trimesh"),
              ("open3d, one core", "open3d"), ("pymeshlab, cones of rays", "pymeshlab"),
              ("all pairs, numpy", "pair_loop"))
    lines = ["| triangles, about | core s | " + " | ".join(f"core / {title}" for title, _ in ratios) + " |",
             "|---" * (len(ratios) + 2) + "|"]
    rows = results["meshes"]
    for count in sorted({size_class(row) for row in rows}):
        chosen = [row for row in rows if size_class(row) == count]
        cells = [_spread(seconds(row, "core") for row in chosen)]
        cells += [_spread(ratio(row, "core", name) for row in chosen) for _, name in ratios]
        lines.append(f"| {count:,} | " + " | ".join(cells) + " |")
    machine = results["machine"]
    lines += ["", "Geometric mean over all solids, as they lie and rotated (worst in brackets), on "
              f"{machine['cpu']}, {machine['cores']} cores.", "",
              "| target | reach | stretch | got |", "|---|---|---|---|"]
    lines += [f"| {line['what']} | {line['reach']:g} | {line['stretch']:g} | {_number(line['got'])} |"
              for line in results["summary"]]
    return "\n".join(lines)


def _number(value, digits=3):
    if value is None:
        return MISSING
    return f"{value:,.0f}" if value >= 10 ** digits else f"{value:.{digits}g}"


def _spread(values):
    values = [value for value in values if value]
    if not values:
        return MISSING
    return f"{_number(geometric_mean(values))} ({_number(max(values))})"


def _mesh_table(title, columns, rows):
    table = Table(title=title, title_justify="left")
    for column in columns:
        table.add_column(column.title, justify="left" if column.title in ("solid", "placed") else "right")
    for row in rows:
        table.add_row(*(column.text(row) for column in columns))
    return table


def _notes(results):
    """What a reader of the tables must know, one sentence each."""
    versions = results["versions"]
    if "trimesh" in versions:
        yield f"trimesh {versions['trimesh']} casts its rays with embreex {versions['embreex']}."
    cones = {(found["rays_per_vertex"], found["cone_degrees"]) for row in results["meshes"]
             if (found := row["found"].get("pymeshlab"))}
    for rays, degrees in cones:
        yield (f"pymeshlab's shape diameter function casts {rays} rays per vertex in a cone of {degrees} "
               "degrees, not one per triangle: compare its time per ray.")
    for peer, reason in results["missing_peers"].items():
        yield f"No {peer}: {reason}"
    for what, reason in results["failures"].items():
        yield f"{what}: {reason}"
    for row in results["meshes"]:
        for name, reason in row["failures"].items():
            yield f"{place(row)}, {name}: {reason}"
        if not 0.5 < row["triangles"] / row["wanted"] < 2.0 and row["placement"] == "aligned":
            yield (f"The {row['solid'].replace('_', ' ')} has no mesh of {row['wanted']:,} triangles; "
                   f"the nearest has {row['triangles']:,}.")


def _exponents(rows):
    return [(ends, growth_exponents(rows, *ends)) for ends in ((10_000, 100_000), (100_000, 1_000_000))]


def _growth_table(rows):
    table = Table(title="Growth exponents of the core", title_justify="left")
    found = [(ends, solids) for ends, solids in _exponents(rows) if solids]
    table.add_column("solid")
    for (small, large), _ in found:
        table.add_column(f"{small:,} to {large:,}", justify="right")
    for solid in dict.fromkeys(row["solid"] for row in rows):
        table.add_row(solid.replace("_", " "), *(
            f"{solids[solid]:.2f}" if solid in solids else MISSING for _, solids in found))
    return table


def _command_line_table(times):
    table = Table(title="Command line, start to end", title_justify="left")
    table.add_column("what")
    table.add_column("turns s")
    for key, values in times.items():
        table.add_row(key.replace("_", " "), "  ".join(f"{value:.2f}" for value in values))
    return table


def _summary_table(lines):
    table = Table(title="Targets", title_justify="left")
    for title in ("what", "reach", "stretch", "got", "", "where"):
        table.add_column(title, justify="right" if title in ("reach", "stretch", "got") else "left")
    for line in lines:
        style = _VERDICT_STYLE[line["verdict"]]
        got = _number(line["got"], 5 if "volume" in line["what"] else 3)
        table.add_row(line["what"], f"{line['reach']:g}", f"{line['stretch']:g}", got,
                      f"[{style}]{line['verdict']}[/]", line["where"])
    return table
