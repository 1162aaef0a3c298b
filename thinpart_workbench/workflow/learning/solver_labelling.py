# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels by the solver: what the automatic mesh has wrong is thin, where walls are thin against its elements."""

from dataclasses import dataclass
from typing import Optional

from ...core.categories import NORMAL
from ...core.descriptors.automatic_mesh import AUTOMATIC_SHARE
from ...core.errors import ThinPartError
from ...core.figures import Share
from ...core.kinds.value_kinds import Flag, Number, OneOf, OrNull, Text, Whole
from ...core.message import message
from ...system.process_limits import WALL_FACTOR
from ..solving.automatic_mesh import (
    NO_MESH,
    NOT_SOLVED,
    OTHER_WAYS,
    SOLVED,
    UNKNOWN,
    AutomaticMesh,
    SolvingLimits,
    automatic_mesh_error,
    element_size,
)
from ..solving.mesh_trouble import ERROR, has_trouble
from .automatic_labels import LOCAL, SPREAD, THIN, THIN_FEATURES, AutomaticLabel, Labelling

SOLVING, PART = 4.0, 25.0
"""Times the limit of a mesh: of processor time that a solution may take, and by the clock from when on no mesh of the part
is begun."""

COARSE = 0.5
"""Share of the size of an element under which a wall is thin against it: tetrahedra are over twice as wide as high there."""

_MOST_ERROR = 1e6

_ROUNDED = ("error", "change")


@dataclass(frozen=True)
class SolverLabelling(Labelling):
    """Labels by the error of the automatic mesh, of second order, and by which walls are thin against its elements.

    Attributes
    ----------
    gmsh, calculix : tuple of str
        Paths of the programs, and their versions.
    seconds : float
        Limit of processor time for each mesh; see `SOLVING` and `PART`.
    size : float
        Greatest size of elements, as a share of the diagonal.
    size_mm : float or None
        The same in mm, which goes before `size`.
    error : float
        Of the frequencies, up to which a mesh is good enough.
    """

    gmsh: tuple
    calculix: tuple
    seconds: float
    size: float = AUTOMATIC_SHARE
    size_mm: Optional[float] = None
    error: float = ERROR

    cache = "solving"
    kinds = {
        "outcome": OneOf((SOLVED, NO_MESH, NOT_SOLVED, UNKNOWN)), "error": OrNull(Number(0, _MOST_ERROR)),
        "change": OrNull(Number(0, _MOST_ERROR)), "nodes": Whole(), "reference_nodes": Whole(), "is_tangled": Flag(),
        "is_straight": Flag(), "reason": Text()}
    """See `AutomaticMesh`."""

    columns = ("outcome", "error", "change", "coarse_share", "nodes", "is_tangled", "is_straight", "reason")
    """Of a label: what is measured, and the share of the surface over walls thinner than `COARSE` elements."""

    @property
    def person(self):
        """str"""
        return f"calculix {self.calculix[1]}, gmsh {self.gmsh[1]}"

    @property
    def part_seconds(self):
        """float"""
        step = WALL_FACTOR * self.seconds * (1.0 + SOLVING)
        return PART * self.seconds + (2.0 + len(OTHER_WAYS)) * step

    def settings(self):
        """dict"""
        return {"calculix": self.calculix[1], "gmsh": self.gmsh[1],
                "mesh_size": None if self.size_mm else self.size, "mesh_size_mm": self.size_mm, "error": self.error,
                "coarse": COARSE, "local": LOCAL, "spread": SPREAD}

    def key(self):
        """list"""
        return ["1", self.gmsh[1], self.calculix[1], self.seconds, self.size_mm or [self.size]]

    def measured(self, shape, diagonal, folder):
        """dict"""
        limits = SolvingLimits(self.seconds, SOLVING * self.seconds, seconds=PART * self.seconds)
        found = automatic_mesh_error(
            shape, diagonal, self.gmsh[0], self.calculix[0], limits, folder, self._element(diagonal))
        return {name: getattr(found, name) for name in self.kinds}

    def labelled(self, file, part, measured, descriptors):
        """AutomaticLabel.

        A part in trouble is thin where walls thinner than `COARSE` elements cover `SPREAD` of its surface, else it has thin
        features. Where they cover less than `LOCAL`, something else is to blame, such as narrow faces: it is unsure.
        """
        found = AutomaticMesh(**{name: measured[name] for name in self.kinds})
        trouble = has_trouble(found, self.error)
        if trouble is None:
            raise ThinPartError(_unknown(found))
        element = self._element(descriptors.box.diagonal)
        coarse = descriptors.middle_share(0.0, COARSE * element / float(descriptors.box.dimensions[1]))
        category = NORMAL if not trouble else THIN if coarse >= SPREAD else THIN_FEATURES
        is_sure = not trouble or coarse > LOCAL
        figures = {**measured, **{name: None if measured[name] is None else round(measured[name], 6) for name in _ROUNDED},
                   "coarse_share": round(coarse, 6), "reason": "" if found.error is not None else found.reason}
        return AutomaticLabel(file, part, trouble, category, "" if is_sure else NORMAL, is_sure, figures, descriptors)

    def _element(self, diagonal):
        return element_size(diagonal, self.size_mm or self.size * diagonal)


def _unknown(found):
    """Why nothing is known of a part, a Message."""
    if found.change is not None:
        return message("The error of its mesh is not known: the frequencies of the reference still change by {change}.",
                       change=Share(found.change))
    return message("The error of its mesh is not known ({reason}).", reason=found.reason or message(
        "one reference mesh is not enough, and a second one too large"))
