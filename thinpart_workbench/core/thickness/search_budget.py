# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the search for slanted walls may cost, in counted work: the same on every machine."""

import math

from ..rays.tree_descent import Work

# Costs, in those of testing the eight boxes of a node for a ray, fitted to the times of real parts. First those of what is
# counted, then those of beginning something, however little it finds.
_PER_SAMPLE, _PER_RAY_PAIR = 5.0, 0.8
_PER_NODE, _PER_PAIR, _PER_OVERLAP, _PER_CUT = 1.5, 1.8, 15.0, 90.0
_OF_SEARCH, _PER_TRIANGLE, _OF_PORTION, _OF_OVERLAPS, _OF_CUTS = 3_000, 2.0, 1_500, 3_500, 4_500


def cost_of_rays(samples, work):
    """What casting rays has cost: float.

    Parameters
    ----------
    samples : int
    work : Work
    """
    return _PER_SAMPLE * samples + work.nodes + _PER_RAY_PAIR * work.pairs


class SearchBudget:
    """What a search may still cost.

    Attributes
    ----------
    work : Work
        Counters that the search increases.

    Parameters
    ----------
    most : float
        All that it may cost; inf for no limit.
    work : Work, optional
    """

    def __init__(self, most, work=None):
        self.work = work or Work()
        self._most, self._begun = most, 0.0

    @property
    def is_spent(self):
        """Whether nothing more may be begun."""
        return self._left <= 0.0

    def begin_search(self, triangles):
        """Whether a search among triangles may be begun. If not, here and below, nothing may be begun any more."""
        # Pairs are of no use unless some are cut.
        return self._begin(_OF_SEARCH + _PER_TRIANGLE * triangles, _OF_PORTION + _OF_OVERLAPS + _OF_CUTS)

    def begin_portion(self):
        """Whether more pairs of triangles may be looked for."""
        return self._begin(_OF_PORTION)

    def begin_overlaps(self, most):
        """int: of how many pairs the overlaps may be looked for next; 0 for none."""
        return self._begin_some(_OF_OVERLAPS, most, _PER_OVERLAP)

    def begin_cuts(self, most):
        """int: how many overlaps may be cut next; 0 for none."""
        return self._begin_some(_OF_CUTS, most, _PER_CUT)

    @property
    def _left(self):
        done = self.work
        return self._most - self._begun - (
            _PER_NODE * done.nodes + _PER_PAIR * done.pairs + _PER_OVERLAP * done.overlaps + _PER_CUT * done.exact)

    def _begin(self, cost, more=0.0):
        self._begun += cost if self._left > cost + more else math.inf
        return not self.is_spent

    def _begin_some(self, cost, most, each):
        return int(min(most, self._left / each + 1.0)) if self._begin(cost) else 0
