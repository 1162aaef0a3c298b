# SPDX-License-Identifier: LGPL-2.1-or-later
"""Presents the distribution of a map: its bars, its threshold, and the check of its walls."""

import numpy as np

from ...api.window.limits import limited, offered_limits
from ...api.window.map_values import thickness_bars
from ...core.maps.map_summary import between, share_between, share_of
from ...freecad_adapter.objects.thickness_object import OWN_CHECK
from ..application import lifelong
from ..colour_bar.colours import ThicknessColours
from .map_check import band_texts, checked_limits, map_check_text
from .map_presenter import MapPresenter
from .map_properties import SCALE, THIN, change


class DistributionPresenter(MapPresenter):
    """Connects the box of the distribution with a map."""

    def __init__(self, thickness, shown, highlight, box, parent):
        super().__init__(thickness, shown, box, parent)
        self._highlight = highlight
        self._before_dragging = None  # the previous threshold, while its line is dragged
        self._connect(
            (box.range_chosen, self._choose_range), (box.threshold_changed, self._set_threshold),
            (box.thin_only_changed, lambda on: change(thickness, {"ThinOnly": on})),
            (box.check.chosen, self._choose_check), (box.check.limit_typed, self._check_own_limit),
            (shown.chosen, self.show), (lifelong.face_limits.answered, lambda *_: self._show_face_limits()))

    def show(self):
        """Show everything; no bar is selected."""
        edges, shares, thickest = thickness_bars(self._shown.shown, self._thickness.Threshold, self._shown.unit)
        diagonal = max(part.record["descriptors"]["diagonal_mm"] for part in self._shown.shown)
        self._box.show_shares(edges, shares, thickest, diagonal, self._shown.unit, self._thickness.Measure)
        self._box.show_choice(None, 0.0, 0)
        self._show_colours()
        self._show_threshold()

    def refresh(self, changed):
        """Show what has changed: set of names of properties."""
        if changed & set(THIN):
            self._show_threshold()
        if changed & {*SCALE, *THIN, "Stale"}:
            self._show_colours()

    def show_whole(self):
        """Select no bar: greyed facets would hide the wall that is flown to."""
        self._box.chart.clear_choice()

    def _show_colours(self):
        chart = self._box.chart
        middles = 0.5 * (chart.edges[1:] + chart.edges[:-1])
        if chart.thickest > chart.edges[-1]:
            middles[-1] = chart.thickest
        colours = ThicknessColours.of(self._thickness)
        chart.show_colours(colours.of_values(middles, self._are_thick(chart.edges, colours)))

    def _are_thick(self, edges, colours):
        """Of which bars most of the surface is too thick: ndarray of bool, or None where that is not checked."""
        if colours.maps is None or not colours.maps.has_thick:
            return None
        ends = np.append(edges[:-1], np.inf)
        return np.array([2.0 * share_of(self._shown.shown, [
            between(part.map, *bar) & colours.are_thick(number) for number, part in self._shown.numbered.items()])
            > share_between(self._shown.shown, *bar) for bar in zip(ends[:-1], ends[1:])])

    def _show_threshold(self):
        threshold, parts = self._thickness.Threshold, self._shown.shown
        self._box.show_threshold(threshold, share_between(parts, 0.0, threshold), self._thickness.ThinOnly)
        face_limits = lifelong.face_limits.known(self._thickness.Document.FileName)
        self._box.check.show_check(
            self._thickness.Check, threshold, self._shown.unit,
            band_texts(self._shown.numbered, ThicknessColours.of(self._thickness)),
            map_check_text([limited(part.record, face_limits) for part in parts], checked_limits(self._thickness),
                           self._shown.unit, self._thickness.Measure))

    def _show_face_limits(self):
        """What the faces have of their own is known, or has changed: what is too thick depends on it."""
        self._thickness.ViewObject.Proxy.colour()
        self._show_colours()
        self._show_threshold()

    def _choose_range(self, chosen):
        if chosen is None:
            self._highlight.clear()
            self._box.show_choice(None, 0.0, 0)
        else:
            count = self._highlight.choose_range(*chosen)
            self._box.show_choice(chosen, share_between(self._shown.shown, *chosen), count)

    def _set_threshold(self, threshold, is_final):
        if not is_final:
            if self._before_dragging is None:
                self._before_dragging = self._thickness.Threshold
            self._thickness.Threshold = threshold
            return
        before, self._before_dragging = self._before_dragging, None
        if before is not None:
            self._thickness.Threshold = before  # the value that Undo restores
        own = {"Check": OWN_CHECK, "CheckMost": 0.0} if self._thickness.Check else {}
        change(self._thickness, {"Threshold": threshold, **own})

    def _choose_check(self, name):
        limits = offered_limits().get(name)
        values = {} if limits is None else {"Threshold": limits.min_mm or 0.0}
        change(self._thickness, {"Check": name, "CheckMost": 0.0 if limits is None else limits.max_mm or 0.0, **values})

    def _check_own_limit(self, limit):
        change(self._thickness, {"Check": OWN_CHECK, "CheckMost": 0.0, "Threshold": limit})
