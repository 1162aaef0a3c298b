# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of a mesh that worked: kept with a part, and carried over to parts like it."""

import math

LEAST_ALIKE = 70.0
"""Similarity, of 100, from which on settings of another part are offered."""

SAME_WALL = 1.3
"""Greatest ratio of the thicknesses, each by the diagonal of its part, of walls that correspond."""


def worked_settings(settings, global_size, diagonal, rows, figures, when, version):
    """What is kept with a part whose mesh was made: dict, ``meshed`` of a part record.

    Parameters
    ----------
    settings : dict
        ``order``, ``error`` (aimed at, or None), ``layers`` (None for those of the order), ``growth``, ``size`` (None for a
        tenth of the diagonal) and ``budget`` (or None), of `SizingSettings`.
    global_size, diagonal : float, mm
    rows : list of dict
        The walls: ``kind``, ``thickness``, ``size`` (None where switched off), and ``is_changed``, whether people chose it.
    figures : dict
        Of the mesh; see `workflow.meshing.size_result.MESH_FIGURES`.
    when : str
    version : str
        Of ThinPart.
    """
    is_by_error = settings["order"] == 2 and settings["layers"] is None
    kept = {"when": when, "version": version, "order": settings["order"],
            "error": settings.get("error") if is_by_error else None, "layers": settings["layers"],
            "growth": settings["growth"], "size_mm": settings["size"], "budget": settings["budget"],
            "global_size_mm": _rounded(global_size), "diagonal_mm": _rounded(diagonal),
            "walls": [{"kind": row["kind"], "thickness_mm": _rounded(row["thickness"]),
                       "size_mm": None if row["size"] is None else _rounded(row["size"]), "is_changed": row["is_changed"]}
                      for row in rows]}
    kept.update({key: figures[key] for key in ("elements", "poor_share", "gamma_least", "layers_share")})
    return {**kept, "how": str(figures["tries"][-1]["what"]) if figures["tries"] else ""}


def settings_for(meshed, diagonal):
    """Settings for a part from those that worked for another: a dict as of `worked_settings`.

    Returns a dict: a greatest size grows with the part. The budget is not carried over: it was one of elements for the other
    part.

    Parameters
    ----------
    meshed : dict
    diagonal : float, mm
        Of the part.
    """
    size = meshed["size_mm"]
    return {"order": meshed["order"], "error": meshed.get("error"), "layers": meshed["layers"],
            "growth": meshed["growth"], "budget": None,
            "size": None if size is None else _rounded(size * diagonal / meshed["diagonal_mm"])}


def wall_sizes_for(meshed, walls, diagonal):
    """Sizes of the walls of a part from those that people chose for another: dict.

    Size, mm, or None for a wall to leave out, by number of the wall: as many elements through it as there.

    Parameters
    ----------
    meshed : dict
    walls : list of (str, float)
        Kind and thickness, mm, of each wall.
    diagonal : float, mm
    """
    found = {}
    for number, (kind, thickness) in enumerate(walls):
        alike = [(abs(math.log((thickness / diagonal) / (wall["thickness_mm"] / meshed["diagonal_mm"]))), at)
                 for at, wall in enumerate(meshed["walls"]) if wall["kind"] == kind and wall["thickness_mm"] > 0.0]
        away, at = min(alike, default=(math.inf, 0))
        if thickness > 0.0 and away <= math.log(SAME_WALL) and meshed["walls"][at]["is_changed"]:
            wall = meshed["walls"][at]
            found[number] = None if wall["size_mm"] is None else _rounded(wall["size_mm"] / wall["thickness_mm"] * thickness)
    return found


def _rounded(value):
    return float(f"{value:.6g}")
