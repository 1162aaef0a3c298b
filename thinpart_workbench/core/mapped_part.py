"""A part as it is shown: its record, its thickness map, and where it stands."""

from dataclasses import dataclass, field

import numpy as np

from .thickness_map import ThicknessMap


@dataclass(frozen=True)
class MappedPart:
    """One distinct part of a document.

    Attributes
    ----------
    record : dict
        Part record.
    map : ThicknessMap
        Where the part stands first.
    features : list of str
        What made each B-Rep face, by its number; empty where that is not known.
    places : ndarray of shape (p, 4, 4)
        From where the part stands first to each place where it stands, the identity among them.
    """

    record: dict
    map: ThicknessMap
    features: list = field(default_factory=list)
    places: np.ndarray = field(default_factory=lambda: np.eye(4)[None])
