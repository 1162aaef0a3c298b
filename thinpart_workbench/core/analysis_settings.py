"""How a part is measured: one table of defaults for the command line, the panels and the tests."""

from dataclasses import asdict, dataclass

from .errors import ThinPartError

MEASURES = ("rays", "pairs")
BOXES = ("minimal", "principal")

LINEAR_DEFLECTIONS = (1e-4, 0.02)
"""Least and greatest share of the diagonal; the wall under which it is too coarse is refined anyway."""

ANGULAR_DEFLECTIONS = (1.0, 9.0)
"""Least and greatest angle between facets: finer is too many triangles for a fillet, and 10 degrees
count as parallel."""


@dataclass(frozen=True)
class AnalysisSettings:
    """What enters a result besides the part itself.

    Attributes
    ----------
    linear_deflection : float
        Chord error of the tessellation, as a share of the diagonal of the part.
    angular_deflection : float
        Degrees between neighbouring facets. It must stay well below the 10 degrees that count as
        parallel: at 5 the poles of a spherical shell already give stray wedges.
    wall_deflection : float
        Greatest error of a thickness as a share of the thinnest wall; beyond it the part is
        tessellated finer and measured again.
    measure : str
        ``rays`` or ``pairs``.
    box : str
        ``minimal`` or ``principal``.
    minimum_samples : int
        Least number of samples on a part; it keeps F[a;b] within 0.005 of its value.
    """

    linear_deflection: float = 0.001
    angular_deflection: float = 4.0
    wall_deflection: float = 0.1
    measure: str = "rays"
    box: str = "minimal"
    minimum_samples: int = 20_000

    def __post_init__(self):
        if self.measure not in MEASURES:
            raise ThinPartError(f"There is no measure {self.measure!r}: use rays or pairs.", "usage")
        if self.box not in BOXES:
            raise ThinPartError(f"There is no box {self.box!r}: use minimal or principal.", "usage")
        _check("linear deflection", self.linear_deflection, LINEAR_DEFLECTIONS, "of the diagonal")
        _check("angular deflection", self.angular_deflection, ANGULAR_DEFLECTIONS, "degrees")

    def content(self):
        """dict for the info file."""
        return asdict(self)


def _check(what, value, between, unit):
    least, most = between
    if not least <= value <= most:
        raise ThinPartError(
            f"The {what} cannot be {value:g}: it may be {least:g} to {most:g} {unit}.", "usage")
