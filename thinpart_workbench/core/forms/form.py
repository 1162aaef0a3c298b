# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of a part: what it is compared by with others, wherever they lie."""

from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from .moments import SurfaceMoments, surface_moments
from .outline import Outline, outline_of

NORMAL_SPACINGS = 3.0
"""Spacings of an outline that a normal turned by a radian counts as."""


class _Form(NamedTuple):
    moments: SurfaceMoments
    outline: Outline


class Form(_Form):
    """Moments and outline of a surface.

    Attributes
    ----------
    moments : SurfaceMoments
    outline : Outline
    """

    @cached_property
    def directed_tree(self):
        """The cKDTree of points and normals, those times `normal_length`, so that what is turned away is not near."""
        return cKDTree(np.hstack([self.outline.points, self.normal_length * self.outline.normals]))

    @property
    def normal_length(self):
        """float, mm: a few spacings of the outline."""
        return NORMAL_SPACINGS * float(np.sqrt(self.moments.area / self.outline.count))

    def thinned(self, count):
        """The same form with about so many points of its outline."""
        return Form(self.moments, self.outline.chosen(slice(None, None, max(1, self.outline.count // count))))

    @cached_property
    def radii(self):
        """ndarray of shape (3,), mm: radii of gyration about the centroid along the principal axes, greatest first."""
        return np.sqrt(np.maximum(self._principal[0], 0.0))

    @property
    def axes(self):
        """ndarray of shape (3, 3): column k is the principal direction of ``radii[k]``."""
        return self._principal[1]

    @cached_property
    def extent(self):
        """float, mm: diameter of the sphere about the centroid that holds the outline."""
        return 2.0 * float(np.linalg.norm(self.outline.points, axis=1).max())

    @cached_property
    def _principal(self):
        squares, axes = np.linalg.eigh(self.moments.second)
        return squares[::-1], axes[:, ::-1]


def form_of(field):
    """The `Form` of a measured surface, a ThicknessField."""
    moments = surface_moments(field.mesh)
    return Form(moments, outline_of(field, moments.centroid))
