# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of `meshing_peers`."""

from collections import Counter
from statistics import median

from .table_text import MISSING, Table

PEERS = (
    ("one size", "one size, a tenth of the diagonal"),
    ("ThinPart", "**ThinPart's sizes**"),
    ("equal", "one size, as many elements as ThinPart's"),
    ("curvature", "Gmsh, sizes from curvature and boundary"),
    ("Netgen 2", "Netgen, close edges 2 (moderate)"),
    ("Netgen 5", "Netgen, close edges 5 (very fine)"),
)
"""By the name of a mesh in the results."""

GROUPS = (("thin", "Thin and thin-featured parts"), ("normal", "Normal parts"))

COLUMNS = ("mesh", "parts meshed", "of those that fail at one size", "elements, median", "gamma under 0.3, median",
           "parts with more than 3 %", "thin walls with two layers, median", "parts with layers in 90 %", "seconds, median")

LAYERED, POOR = 0.9, 0.03


ALL_THICK = "no sizes of its own"
"""Family of parts without thin walls, or whose thin walls are meshed as the rest."""


def family_of(regions):
    """The family of a part: the kind of wall that has most of its thin area.

    Parameters
    ----------
    regions : iterable of (str, float)
        Kind and area of each thin wall region.
    """
    area = Counter()
    for kind, own in regions:
        area[kind] += own
    return area.most_common(1)[0][0] if area else ALL_THICK


def meshing_tables(results):
    """The tables, list of Table; none where nothing was meshed."""
    found = results.get("meshing")
    if not found:
        return []
    groups = [(title, [row for row in found["parts"] if row["group"] == group]) for group, title in GROUPS]
    return [Table(title, COLUMNS, [_row(name, text, rows) for name, text in PEERS]) for title, rows in groups if rows]


def meshing_target_tables(results):
    """What was to be reached, and what was: list of Table."""
    found = results.get("meshing")
    if not found:
        return []
    thin, normal = ([row for row in found["parts"] if row["group"] == group] for group, _ in GROUPS)
    failing = [row for row in thin if not _elements(row, "one size")]
    meshed = [row for row in thin if _elements(row, "ThinPart")]
    poor, layers = (_values(meshed, "ThinPart", key) for key in ("poor_share", "layers_share"))
    shares = [1.0 if _is_as_it_was(row) else _elements(row, "ThinPart") / row["uniform_elements"] for row in meshed]
    called = [row for row in found["parts"] if row.get("category") == "normal"]
    same, stays = (sum(map(_is_as_it_was, rows)) for rows in (normal, called))
    rows = [
        ["of the parts that fail at one size, meshed", "95 %",
         f"{sum(bool(_elements(row, 'ThinPart')) for row in failing)} of {len(failing)}"],
        ["elements with gamma under 0.3, median of the parts", "at most 3 %", _percent(poor)],
        ["thin walls with two layers, median of the parts", "over 90 %", _percent(layers)],
        ["parts with two layers in over 90 % of their thin walls", "all",
         f"{sum(share > LAYERED for share in layers)} of {len(layers)}"],
        ["parts with more elements than a uniform mesh of the least size would have", "none",
         f"{sum(share > 1.0 for share in shares)} of {len(shares)}"],
        ["elements by those of such a mesh, median", "at most 33 %", _percent(shares)],
        ["parts that an engineer calls normal, whose mesh is as it was", "all", f"{same} of {len(normal)}"],
        ["parts that ThinPart calls normal, whose mesh is as it was", "all", f"{stays} of {len(called)}"],
    ]
    return [Table("What was to be reached", ("what", "aim", "reached"), rows, (_notes(results),))]


def _notes(results):
    """What was run, in a sentence."""
    found, versions = results["meshing"], results["versions"]
    programs = ", ".join(f"{name} {versions[name]}" for name in ("Gmsh", "Netgen") if name in versions)
    return (f"Parts whose number ends in {' or '.join(found['digits'])}, the first {len(found['parts'])} of "
            f"{found['chosen']}; {found['seconds']:g} s of processor time and {found['megabytes'] / 1000:g} GB for each "
            f"mesh; {programs}.")


def _row(name, text, rows):
    asked = [row for row in rows if row.get("meshes", {}).get(name) is not None or "error" in row]
    meshed = [row for row in asked if _elements(row, name)]
    failing = [row for row in asked if not _elements(row, "one size")]
    poor, layers = (_values(meshed, name, key) for key in ("poor_share", "layers_share"))
    counts, seconds = (_values(meshed, name, key) for key in ("elements", "seconds"))
    return [text, f"{len(meshed)} of {len(asked)}", f"{sum(row in meshed for row in failing)} of {len(failing)}",
            f"{median(counts):,.0f}" if counts else MISSING, _percent(poor), sum(share > POOR for share in poor),
            _percent(layers), f"{sum(share > LAYERED for share in layers)} of {len(layers)}",
            f"{median(seconds):.2g}" if seconds else MISSING]


def _is_as_it_was(row):
    """Whether the mesh with ThinPart's sizes is that of one size, or neither is there."""
    return _elements(row, "ThinPart") == _elements(row, "one size")


def _elements(row, name):
    return (row.get("meshes", {}).get(name) or {}).get("elements", 0)


def _values(rows, name, key):
    return [value for row in rows if (value := row["meshes"][name][key]) is not None]


def _percent(values):
    if not values:
        return MISSING
    value = 100.0 * median(values)
    return f"{value:.0f} %" if value >= 10.0 else f"{value:.2g} %"
