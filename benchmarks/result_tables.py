# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as tables."""

from collections import namedtuple
from statistics import geometric_mean, median

from .meshing_tables import meshing_tables, meshing_target_tables
from .table_text import MISSING, Table, number, percent
from .targets import box_ratio, growth_exponents, place, ratio, seconds, size_class, time_ratio
from .verdict_times import BARE, ONE_CORE, TABLE, TWO_CORES

Column = namedtuple("Column", "title text")
"""A heading, and a function from the row of a mesh to the text under it."""

RIVALS = (("FreeCAD's tessellation", "tessellation"), ("Embree alone", "embreex"), ("trimesh + embreex", "trimesh"),
          ("open3d, one core", "open3d"), ("pymeshlab, cones of rays", "pymeshlab"), ("all pairs, numpy", "pair_loop"))


def _time(name):
    return lambda row: number(seconds(row, name))


def _ratio(name, other):
    return lambda row: number(ratio(row, name, other))


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
    Column("tessellation s", _time("tessellation")),
    Column("core s", _time("core")),
    Column("core / tessellation", _ratio("core", "tessellation")),
    Column("embree s", _time("embreex")),
    Column("core / embree", _ratio("core", "embreex")),
    Column("trimesh s", _time("trimesh")),
    Column("core / trimesh", _ratio("core", "trimesh")),
    Column("open3d s", _time("open3d")),
    Column("core / open3d", _ratio("core", "open3d")),
    Column("whole s", _time("whole")),
)

REST = (
    *WHICH_MESH,
    Column("bytes, core", _bytes("core")),
    Column("bytes, whole", _bytes("whole")),
    Column("samples", _found("whole", "samples", "{:,}")),
    Column("million per s", _million_rays),
    Column("box s", _time("box")),
    Column("box / trimesh's", lambda row: number(box_ratio(row), 6)),
    Column("trimesh's box s", _time("trimesh_box")),
    Column("nonparallel s", _time("nonparallel")),
    Column("pymeshlab s", _time("pymeshlab")),
    Column("pair loop s", _time("pair_loop")),
    Column("same as trimesh", _found("trimesh", "same", "{:.2%}")),
)


def mesh_tables(results):
    """Everything that was measured on meshes, a row per mesh; list of Table."""
    rows = results.get("meshes") or []
    if not rows:
        return []
    return [_of_meshes("Rays: medians of alternating turns", RAYS, rows),
            _of_meshes("The same meshes: memory per triangle, the whole measurement, boxes, slow peers", REST, rows)]


def ray_tables(results):
    """The core against its peers, a row per size; list of Table."""
    rows, missing = results.get("meshes") or [], results.get("missing_peers") or {}
    if not rows:
        return []
    rivals = [(title, name) for title, name in RIVALS if name in missing or any(seconds(row, name) for row in rows)]
    content = []
    for count, chosen in _by_size(rows):
        cells = ["not installed" if name in missing else _spread(ratio(row, "core", name) for row in chosen)
                 for _, name in rivals]
        content.append([f"{count:,}", _spread(seconds(row, "core") for row in chosen), *cells])
    notes = ["Geometric mean over all solids, as they lie and rotated (worst in brackets); " + where(results)]
    notes += [f"No {peer}: {reason}" for peer, reason in missing.items()]
    return [Table("The core against its peers", ["triangles, about", "core s", *(f"core / {title}" for title, _ in rivals)],
                  content, notes)]


