# SPDX-License-Identifier: LGPL-2.1-or-later
"""The definition of what a worker proposes for a document. It is checked, since a malicious file may control its worker."""


from ...core.descriptors.region_kinds import REGION_KINDS, RIB, THREAD
from ...core.kinds.compound_kinds import ListOf, Record
from ...core.kinds.value_kinds import Flag, Number, OneOf, OrNull, Text, Whole
from ...core.record.record_types import FAILURE
from ...storage.info.info_definition import SOURCE
from .mesh_tries import OPTIONS

_LENGTH, _COUNT, _SHARE = Number(0.0, 1e15), Whole(0, 10**15), Number(0.0, 1.0 + 1e-9)
_SIZE = Number(1e-12, 1e15)
_POINT = ListOf(Number(-1e15, 1e15), 3, 3)

MESH_FIGURES = Record({
    "reason": Text(), "elements": _COUNT, "nodes": _COUNT, "straightened": _COUNT,
    "gamma_least": OrNull(Number(0, 2)), "gamma_1_percent": OrNull(Number(0, 2)),
    "gamma_mean": OrNull(Number(0, 2)), "poor_share": OrNull(_SHARE), "sicn_least": OrNull(Number(-2, 2)),
    "sicn_1_percent": OrNull(Number(-2, 2)), "sicn_mean": OrNull(Number(-2, 2)),
    "layers_share": OrNull(_SHARE), "seconds": Number(0.0), "attempts": Whole(1, 100),
    "tries": ListOf(Record({"what": Text(), "reason": Text(), "seconds": Number(0.0)}), most=100),
})
"""Kind of the figures of one mesh; without one, the reason, no elements and nulls."""

_REGION = Record({
    "region": Whole(1), "kind": OneOf(REGION_KINDS), "thickness": _LENGTH, "thinnest": _LENGTH, "area": _LENGTH,
    "length": _LENGTH, "width": _LENGTH, "faces": ListOf(Text(), most=1_000_000), "size": _LENGTH, "layers": Number(0.0),
    "elements": _COUNT, "group": Whole(1),
})

_GROUP = Record({
    "regions": ListOf(Whole(1), 1, 10_000), "count": Whole(1, 10_000), "kind": OneOf(REGION_KINDS),
    "word": OneOf((*REGION_KINDS, THREAD, RIB)), "thickness": _LENGTH, "thinnest": _LENGTH, "area": _LENGTH,
    "length": _LENGTH, "width": _LENGTH, "faces": ListOf(Text(), most=1_000_000), "size": _LENGTH, "layers": Number(0.0),
    "elements": _COUNT,
})

_IDEALISATION = Record({
    "advice": OneOf(("shell", "mixed", "solid")), "plate_volume_share": OrNull(_SHARE), "plate_area_share": _SHARE,
    "width_to_thickness": OrNull(Number(0.0)), "solid_elements": _COUNT, "shell_elements": _COUNT,
    "no_shell": Text(),
})

_MOST_NODES = 3_000_000

_SOLID = Record({
    "nodes": Whole(1, 10**9), "elements": Whole(1, 10**9), "volume_share": _SHARE,
    "points": ListOf(_POINT, most=_MOST_NODES),
    "tetrahedra": ListOf(ListOf(Whole(0, _MOST_NODES), 10, 10), most=_MOST_NODES),
    "tied": ListOf(Whole(0, _MOST_NODES), most=_MOST_NODES),
    "sides": ListOf(ListOf(Whole(0, _MOST_NODES), 2, 2), most=_MOST_NODES),
})

SHELL = Record({
    "size": _LENGTH, "nodes": _COUNT, "elements": _COUNT, "volume_share": Number(0.0), "reason": Text(),
    "walls": ListOf(Record({"wall": Whole(1), "thickness": _LENGTH, "area": _LENGTH,
                            "faces": ListOf(Text(), most=1_000_000)}), most=100_000),
    "left_solid": ListOf(Record({"kind": OneOf(REGION_KINDS), "thickness": _LENGTH, "volume_share": OrNull(_SHARE),
                                 "faces": ListOf(Text(), most=1_000_000)}), most=10_000),
    "warnings": ListOf(Text(), most=100), "points": ListOf(_POINT, most=_MOST_NODES),
    "triangles": ListOf(ListOf(Whole(0, _MOST_NODES), 3, 6), most=_MOST_NODES),
    "wall": ListOf(Whole(0, 100_000), most=_MOST_NODES), "thickness": ListOf(_LENGTH, most=_MOST_NODES),
    "solid": OrNull(_SOLID),
})
"""Kind of a shell; without one, the reason."""

