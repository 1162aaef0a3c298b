"""What follows in the window from which thickness maps there are: bars, covered sources, staleness."""

import FreeCAD as App
import FreeCADGui as Gui

from ..freecad_adapter.thickness_object import thickness_objects
from .colour_bar_node import ColourBarNode
from .covered_sources import CoveredSources
from .qt import QtWidgets
from .thickness_view import ThicknessView
from .thickness_watch import look_soon


class ThicknessDisplay:
    """Brings the window into line with the documents.

    Notes
    -----
    Undo and Redo take objects away, bring them back and change them without telling their view providers. So
    nothing is switched on and off by events; they only have everything looked at again.
    """

    def __init__(self):
        self._shown = []  # names of document and object of the visible maps, the one shown last at the end
        self._bars = []
        self._covered = CoveredSources()
        area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
        if area is not None:
            area.subWindowActivated.connect(lambda _: look_soon())

    def look(self):
        """Look at all documents."""
        busy, visible, sources = False, [], set()
        for name, document in App.listDocuments().items():
            if document.Restoring or document.Recomputing:
                busy = True
                continue
            for thickness in thickness_objects(document):
                if getattr(thickness, "ViewObject", None) is None:
                    continue
                self._follow(thickness)
                if thickness.ViewObject.Visibility:
                    visible.append((name, thickness.Name))
                    sources |= {(each.Document.Name, each.Name) for each in thickness.Sources}
        if busy:
            look_soon()
            return
        self._shown = [each for each in self._shown if each in visible] + [
            each for each in visible if each not in self._shown]
        self._covered.cover(sources)
        self._show_bars()

    def forget(self, name):
        """A document is about to be closed."""
        self._covered.forget(name)
        self._shown = [each for each in self._shown if each[0] != name]

    def _follow(self, thickness):
        view = thickness.ViewObject
        if not isinstance(view.Proxy, ThicknessView):
            ThicknessView(view)  # the document was saved without a window
        thickness.Proxy.check(thickness)
        view.Proxy.refresh()

    def _show_bars(self):
        last = dict(self._shown)  # of several maps of a document, the one shown last
        bars = []
        for document in App.listDocuments():
            gui_document = Gui.getDocument(document)
            for view in gui_document.mdiViewsOfType("Gui::View3DInventor"):
                root = view.getSceneGraph()
                bar = next((each for each in self._bars if each.is_in(root)), None)
                content = self._content(document, last.get(document))
                if content is not None:
                    bar = bar or ColourBarNode(view)
                    bar.show(content)
                    bars.append(bar)
                elif bar is not None:
                    bar.remove()
        self._bars = bars

    def _content(self, document, name):
        if name is None:
            return None
        return App.getDocument(document).getObject(name).ViewObject.Proxy.bar


DISPLAY = ThicknessDisplay()
"""The one of this session."""
