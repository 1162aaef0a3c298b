# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels by meshing: what has bad tetrahedra where Gmsh meshes it is thin."""

import os
from dataclasses import dataclass

from ...core.categories import NORMAL
from ...core.descriptors.automatic_mesh import AUTOMATIC_SHARE
from ...core.kinds.value_kinds import Number, OrNull, Text, Whole
from ...core.mesh.tetrahedra import POOR, radius_ratios, surface_share
from ...core.message import message
from ...storage.exchange.msh_file import read_tetrahedra
from ...system.process_limits import WALL_FACTOR
from ..meshing.gmsh_program import mesh_volume, stated_error
from .automatic_labels import LOCAL, SPREAD, THIN, THIN_FEATURES, AutomaticLabel, Labelling


@dataclass(frozen=True)
class MeshLabelling(Labelling):
    """Labels by where bad tetrahedra lie.

    Attributes
    ----------
    gmsh : tuple of str
        Path of the program, and its version.
    seconds : float
        Limit of processor time for each part.
    """

    gmsh: tuple
    seconds: float

    cache = "meshing"
    kinds = {
        "elements": Whole(), "least_ratio": OrNull(Number(0, 2)), "trouble_share": OrNull(Number(0, 1)), "reason": Text()}
    """Number of tetrahedra; the least ratio of radii and the share of the surface on bad ones, both null without a mesh."""

    columns = tuple(kinds)

    @property
    def person(self):
        """str"""
        return f"gmsh {self.gmsh[1]}"

    @property
    def part_seconds(self):
        """float"""
        return (WALL_FACTOR + 1.0) * self.seconds

    def settings(self):
        """dict"""
        return {"gmsh": self.person, "local": LOCAL, "spread": SPREAD}

    def key(self):
        """list: limits too, since what took too long might not with others."""
        return ["2", self.gmsh[1], AUTOMATIC_SHARE, POOR, self.seconds]

    def measured(self, shape, diagonal, folder):
        """dict"""
        mesh = os.path.join(folder, "part.msh")
        reason, text = mesh_volume(
            self.gmsh[0], [shape], mesh, self.seconds, folder, ("-clmax", repr(AUTOMATIC_SHARE * diagonal)))
        if reason:
            return _unmeshed(reason)
        points, tetrahedra = read_tetrahedra(mesh)
        if not len(tetrahedra):
            return _unmeshed(stated_error(text) or message("Gmsh filled no volume"))
        ratios = radius_ratios(points, tetrahedra)
        return {"elements": len(tetrahedra), "least_ratio": round(float(ratios.min()), 6),
                "trouble_share": round(surface_share(points, tetrahedra, ratios < POOR), 6), "reason": ""}

    def labelled(self, file, part, measured, descriptors):
        """AutomaticLabel: in trouble are parts without a mesh, and with bad tetrahedra on more than `LOCAL` of the surface.
        Without a mesh nobody knows where the trouble is, so it is unsure.
        """
        share = measured["trouble_share"]
        has_trouble = share is None or share > LOCAL
        category = NORMAL if not has_trouble else THIN if share is None or share >= SPREAD else THIN_FEATURES
        return AutomaticLabel(file, part, has_trouble, category, THIN_FEATURES if share is None else "", share is not None,
                              measured, descriptors)


def _unmeshed(reason):
    return {"elements": 0, "least_ratio": None, "trouble_share": None, "reason": reason}
