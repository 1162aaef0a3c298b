"""How a part is measured: one table of defaults for the command line, the panels and the tests."""

from dataclasses import asdict, dataclass

from .errors import ThinPartError

MEASURES = ("rays", "pairs")
BOXES = ("minimal", "principal")


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

    def content(self):
        """dict for the info file."""
        return asdict(self)
