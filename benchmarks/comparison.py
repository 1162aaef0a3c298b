# SPDX-License-Identifier: LGPL-2.1-or-later
"""All contestants on all meshes, turn by turn."""

import tempfile
from collections import namedtuple
from dataclasses import dataclass, field
from pathlib import Path

from .children.child_process import Child, ChildError

PLACEMENTS = ("aligned", "rotated")

PAIR_LOOP_TRIANGLES = 12_000
"""Beyond these the paper's loop takes minutes."""

PEER_LIMIT = 120.0
"""Seconds that one turn of a peer may take; where more is to be expected, it is not tried."""

OWN_LIMIT = 3600.0
"""Seconds that one turn of the product, or of FreeCAD, may take."""

TURNS_LIMIT = 10.0
"""Seconds after which a contestant has had enough turns on a mesh."""

SHORT_TURN = 0.05
MORE_TURNS = 4
"""Where its turns are shorter than that many seconds, it gets so many times more of them."""

Contestants = namedtuple("Contestants", "freecad pair_loop peers has_cores")
"""Children that stay for the whole run: FreeCAD, the pair loop or None, and the peers by name; and whether the core and the
whole are also measured on one processor and on two."""

CORES = (1, 2)


@dataclass
class Turns:
    """One contestant on one mesh.

    Attributes
    ----------
    name : str
        Under which its times are noted.
    row : dict
        The mesh's results.
    child : Child
    task : str
    arguments : dict
    limit : float, s
    most : int or None
        Turns, if fewer than the others have.
    """

    name: str
    row: dict
    child: Child
    task: str
    arguments: dict
    limit: float = OWN_LIMIT
    most: int = None
    seconds: list = field(default_factory=list)

    def take(self, repeat):
        """Take one turn, unless it has had enough; note its time and findings, or why it failed."""
        if self.name in self.row["failures"] or self._has_had_enough(self.most or repeat):
            return
        try:
            answer = self.child.ask(self.task, self.limit, **self.arguments)
        except ChildError as error:
            self.row["failures"][self.name] = str(error)
            return
        self.seconds.append(answer.pop("seconds"))
        self.row["seconds"][self.name] = self.seconds
        self.row["found"][self.name] = answer

    def _has_had_enough(self, repeat):
        taken = sum(self.seconds)
        if len(self.seconds) < repeat:
            return taken > TURNS_LIMIT
        return self.most is not None or taken > SHORT_TURN * len(self.seconds)


def compare(contestants, python, solids, sizes, repeat, cache, say):
    """Measure every solid at every size, as it lies and rotated.

    Parameters
    ----------
    contestants : Contestants
    python : str
        Interpreter of the product.
    solids : list of str
    sizes : list of int
        Triangles wanted.
    repeat : int
        Turns of each contestant on each mesh.
    cache : Path
        Folder of the meshes.
    say : callable
        Told what is going on.

    Returns
    -------
    rows : list of dict
        One per mesh. ``seconds``: list of times by contestant; ``found``: what else each told;
        ``bytes_per_triangle``: of core and whole; ``failures``: a sentence by contestant.
    failures : dict of str to str
        Meshes that could not be made or loaded, and why.
    """
    rows, failures, paces = [], {}, {}
    for solid in solids:
        for wanted in sizes:
            title = f"{solid.replace('_', ' ')}, {wanted:,} triangles"
            say(f"{title}: mesh")
            try:
                mesh = contestants.freecad.ask(
                    "meshes", OWN_LIMIT, solid=solid, wanted=wanted, folder=str(cache))
                say(f"{title}: turns on {mesh['triangles']:,}")
                with tempfile.TemporaryDirectory() as folder:
                    rows += _rows(
                        contestants, python, solid, wanted, mesh, repeat, Path(folder), paces)
            except ChildError as error:
                failures[title] = str(error)
    return rows, failures


def _rows(contestants, python, solid, wanted, mesh, repeat, folder, paces):
    """The rows of one solid at one size: both placements take turns with each other too."""
    rows, turns, products = [], [], []
    pinned = {cores: Child(python, "product", cores=cores) for cores in CORES if contestants.has_cores}
    products += pinned.values()
    try:
        for product in pinned.values():
            product.ask("warm_up")
        for placement in PLACEMENTS:
            product = Child(python, "product")
            products.append(product)
            file = mesh["files"][placement]
            clean, arrays = (str(folder / f"{placement}.{end}") for end in ("pickle", "npz"))
            answer = product.ask(
                "load", OWN_LIMIT, file=file, clean_file=clean, peers_file=arrays)
            row = {
                "solid": solid, "wanted": wanted, "placement": placement, **answer,
                "linear_deflection_mm": mesh["linear_deflection"],
                "angular_deflection_rad": mesh["angular_deflection"], "splits": mesh["splits"],
                "seconds": {}, "found": {}, "bytes_per_triangle": {}, "failures": {},
            }
            rows.append(row)
            for task, source in (("core", clean), ("whole", file)):
                _measure_memory(row, python, task, source)
            turns += _turns(contestants, row, product, mesh, file, arrays, paces)
            if placement == PLACEMENTS[0]:
                turns += [Turns(f"{task}_on_{cores}", row, child, task, {"file": file})
                          for task in ("core", "whole") for cores, child in pinned.items()]
        # By contestant, so that the two placements of one follow each other.
        names = list(dict.fromkeys(each.name for each in turns))
        turns.sort(key=lambda each: names.index(each.name))
        for _ in range(repeat * MORE_TURNS):
            for each in turns:
                each.take(repeat)
    finally:
        for product in products:
            product.close()
    for each in turns:
        if each.seconds:
            pace = min(each.seconds) / each.row["triangles"]
            paces[each.name, solid, each.row["placement"]] = pace
    return rows


def _turns(contestants, row, product, mesh, file, arrays, paces):
    """Everybody who has a turn on this mesh."""
    deflections = {key: mesh[key] for key in ("linear_deflection", "angular_deflection")}
    shape = {"solid": row["solid"], "placement": row["placement"], **deflections}
    everybody = []
    if not mesh["splits"]:
        everybody.append(Turns("tessellation", row, contestants.freecad, "time", shape))
    for task in ("core", "whole", "box", "nonparallel"):
        everybody.append(Turns(task, row, product, task, {"file": file}))
    for name, child in contestants.peers.items():
        everybody.append(Turns(name, row, child, "time", {"file": arrays}, PEER_LIMIT))
        if name == "trimesh":
            box = Turns("trimesh_box", row, child, "box", {"file": arrays}, PEER_LIMIT, most=1)
            everybody.append(box)
    few = row["triangles"] <= PAIR_LOOP_TRIANGLES
    if contestants.pair_loop and few and row["placement"] == PLACEMENTS[0]:
        everybody.append(
            Turns("pair_loop", row, contestants.pair_loop, "time", {"file": arrays}, PEER_LIMIT, most=1))
    for each in everybody:
        pace = paces.get((each.name, row["solid"], row["placement"]), 0.0)
        expected = pace * row["triangles"]
        if each.limit == PEER_LIMIT < expected:
            row["failures"][each.name] = f"Left out: it would take about {expected:.0f} s."
    return everybody


def _measure_memory(row, python, task, file):
    """In a process of its own: peak memory never falls, so an earlier task would hide a later one."""
    try:
        with Child(python, "product") as fresh:
            added = fresh.ask("memory", OWN_LIMIT, kind=task, file=file)["bytes"]
            row["bytes_per_triangle"][task] = added / row["triangles"]
    except ChildError as error:
        row["failures"][f"memory of {task}"] = str(error)
