# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ranges of thickness into which limits of the wall divide a map: what fails, what is just above, what passes; and which
places are too thick."""

from dataclasses import dataclass

import numpy as np

from ..record.face_names import face_number

FAILS, JUST_ABOVE, PASSES, TOO_THICK = ("fails", "just_above", "passes", "too_thick")

ABOVE = 0.1
"""Share of the least wall up to which a wall is just above it: it passes, but a tolerance or wear may use that up."""

AT_LIMIT = 1e-4
"""Share of a limit within which a wall is as thick as the limit: maps have points in float32."""


@dataclass(frozen=True)
class LimitBand:
    """A range of thickness across the wall; that of `TOO_THICK` is one of the largest balls inside.

    Attributes
    ----------
    name : str
        One of these four.
    low, high : float, mm
        From `low` to less than `high`; infinite where nothing limits it.
    limit : float, mm
        The limit that it lies beside, 0 for none.
    """

    name: str
    low: float
    high: float
    limit: float = 0.0


def limit_bands(least, most):
    """Divide all thicknesses by limits, float, mm, 0 for none: list of LimitBand, the thinnest first.

    The last one, where there is a greatest wall, is `TOO_THICK`. It lies over the others: rays along a wall from its rim
    are long without a thick place, so that balls decide (`too_thick`).
    """
    end = most * (1.0 + AT_LIMIT) if most > 0.0 else float("inf")
    bands, low = [], 0.0
    if least > 0.0:
        low = least * (1.0 - AT_LIMIT)
        bands.append(LimitBand(FAILS, 0.0, low, least))
        above = min(least * (1.0 + ABOVE), end)
        bands.append(LimitBand(JUST_ABOVE, low, above, least))
        low = above
    bands.append(LimitBand(PASSES, low, float("inf")))
    if most > 0.0:
        bands.append(LimitBand(TOO_THICK, end, float("inf"), most))
    return bands


def least_ratios(check, faces, opposite):
    """How many times the least wall of a process is that of places with a least wall of their own: ndarray of shape (m,).

    Thicknesses that are multiplied by it are compared with the process. A wall that only the face opposite has a limit for
    is compared with that, as the check does. 1 elsewhere; None where no face has a least wall of its own.

    Parameters
    ----------
    check : WallCheck
    faces : ndarray of shape (m,), int
        Numbers of the B-Rep faces of the places, from 0.
    opposite : ndarray of shape (m,), int
        Which place each lies opposite of, -1 for none.
    """
    own = {face_number({"face": each.face}): each.min_mm for each in check.own if each.min_mm and not each.is_gone}
    if not own or not check.limits.min_mm:
        return None
    ratios, across = np.ones(len(faces)), np.where(opposite >= 0, faces[opposite], -1)
    for places in (across, faces):  # its own limit comes before that of the other side
        for number, least in own.items():
            ratios[places == number] = check.limits.min_mm / least
    return ratios


def too_thick(check, balls, faces):
    """Which places are thicker than a process allows, as the check of the part says it: ndarray of shape (m,), bool.

    So rims and edges, along which rays run, are not among them, nor is anything where the check passes. Faces with a
    greatest wall of their own are compared with that.

    Parameters
    ----------
    check : WallCheck
    balls : ndarray of shape (m,), mm
        Diameters of the largest balls inside that reach the places; nan where that is not known.
    faces : ndarray of shape (m,), int
        Numbers of the B-Rep faces of the places, from 0.
    """
    most, of_faces = check.thick_from
    allowed = np.full(len(balls), most)
    for name, own in of_faces.items():
        allowed[faces == face_number({"face": name})] = own
    with np.errstate(invalid="ignore"):
        return balls > allowed
