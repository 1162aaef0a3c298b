# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the automatic mesh of a part is in trouble."""

from .automatic_mesh import KNOWN, NO_MESH, NOT_SOLVED, SOLVED
from .calculix_program import MEMORY, TIMEOUT

ERROR = 0.04
"""Error of the frequencies from which a mesh is in trouble, unless another is stated."""

_OF_THE_LIMITS = (TIMEOUT, MEMORY)
_REFUSAL = "jacobian"
"""Stands in what CalculiX says of an element that is inside out."""


def has_trouble(found, error=ERROR):
    """Whether there is no automatic mesh that can be solved, or its frequencies are off: bool, or None where nobody knows.

    A reference that is not converged says so only of a mesh that is off by far more.

    Parameters
    ----------
    found : AutomaticMesh
    error : float
        Up to which frequencies are good enough.
    """
    if found.outcome == NO_MESH:
        return True
    if found.outcome == NOT_SOLVED:
        return None if found.reason in _OF_THE_LIMITS else True
    if found.outcome != SOLVED:
        return None
    if is_converged(found):
        return found.error > error
    return True if found.change is not None and found.error > error + found.change else None


def is_converged(found):
    """Whether the reference mesh of an AutomaticMesh that is solved is one: bool."""
    return found.change is not None and found.change <= KNOWN


def is_refused(found):
    """Whether the solver refuses the mesh as it is made, an AutomaticMesh, even if it takes it untangled: bool."""
    return found.is_tangled or found.outcome == NOT_SOLVED or not found.frequencies and _REFUSAL in found.reason