def growth_tables(results):
    """How time grows with the mesh, and what a second core gives; list of Table."""
    rows = results.get("meshes") or []
    if not rows:
        return []
    content = []
    for count, chosen in _by_size(rows):
        own = [f"{count:,}"]
        for name in ("core", "whole"):
            own.append(_spread(1e6 * value / row["triangles"] for row in chosen if (value := seconds(row, name))))
        own += [_spread(ratio(row, f"{name}_on_1", f"{name}_on_2") for row in chosen) for name in ("core", "whole")]
        content.append(own)
    exponents = [f"Growth exponent of the core from {small:,} to {large:,} triangles: {_exponents(found)}."
                 for small, large in ((1_000, 10_000), (10_000, 100_000), (100_000, 1_000_000))
                 if (found := growth_exponents(rows, small, large))]
    notes = ["1 is linear. Microseconds per triangle, and the time on one core over that on two; geometric mean, worst in "
             "brackets; " + where(results)]
    return [Table("Growth", [
        "triangles, about", "core, µs", "whole, µs", "core, 1 core / 2 cores", "whole, 1 core / 2 cores"],
        content, [*notes, *exponents])]


def verdict_tables(results):
    """The whole program against a bare process, a row per set of files; list of Table."""
    sets = results.get("verdicts") or []
    if not sets:
        return []
    content = []
    for each in sets:
        bare, one = (median(each["seconds"][key]) for key in (BARE, ONE_CORE))
        stages = each["stages"]
        content.append([
            each["name"], f"{each['files']:,}", f"{each['triangles']:,}", number(bare), number(one),
            number(time_ratio(each, ONE_CORE, BARE)), number(time_ratio(each, TWO_CORES, BARE)),
            percent((stages["read"] + stages["tessellate"]) / one, 0), percent(stages["measure"] / one, 0),
        ])
    notes = ["Whole processes from start to end, in turns; ThinPart from nothing, with info files and pictures, one file at "
             "a time, two on two cores; " + where(results)]
    table = next((each["seconds"][TABLE] for each in sets if TABLE in each["seconds"]), None)
    if table:
        notes.append(f"One small STEP file from the start to the table: {number(median(table))} s.")
    notes += [f"Of the {each['name']}, {each['failed'][ONE_CORE]} files failed in ThinPart and {each['failed'][BARE]} in "
              "the bare process." for each in sets if any(each["failed"].values())]
    return [Table("Time to a verdict against reading and tessellating", [
        "what", "files", "triangles", "bare process s", "ThinPart s", "ThinPart / bare", "two cores / bare",
        "of it reading and tessellating", "measuring"], content, notes)]


def group_tables(results):
    """The same by size, family and format; list of Table."""
    content = [
        [each["name"], group["by"], _group_name(group), f"{group['files']:,}", number(group[BARE]), number(group[ONE_CORE]),
         number(group[ONE_CORE] / group[BARE]) if group[BARE] else MISSING]
        for each in results.get("verdicts") or [] for group in each["groups"]
    ]
    if not content:
        return []
    return [Table("The same by size, family and format", [
        "what", "by", "group", "files", "bare process s", "ThinPart s", "ThinPart / bare"], content,
        ["Sizes are triangles of the bare process. Start-up is left out; " + where(results)])]


def accuracy_tables(results):
    """Each accuracy against the reference: verdicts, and a table of quantities for each folder and accuracy."""
    found = [each for each in results.get("accuracy") or [] if each["parts"]]
    if not found:
        return []
    tables = [Table("Accuracy: verdicts", [
        "folder", "accuracy", "parts", "verdicts that differ", "of them borderline", "by the paper", "of them borderline",
        "s", "reference s"], [_accuracy_row(each) for each in found], ["Seconds of all parts; " + where(results)])]
    return tables + [Table(f"Accuracy: {each['folder']}, {each['level']}", [
        "quantity", "parts", "median", "97 %", "greatest", "within 0.005", "within 0.015", "stated error, median",
        "covers the difference"], [_quantity_row(row) for row in each["quantities"]], list(_accuracy_notes(each)))
        for each in found]


def _accuracy_row(each):
    verdicts = [str(count[key]) for count in each["verdicts"].values() for key in ("differ", "borderline")]
    return [each["folder"], each["level"], str(each["parts"]), *verdicts, number(each["seconds"]),
            number(each["reference_seconds"]) if each["reference_seconds"] else "kept"]


