# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first elastic frequencies of a free body, by CalculiX."""

import os

import numpy as np

from .calculix_program import solve
from .solid_model import solid_text

COUNT = 6
"""Elastic frequencies that are compared: as many as a body has rigid motions."""

RIGID = 6
"""Motions of a free body without deformation."""

SIZE = 100.0
"""Length of the diagonal of what is solved, mm. Ratios of frequencies do not depend on it, rounding errors do."""

ZERO = 1e-3
"""Frequencies below this share of the highest one that is asked for are rigid motions."""

JOB = "modes"


def elastic_frequencies(points, tetrahedra, diagonal, program, seconds, folder):
    """The first elastic frequencies of a body of steel, held nowhere, scaled to the diagonal `SIZE`.

    Returns `frequencies` (ndarray of shape (6,), Hz; empty if there are none) and `reason` (str; why).

    Parameters
    ----------
    points : ndarray of shape (v, 3)
    tetrahedra : ndarray of int, shape (n, 10)
        Of second order, in the order of Gmsh.
    diagonal : float
        Of the body, in the unit of the points. That of the points would not do: nodes of a coarse mesh miss the ends of
        round bodies by up to 0.3 %.
    program : str
        Path of CalculiX.
    seconds : float
        Limit of processor time.
    folder : str
        Working directory, temporary.
    """
    with open(os.path.join(folder, JOB + ".inp"), "w", encoding="ascii") as file:
        file.write(solid_text(SIZE / diagonal * (points - points.mean(axis=0)), tetrahedra))
        file.write(f"*STEP\n*FREQUENCY\n{RIGID + COUNT}\n*END STEP\n")
    reason = solve(program, JOB, seconds, folder)
    if reason:
        return np.zeros(0), reason
    frequencies = all_frequencies(os.path.join(folder, JOB + ".dat"))
    elastic = frequencies[frequencies > ZERO * frequencies.max(initial=0.0)]
    return elastic[:COUNT], ""


def all_frequencies(path):
    """All frequencies of a file of results of CalculiX: ndarray, Hz, in ascending order."""
    found = []
    with open(path, encoding="ascii", errors="replace") as file:
        for line in file:
            words = line.split()
            if "P A R T I C I P A T I O N" in line:
                break
            if len(words) == 5 and words[0].isdigit():
                found.append(float(words[3]))
    return np.sort(np.array(found))
