# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of a shell mesh."""

from dataclasses import dataclass
from typing import Optional

from ..errors import ThinPartError
from ..message import message

SHARE_OF_DIAGONAL = 0.1
"""Greatest element size of a shell, by the diagonal of the part, where none is named."""


@dataclass(frozen=True)
class ShellSettings:
    """Settings of a shell mesh. Raises ThinPartError, kind ``usage`` if a value is out of range.

    Attributes
    ----------
    size : float or None, mm
        Greatest element size; None for what the part asks for.
    order : int
        Of the elements, 1 or 2. Shells of first order are far too stiff in CalculiX.
    solid_walls : tuple of tuple of int
        Walls that stay solid although they could be shells, each by its faces, from 0, in rising order.
    has_rest : bool
        Whether the rest of the part is wanted too, as tetrahedra of second order that are tied to the shell.
    on_faces : bool
        Whether the triangles have to lie on faces, as FreeCAD's FEM finds them by: not those moved there from one side.
    """

    size: Optional[float] = None
    order: int = 2
    solid_walls: tuple = ()
    has_rest: bool = False
    on_faces: bool = False

    def __post_init__(self):
        # Lists, where they came as JSON.
        object.__setattr__(self, "solid_walls", tuple(tuple(faces) for faces in self.solid_walls))
        if self.order not in (1, 2):
            raise ThinPartError(message("The order of elements is 1 or 2, not {value}.", value=self.order), "usage")
        if self.size is not None and not 0.0 < self.size < float("inf"):
            raise ThinPartError(message("The element size of a shell is more than 0 mm, not {value:g}.", value=self.size),
                                "usage")
