# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of a measurement: one set of defaults for the command line, the panels and the tests."""

from dataclasses import asdict, dataclass, replace
from typing import NamedTuple

from .errors import ThinPartError
from .message import message

DEFAULT_PROFILE = "calibrated"
"""The shipped profile that judges where none is named."""

MEASURES = RAYS, PAIRS = ("rays", "pairs")
BOXES = ("minimal", "principal")

SHOWN_MEASURES = RAY, SPHERE, LOCAL = ("ray", "sphere", "local")
"""What thickness maps show: the wall across, along the inward normal; the diameter of the largest ball inside that touches
the surface; or of the largest that reaches it, the local thickness. Verdicts do not depend on it."""

MOST_TRIANGLES = 400_000
"""A part is not tessellated more finely if that would exceed this number."""

LINEAR_DEFLECTIONS = (1e-4, 0.02)
"""Least and greatest value, as a share of the diagonal. Where that is too coarse for a wall, the part is
refined anyway."""

ANGULAR_DEFLECTIONS = (1.0, 15.0)
"""Least and greatest angle between facets, degrees: a smaller one gives too many triangles on a fillet, and walls
at up to 10 degrees count as parallel."""


class Fineness(NamedTuple):
    """How finely a part is measured.

    Attributes
    ----------
    linear_deflection : float
        Share of the diagonal.
    angular_deflection : float, degrees
    minimum_samples : int
    """

    linear_deflection: float
    angular_deflection: float
    minimum_samples: int


ACCURACIES = {
    "verdict": Fineness(0.002, 12.0, 4_000),
    "standard": Fineness(0.001, 12.0, 12_000),
    "fine": Fineness(0.0005, 6.0, 36_000),
}
"""From the coarsest to the finest. A part whose verdict is uncertain at one is measured again at the next."""

STANDARD = "standard"


@dataclass(frozen=True)
class AnalysisSettings:
    """The settings that affect a result.

    Attributes
    ----------
    linear_deflection : float
        Chord error of the tessellation, as a share of the diagonal of the part.
    angular_deflection : float
        Degrees between neighbouring facets. Walls are measured between the smooth surfaces that facets approximate, so that
        12 degrees are as good as 2.
    wall_deflection : float
        Greatest error of a thickness as a share of the thinnest wall; beyond it the part is
        tessellated finer and measured again.
    measure : str
        ``rays`` or ``pairs``.
    box : str
        ``minimal`` or ``principal``.
    minimum_samples : int
        Number of samples on a part; a face has four at least. 12,000 keep F[a;b] within 0.005 of its value.
    accuracy : str
        One of `ACCURACIES`: how finely parts are measured at first.
    """

    linear_deflection: float = ACCURACIES[STANDARD].linear_deflection
    angular_deflection: float = ACCURACIES[STANDARD].angular_deflection
    wall_deflection: float = 0.1
    measure: str = "rays"
    box: str = "minimal"
    minimum_samples: int = ACCURACIES[STANDARD].minimum_samples
    accuracy: str = STANDARD

    def __post_init__(self):
        if self.measure not in MEASURES:
            raise ThinPartError(message("There is no measure {measure!r}: use rays or pairs.",
                                        measure=self.measure), "usage")
        if self.accuracy not in ACCURACIES:
            raise ThinPartError(message("There is no accuracy {accuracy!r}: use {known}.",
                                        accuracy=self.accuracy, known=", ".join(ACCURACIES)), "usage")
        if self.box not in BOXES:
            raise ThinPartError(message("There is no box {box!r}: use minimal or principal.", box=self.box), "usage")
        _check(message("linear deflection"), self.linear_deflection, LINEAR_DEFLECTIONS, message("of the diagonal"))
        _check(message("angular deflection"), self.angular_deflection, ANGULAR_DEFLECTIONS, "degrees")

    @classmethod
    def at(cls, accuracy, **changes):
        """The settings of one of `ACCURACIES`, with changes to them.

        Raises ThinPartError, kind ``usage`` if there is no such accuracy, or a change is out of its range.
        """
        fineness = ACCURACIES.get(accuracy, ACCURACIES[STANDARD])
        return cls(**{**fineness._asdict(), "accuracy": accuracy, **changes})

    @property
    def finer(self):
        """AnalysisSettings or None: those of the next of `ACCURACIES`, nowhere coarser than these; None after the last."""
        names = list(ACCURACIES)
        following = names[names.index(self.accuracy) + 1:]
        if not following:
            return None
        fineness = ACCURACIES[following[0]]
        return replace(
            self, accuracy=following[0], linear_deflection=min(self.linear_deflection, fineness.linear_deflection),
            angular_deflection=min(self.angular_deflection, fineness.angular_deflection),
            minimum_samples=max(self.minimum_samples, fineness.minimum_samples))

    def content(self):
        """dict for the info file."""
        return asdict(self)


def given_settings(settings=None):
    """AnalysisSettings from any of the forms in which a caller may give them: themselves, a dict as of their `content`, or
    None for the default."""
    return settings if isinstance(settings, AnalysisSettings) else AnalysisSettings(**settings or {})


def _check(what, value, bounds, unit):
    least, most = bounds
    if not least <= value <= most:
        raise ThinPartError(
            message("The {what} cannot be {value:g}: use a value from {least:g} to {most:g} {unit}.",
                    what=what, value=value, least=least, most=most, unit=unit), "usage")


FIRST_LOOK = AnalysisSettings(linear_deflection=0.005, angular_deflection=15.0)
"""How finely a part is tessellated for its first colours, from which nothing is judged."""
