# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part as it is shown: its record, its thickness map, and the matrices of its occurrences."""

from dataclasses import dataclass, field

import numpy as np

from .thickness_map import ThicknessMap


@dataclass(frozen=True)
class MappedPart:
    """One distinct part of a document.

    Attributes
    ----------
    record : PartRecord
    map : ThicknessMap
        In the position of the first occurrence.
    features : list of str
        The feature that made each B-Rep face, by face number; empty where that is not known.
    matrices : ndarray of shape (p, 4, 4)
        From the position of the first occurrence to that of each occurrence, so the identity is among them.
    """

    record: dict
    map: ThicknessMap
    features: list = field(default_factory=list)
    matrices: np.ndarray = field(default_factory=lambda: np.eye(4)[None])