def _quantity_row(row):
    stated = row["stated"] or {}
    return [row["name"], str(row["parts"]), *(_difference(row[key]) for key in ("median", "most", "greatest")),
            *(percent(share) for share in row["close"]), _difference(stated.get("median")), percent(stated.get("covers"))]


def _accuracy_notes(each):
    reference = each["reference"]
    yield (f"{each['folder'].capitalize()}, {each['level']}: absolute differences from a reference of "
           f"{reference['angular_deflection']:g} degrees, {100 * reference['linear_deflection']:g} % and "
           f"{reference['minimum_samples']:,} samples; of lengths, areas and volumes in shares of them.")
    if each["only_one_measured"]:
        yield f"Only one of the two has {each['only_one_measured']} further parts."
    for row in each["quantities"]:
        if row["only_one"]:
            yield f"{row['name']}: only one of the two has a value on {row['only_one']} parts."


def target_tables(results):
    """What was to be reached, and what was; list of Table."""
    lines = results.get("summary") or []
    if not lines:
        return []
    return [Table("Targets", ["target", "reach", "stretch", "got", "verdict", "where"], [
        [line["what"], f"{line['reach']:g}", f"{line['stretch']:g}",
         number(line["got"], 5 if "volume" in line["what"] else 3), line["verdict"], line["where"]] for line in lines],
        ["Measured " + where(results)])]


TABLES = {"verdicts": verdict_tables, "groups": group_tables, "rays": ray_tables, "growth": growth_tables,
          "accuracy": accuracy_tables, "targets": target_tables, "meshing": meshing_tables,
          "meshing_targets": meshing_target_tables}
"""By the name that documents ask for them."""


def where(results):
    """The end of a sentence: the machine and the versions."""
    machine, versions = results["machine"], results["versions"]
    commit = f" ({versions['commit']})" if versions.get("commit") else ""
    freecad = f", FreeCAD {versions['FreeCAD']}" if "FreeCAD" in versions else ""
    return f"on {machine['cpu']}, {machine['cores']} cores, ThinPart {versions['ThinPart']}{commit}{freecad}."


def notes(results):
    """What a reader of all tables must know, one sentence each."""
    versions = results["versions"]
    if "trimesh" in versions:
        yield f"trimesh {versions['trimesh']} casts its rays with embreex {versions['embreex']}."
    cones = {(found["rays_per_vertex"], found["cone_degrees"]) for row in results.get("meshes") or []
             if (found := row["found"].get("pymeshlab"))}
    for rays, degrees in cones:
        yield (f"pymeshlab's shape diameter function casts {rays} rays per vertex in a cone of {degrees} "
               "degrees, not one per triangle: compare its time per ray.")
    for what, reason in (results.get("failures") or {}).items():
        yield f"{what}: {reason}"
    for row in results.get("meshes") or []:
        for name, reason in row["failures"].items():
            yield f"{place(row)}, {name}: {reason}"
        if not 0.5 < row["triangles"] / row["wanted"] < 2.0 and row["placement"] == "aligned":
            yield (f"The {row['solid'].replace('_', ' ')} has no mesh of {row['wanted']:,} triangles; "
                   f"the nearest has {row['triangles']:,}.")


def _by_size(rows):
    return [(count, [row for row in rows if size_class(row) == count]) for count in sorted(set(map(size_class, rows)))]


def _spread(values):
    values = [value for value in values if value]
    if not values:
        return MISSING
    return f"{number(geometric_mean(values))} ({number(max(values))})"


def _difference(value):
    """A small number as people read it."""
    return MISSING if value is None else "0" if value == 0 else f"{value:.2g}" if value >= 1e-4 else "< 0.0001"


def _exponents(found):
    return ", ".join(f"{solid.replace('_', ' ')} {value:.2f}" for solid, value in found.items())


def _group_name(group):
    return f"{group['group']:,} to {10 * group['group']:,}" if group["by"] == "size" else group["group"]


def _of_meshes(title, columns, rows):
    return Table(title, [column.title for column in columns], [[column.text(row) for column in columns] for row in rows])