PART_SIZES = Record({
    "name": Text(), "label": Text(), "category": Text(), "diagonal": _LENGTH, "thin_limit": _LENGTH, "order": OneOf((1, 2)),
    "growth": Number(1.0, 10.0), "wanted_layers": Number(0.0), "layers": Number(0.0), "layered_from": _LENGTH,
    "global_size": _SIZE,
    "least_size": _SIZE, "elements": _COUNT, "nodes": _COUNT, "error": OrNull(Number(0.0)), "uniform_elements": _COUNT,
    "unbounded": OrNull(Record({"layers": Number(0.0), "least_size": _LENGTH, "elements": _COUNT, "nodes": _COUNT})),
    "regions": ListOf(_REGION, most=10_000), "region_groups": ListOf(_GROUP, most=10_000),
    "left_out": Whole(0, 10_000), "idealisation": _IDEALISATION,
    "check": OrNull(Record({"default": MESH_FIGURES, "proposed": MESH_FIGURES})),
    "gmsh_options": ListOf(Record({"name": OneOf(OPTIONS), "value": Number()}), most=20),
    "is_mended": Flag(),
}, {"mended_shape": Text(), "sources": ListOf(ListOf(Number(), 5, 5), most=1_000_000), "box": ListOf(_POINT, 2, 2),
    "inner": ListOf(_POINT, most=1_000_000), "shell": SHELL})
"""Kind of what is proposed for a part; all lengths in mm."""

_PLACES = ("sources", "box", "inner")
"""Keys that are there where places are wanted."""

_DOCUMENT = Record({
    "source": SOURCE, "parts": ListOf(PART_SIZES, most=1_000_000, distinct="name"),
    "failures": ListOf(FAILURE, most=1_000_000), "solids": Whole(0, 1_000_000),
})


def sizes_fault(content, task):
    """Why an object is no result for a document, in a few words; None if it is one.

    Parameters
    ----------
    content : object
        Any JSON value.
    task : SizeTask
        What was asked for has to be in it.
    """
    fault = _DOCUMENT.fault(content, "")
    if fault is not None:
        return fault
    for number, part in enumerate(content["parts"]):
        fault = _lack(part, task) or _fault_of_places(part) or _fault_of_shell(part.get("shell"))
        if fault is not None:
            return f"parts[{number}].{fault}"
    return None


def known_values(content):
    """A result that has no fault without what no result has: others would take it for something else, such as an error."""
    return {key: content[key] for key in _DOCUMENT.required}


def _lack(part, task):
    if task.program is not None and task.check and part["check"] is None:
        return "check is null"
    wanted = [*(_PLACES if task.has_sources else ()), *(() if task.shell is None else ("shell",))]
    return next((f"{key} is missing" for key in wanted if key not in part), None)


def _fault_of_places(part):
    """Places have sizes, and there are points in the part, which lies in a box."""
    if any(key not in part for key in _PLACES):
        return None
    if any(size <= 0.0 or radius < 0.0 for *_, size, radius in part["sources"]):
        return "sources has a size that is none"
    if not part["inner"] or any(low > high for low, high in zip(*part["box"])):
        return "box is not around points in the part"
    return None


def _fault_of_shell(shell):
    """A shell has a wall and a thickness for each triangle, and its triangles have its nodes."""
    if shell is None or not shell["elements"]:
        return None
    if not shell["walls"]:
        return "shell has no walls"
    counts = {shell["elements"], *(len(shell[key]) for key in ("triangles", "wall", "thickness"))}
    if len(counts) > 1 or shell["nodes"] != len(shell["points"]):
        return "shell has not the elements and nodes that it says"
    if {len(triangle) for triangle in shell["triangles"]} not in ({3}, {6}):
        return "shell has triangles with some other number of nodes"
    if max(map(max, shell["triangles"])) >= shell["nodes"]:
        return "shell has triangles with nodes that are not there"
    return None if shell["solid"] is None else _fault_of_solid(shell["solid"], shell)


def _fault_of_solid(solid, shell):
    """What is tied to a shell has the nodes of its tetrahedra, and the shell has the sides that it is tied to."""
    if solid["elements"] != len(solid["tetrahedra"]) or solid["nodes"] != len(solid["points"]):
        return "solid has not the elements and nodes that it says"
    if not solid["tied"] or not solid["sides"] or len(shell["triangles"][0]) != 6:
        return "solid is tied to no side of a shell"
    if max(max(map(max, solid["tetrahedra"])), *solid["tied"]) >= solid["nodes"]:
        return "solid has nodes that are not there"
    if any(row >= shell["elements"] or side > 2 for row, side in solid["sides"]):
        return "solid is tied to sides that are not there"
    return None
