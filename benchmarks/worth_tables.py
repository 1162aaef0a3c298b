# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of `mesh_worth.py`."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from benchmarks.table_text import Table

UNIFORM = (0.1, 0.07, 0.05, 0.035)
"""Element sizes of uniform meshes, as shares of the diagonal."""

ERRORS = (0.1, 0.05, 0.02, 0.01)
"""Errors aimed at."""

CONVERGED = 0.01
"""Change from the second finest mesh to the finest at which the finest is the reference."""

CATEGORIES = {"thin": "thin", "thin_features": "thin features", "normal": "normal"}

LEAST_ERROR = 1e-3
"""Errors below this are no better than the reference."""

TITLES = {"uniform": "one size, {:g} of the diagonal", "curvature": "Gmsh, sizes from curvature",
          "netgen": "Netgen, close edges {:g}", "ThinPart": "**ThinPart, error aimed at {:g} %**"}


@dataclass(frozen=True)
class WorthPart:
    """Meshes of one part, figures by name: see `children/solved_meshes.py`."""

    category: str
    meshes: dict

    @cached_property
    def by_nodes(self):
        """Meshes that were solved, those with the fewest nodes first: list of dict."""
        return sorted((mesh for mesh in self.meshes.values() if mesh["frequencies"]), key=lambda mesh: mesh["nodes"])

    @cached_property
    def reference(self):
        """The finest mesh, dict; None where it is not known to be converged."""
        finest = self.by_nodes[::-1]
        if len(finest) < 2 or _apart(finest[1], finest[0]) > CONVERGED:
            return None
        return finest[0]

    def error(self, name):
        """Greatest relative error of the frequencies and the deflection, float; inf where there is no solution."""
        mesh = self.meshes[name]
        return _apart(mesh, self.reference) if mesh["frequencies"] else np.inf

    def by_uniform(self, name):
        """Nodes of a mesh by those that one size takes for the same error, float; None where that is not known.

        Between the uniform meshes, nodes follow a power of the error; beyond them nothing is known.
        """
        uniform = [(self.meshes[each]["nodes"], max(self.error(each), LEAST_ERROR)) for each in self.meshes
                   if each.startswith("uniform") and self.meshes[each]["frequencies"]
                   and self.meshes[each] is not self.reference]
        own = self.error(name)
        if len(uniform) < 2 or not LEAST_ERROR <= own < np.inf:
            return None
        nodes, errors = (np.log(column) for column in zip(*uniform))
        slope, start = np.polyfit(errors, nodes, 1)
        if slope >= 0.0 or not errors.min() <= np.log(own) <= errors.max():
            return None
        return float(self.meshes[name]["nodes"] / np.exp(start + slope * np.log(own)))


def _apart(mesh, reference):
    found = np.abs(np.array(mesh["frequencies"]) / reference["frequencies"] - 1.0).max()
    if mesh["deflection"] and reference["deflection"]:
        found = max(found, abs(mesh["deflection"] / reference["deflection"] - 1.0))
    return float(found)


def title_of(name):
    """What a way to mesh is called in tables: str."""
    kind, _, value = name.partition(" ")
    number = float(value or 0.0)
    return TITLES[kind].format(100.0 * number if kind == "ThinPart" else number)


def worth_tables(parts):
    """Tables of what meshes are worth: list of Table.

    Parameters
    ----------
    parts : list of WorthPart
    """
    known = [part for part in parts if part.reference is not None]
    names = list(dict.fromkeys(name for part in parts for name in part.meshes))
    columns = ("mesh", "parts solved", "nodes, median", "most", "error, median", "of nine in ten parts", "within 2 %",
               "within 5 %", "poor elements, median", "by nodes of one size at that error")
    tables = [Table(f"{len(known)} parts of {len(parts)}, whose finest two meshes differ by at most 1 %", columns,
                    [_row(name, known) for name in names])]
    own = [name for name in names if name.startswith("ThinPart")]
    tables.append(Table("By the category of the part", ("category", *columns), [
        (title, *_row(name, members)) for key, title in CATEGORIES.items() for name in own
        if (members := [part for part in known if part.category == key])]))
    tables.append(Table(f"All {len(parts)} parts: meshes that a solver takes, and how many nodes they have",
                        ("mesh", "meshed", "nodes, median", "most", "mesh by estimate", "of nine in ten parts"),
                        [_meshed_row(name, parts) for name in names]))
    return tables


def _row(name, parts):
    own = [part for part in parts if name in part.meshes]
    errors = np.array([part.error(name) for part in own])
    solved = np.isfinite(errors)
    meshes = [part.meshes[name] for part, is_solved in zip(own, solved) if is_solved]
    nodes = [mesh["nodes"] for mesh in meshes]
    ratios = [ratio for part in own if (ratio := part.by_uniform(name)) is not None]
    nine_in_ten = np.quantile(errors, 0.9, method="higher")
    return (title_of(name), f"{solved.sum()} of {len(own)}", _number(nodes, np.median), _number(nodes, np.max),
            _percent(np.median(errors)), _percent(nine_in_ten), f"{np.mean(errors <= 0.02):.0%}",
            f"{np.mean(errors <= 0.05):.0%}", _percent(np.median([mesh["poor"] for mesh in meshes] or [np.inf])),
            f"{np.median(ratios):.2f} ({len(ratios)} parts)" if ratios else "-")


def _meshed_row(name, parts):
    meshes = [part.meshes[name] for part in parts if name in part.meshes]
    nodes = [mesh["nodes"] for mesh in meshes if mesh["elements"]]
    ratios = [mesh["nodes"] / mesh["estimate"][0] for mesh in meshes if mesh["elements"] and mesh.get("estimate")]
    between = [f"{value:.2f}" for value in np.quantile(ratios, (0.5, 0.05, 0.95))] if ratios else None
    return (title_of(name), f"{len(nodes)} of {len(meshes)}", _number(nodes, np.median), _number(nodes, np.max),
            between[0] if between else "-", f"{between[1]} to {between[2]}" if between else "-")


def _number(values, of):
    return f"{of(values):,.0f}" if len(values) else "-"


def _percent(value):
    return f"{100 * value:.2g} %" if np.isfinite(value) else "-"
