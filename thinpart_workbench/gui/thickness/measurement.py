# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures parts of a document and makes or refreshes their thickness map."""

import numpy as np

from ...api.document_maps import new_thickness_object, set_parts
from ...api.window.open_parts import parts_selected
from ...core.analysis_settings import RAY
from ...core.errors import ThinPartError
from ...core.maps.mapped_part import MappedPart
from ...freecad_adapter.objects.thickness_object import thickness_objects
from ...freecad_adapter.occurrences.occurrences import occurrence_matrices, sources_of
from ...storage.map_file import read_maps
from ..application.qt import QtCore, Signal, translate
from ..application.sentences import translated
from ..document.document_measurement import DocumentMeasurement
from ..document.selection import selected_paths
from ..document.transaction import transaction
from ..view3d.first_colours import FirstColours
from ..view3d.shown_map import show_alone
from ..view3d.view_provider import ThicknessView


class ThicknessMeasurement(QtCore.QObject):
    """Measures parts in the background and makes or refreshes their map.

    Parameters
    ----------
    document : FreeCAD.Document or None
    parent : QObject, optional
    with_first_colours : bool, optional
        Whether coarse colours are shown until the map is there.

    Attributes
    ----------
    measured : DocumentMeasurement

    Signals
    -------
    ended(object, str)
        The map or None, and a message if anything failed. Not emitted after `stop`.
    """

    ended = Signal(object, str)

    def __init__(self, document, parent=None, with_first_colours=False):
        super().__init__(parent)
        self._with_first_colours, self._first = with_first_colours, None
        self.measured = DocumentMeasurement(document, self)
        self.measured.mapped.connect(self._on_mapped)
        self.measured.first_mapped.connect(self._on_first_mapped)
        self.measured.ended.connect(self._finish)
        self._maps = {}
        self._unreadable = ""
        self._old = None  # name of the map to refresh, if known

    @property
    def first_label(self):
        """Label of the first part to be measured."""
        return self.measured.analysis.first_part.label

    def start_selected(self, shown_measure=RAY):
        """Measure the selected parts, or all parts if nothing is selected, by one of `SHOWN_MEASURES`.

        Raises a ThinPartError where there is nothing to measure.
        """
        document, content = self.measured.document, self.measured.content()
        parts = parts_selected(document, selected_paths(document), parts=content.parts)
        self._start(parts, content, None, shown_measure)

    def start_again(self, thickness, shown_measure=None):
        """Measure the sources of a map again, by another of `SHOWN_MEASURES` if one is given; raises as `start_selected`."""
        document, content = self.measured.document, self.measured.content()
        sources = _names(thickness)
        parts = [part for part in content.parts
                 if any(source.Name in sources for source in sources_of(document, [part]))]
        if not parts:
            raise ThinPartError(translate(
                "ThinPart", "'{}' no longer has a part that can be measured.").format(thickness.Label),
                "empty")
        self._start(parts, content, thickness.Name, shown_measure or thickness.Measure)

    @property
    def shows_first_colours(self):
        """Whether the views show coarse colours, and nothing better."""
        return self._first is not None and self._first.is_shown and not self._first.is_giving_way

    def stop(self):
        """Stop measuring; the document stays unchanged, and the first colours stay in the views."""
        self.measured.stop()

    def leave(self):
        """Abandon the measurement and its first colours; an info file in progress is still completed."""
        self.measured.leave()
        if self._first is not None and not self._first.is_giving_way:
            self._first.end()

    def _start(self, parts, content, old, shown_measure):
        is_complete = len(parts) == len(content.parts)
        self._maps, self._unreadable, self._old = {}, "", old
        before, self._first = self._first, self._new_first_colours(parts, shown_measure)
        if before is not None:
            before.end()
        self.measured.measure(self.measured.analysis_of(
            parts, parts[0], content.broken if is_complete else (), shown_measure, self._first is not None), is_complete)

    def _new_first_colours(self, parts, shown_measure):
        """FirstColours of parts that are to be measured; None where a map in the view says as much already."""
        if not self._with_first_colours:
            return None
        document = self.measured.document
        like = self._existing(document, sources_of(document, parts))
        sources = {part.name: {source.Name for source in sources_of(document, [part])} for part in parts}
        visible = [other for other in thickness_objects(document) if other.ViewObject.Visibility]
        if any(other == like and not like.Stale and like.Measure == shown_measure for other in visible):
            return None
        if any(other != like and not _names(other).isdisjoint(set().union(*sources.values())) for other in visible):
            return None  # its facets would be in the same place
        return FirstColours(document, sources, shown_measure, like)

    def _on_first_mapped(self, name, file):
        part = next(part for part in self.measured.analysis.parts if part.name == name)
        try:
            coarse, = read_maps(file)
            places = np.eye(4)[None] if part.instances == 1 else occurrence_matrices(self.measured.document, part, part)
        except ThinPartError:
            return  # measuring it, which goes on, says what is wrong
        self._first.show(MappedPart(coarse.record, coarse.map, [], places))

    def _on_mapped(self, name, file):
        try:
            self._maps[name] = read_maps(file)[0]
        except ThinPartError as error:
            self._unreadable = translated(error)

    def _finish(self, sentence):
        analysis = self.measured.analysis
        sentences = [text for text in (sentence, self._unreadable) if text]
        sentences += [translate("ThinPart", "{}: {}").format(
            failure["label"], translated(failure["message"]))
            for failure in analysis.failures.values()]
        now = self.measured.current_parts() if analysis.records else None
        thickness = None
        if now is not None:
            # Before the map is added to the document, which then differs from its file.
            self.measured.write_info_file(now)
        elif analysis.records:
            self.measured.abandon_info_file()
            if self._first is not None:
                self._first.end()  # they are of parts that are no longer there
            sentences.append(translate(
                "ThinPart", "The document has changed while it was measured: measure it again."))
        if now is not None and self._maps:
            try:
                thickness, dropped = self._show(now)
            except OSError as error:
                sentences.append(translate(
                    "ThinPart", "The thickness map cannot be written ({}): free some disk space. Nothing "
                                "was changed.").format(
                        error.strerror))
            else:
                sentences += _dropped_probe_sentences(dropped)
        if self.shows_first_colours:
            sentences.append(coarse_sentence())
        self.ended.emit(thickness, "\n".join(sentences))

    def _show(self, now):
        """Make or refresh the map of the current parts; return it and the number of dropped probes."""
        document, parts = self.measured.document, []
        before = {part.name: part for part in self.measured.analysis.parts}
        for part in now:
            mapped = self._maps.get(part.name)
            if mapped is not None:
                places = occurrence_matrices(document, part, before[part.name])
                parts.append(MappedPart(mapped.record, mapped.map, mapped.features, places))
        sources = sources_of(document, [part for part in now if part.name in self._maps])
        with transaction(document, translate("ThinPart", "Show thickness")):
            thickness = self._existing(document, sources)
            if thickness is not None:
                dropped = set_parts(thickness, sources, parts)
            else:
                thickness, dropped = new_thickness_object(document, sources, parts), 0
                thickness.Label = translate("ThinPart", "Thickness")
                ThicknessView(thickness.ViewObject)
            show_alone(thickness)
        if self._first is not None and self._first.is_shown:
            thickness.ViewObject.Proxy.cover(True)
            self._first.give_way(thickness)
        thickness.ViewObject.Proxy.show_in_batches()
        return thickness, dropped

    def _existing(self, document, sources):
        if self._old is not None and document.getObject(self._old) is not None:
            return document.getObject(self._old)
        names = {source.Name for source in sources}
        return next((existing for existing in thickness_objects(document) if _names(existing) == names), None)


def coarse_sentence():
    """What people read where only first colours are in the view."""
    return translate("ThinPart", "The colours in the view are the first, coarse ones: they are not saved, and go when this "
                                 "panel is closed.")


def _dropped_probe_sentences(probes):
    """Messages about probes that no longer lie on the surface: list of str."""
    if not probes:
        return []
    if probes == 1:
        return [translate("ThinPart", "1 probe was removed: the surface is no longer at its position.")]
    return [translate("ThinPart", "{} probes were removed: the surface is no longer at their positions.").format(
        probes)]


def _names(thickness):
    """Names of the source objects of a map: set of str."""
    return {source.Name for source in thickness.Sources if source is not None}
