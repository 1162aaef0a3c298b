"""Parts of a document that are measured for a thickness map, and the map that is made of them."""

from ..core.errors import ThinPartError
from ..core.mapped_part import MappedPart
from ..freecad_adapter.active_part import parts_meant
from ..freecad_adapter.part_places import places_of, sources_of
from ..freecad_adapter.thickness_object import thickness_objects
from ..storage.map_file import read_maps
from ..workflow.document_maps import new_thickness_object, set_parts
from .chosen_in_window import selected_places
from .measured_document import MeasuredDocument
from .qt import QtCore, Signal, translate
from .sentences import translated
from .thickness_view import ThicknessView
from .transaction import transaction


class ThicknessMeasuring(QtCore.QObject):
    """Measures parts in the background and makes or refreshes their map.

    Parameters
    ----------
    document : FreeCAD.Document or None

    Attributes
    ----------
    measured : MeasuredDocument

    Signals
    -------
    ended(object, str)
        The map or None, and a sentence where not all went well. Not sent after `stop`.
    """

    ended = Signal(object, str)

    def __init__(self, document, parent=None):
        super().__init__(parent)
        self.measured = MeasuredDocument(document, self)
        self.measured.mapped.connect(self._take_map)
        self.measured.ended.connect(self._finish)
        self._maps = {}
        self._unreadable = ""
        self._old = None  # name of the map that is refreshed, where it is known

    @property
    def first_label(self):
        """Label of the part that is measured first."""
        return self.measured.analysis.chosen.label

    def start_selected(self):
        """Measure the parts that are selected in the window, or all of them where nothing is.

        Raises
        ------
        ThinPartError
        """
        document, content = self.measured.document, self.measured.content()
        meant = parts_meant(document, content.parts, selected_places(document))
        self._start(meant, content, None)

    def start_again(self, thickness):
        """Measure the parts again that a map is made of.

        Raises
        ------
        ThinPartError
        """
        document, content = self.measured.document, self.measured.content()
        sources = _names(thickness)
        meant = [part for part in content.parts
                 if any(each.Name in sources for each in sources_of(document, [part]))]
        if not meant:
            raise ThinPartError(translate(
                "ThinPart", "'{}' has no parts any more that could be measured.").format(thickness.Label),
                "empty")
        self._start(meant, content, thickness.Name)

    def stop(self):
        """Stop; nothing is changed."""
        self.measured.stop()

    def leave(self):
        """Nobody waits for it any more; an info file that is being written is written to its end."""
        self.measured.leave()

    def _start(self, parts, content, old):
        is_whole = len(parts) == len(content.parts)
        self._maps, self._unreadable, self._old = {}, "", old
        self.measured.measure(self.measured.analysis_of(
            parts, parts[0], content.broken if is_whole else (), maps=True), is_whole)

    def _take_map(self, name, file):
        try:
            self._maps[name] = read_maps(file)[0]
        except ThinPartError as error:
            self._unreadable = translated(error)

    def _finish(self, sentence):
        analysis = self.measured.analysis
        sentences = [each for each in (sentence, self._unreadable) if each]
        sentences += [translate("ThinPart", "{}: {}").format(
            failure["label"], translated(failure["message"]))
            for failure in analysis.failures.values()]
        now = self.measured.parts_now() if analysis.records else None
        thickness = None
        if now is not None:
            # Before the map is in the document, which then differs from its file.
            self.measured.write_info_file(now)
        elif analysis.records:
            self.measured.give_up()
            sentences.append(translate(
                "ThinPart", "The document has changed while it was measured: measure it again."))
        if now is not None and self._maps:
            try:
                thickness, dropped = self._show(now)
            except OSError as error:
                sentences.append(translate(
                    "ThinPart", "There is no room for the thickness map ({}): nothing was changed.").format(
                        error.strerror))
            else:
                sentences += _told_of_dropped(dropped)
        self.ended.emit(thickness, "\n".join(sentences))

    def _show(self, now):
        """Make or refresh the map of parts as they stand in the document now; it, and how many probes are gone."""
        document, parts = self.measured.document, []
        before = {part.name: part for part in self.measured.analysis.parts}
        for part in now:
            known = self._maps.get(part.name)
            if known is not None:
                places = places_of(document, part, before[part.name])
                parts.append(MappedPart(known.record, known.map, known.features, places))
        sources = sources_of(document, [part for part in now if part.name in self._maps])
        with transaction(document, translate("ThinPart", "Show thickness")):
            thickness = self._existing(document, sources)
            if thickness is not None:
                dropped = set_parts(thickness, sources, parts)
            else:
                thickness, dropped = new_thickness_object(document, sources, parts), 0
                thickness.Label = translate("ThinPart", "Thickness")
                ThicknessView(thickness.ViewObject)
        thickness.ViewObject.Proxy.appear()
        return thickness, dropped

    def _existing(self, document, sources):
        if self._old is not None and document.getObject(self._old) is not None:
            return document.getObject(self._old)
        wanted = {source.Name for source in sources}
        return next((each for each in thickness_objects(document) if _names(each) == wanted), None)


def _told_of_dropped(probes):
    """Sentences about probes that the surface has gone from, list of str."""
    if not probes:
        return []
    if probes == 1:
        return [translate("ThinPart", "1 probe was removed: the surface is no longer where it was.")]
    return [translate("ThinPart", "{} probes were removed: the surface is no longer where they were.").format(
        probes)]


def _names(thickness):
    """set of str: the objects that a map is of."""
    return {source.Name for source in thickness.Sources if source is not None}
