"""Updates colour bars, covered sources and staleness from the thickness maps in the documents."""

import FreeCAD as App
import FreeCADGui as Gui

from ...freecad_adapter.objects.thickness_object import thickness_objects
from ...freecad_adapter.preferences import preference
from ..application import lifelong
from ..application.qt import QtWidgets
from ..colour_bar.colour_bar_node import ColourBarNode
from .covered_sources import CoveredSources
from .label_node import LabelNode
from .view_provider import ThicknessView


class SceneSync:
    """Synchronises the window with the documents.

    Notes
    -----
    Undo and Redo remove, restore and change objects without notifying their view providers. Events therefore
    switch nothing themselves; they only schedule a refresh of everything.
    """

    def __init__(self):
        self._shown = []  # (document name, object name) of visible maps, the most recent last
        self._bars, self._labels = [], []
        self._covered = CoveredSources()
        area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
        if area is not None:
            area.subWindowActivated.connect(lambda _: lifelong.map_events.refresh_soon())

    def refresh(self):
        """Refresh the maps of all documents."""
        busy, visible, sources = False, [], set()
        for name, document in App.listDocuments().items():
            if document.Restoring or document.Recomputing:
                busy = True
                continue
            for thickness in thickness_objects(document):
                if getattr(thickness, "ViewObject", None) is None:
                    continue
                self._refresh_map(thickness)
                if thickness.ViewObject.Visibility:
                    visible.append((name, thickness.Name))
                    if thickness.ViewObject.Proxy.is_complete:
                        sources |= {(source.Document.Name, source.Name) for source in thickness.Sources}
        if busy:
            lifelong.map_events.refresh_soon()
            return
        self._shown = [key for key in self._shown if key in visible] + [
            key for key in visible if key not in self._shown]
        self._covered.cover(sources)
        self._show_bars()

    def forget(self, name):
        """Drop the maps of a document that is being closed."""
        self._covered.forget(name)
        self._shown = [key for key in self._shown if key[0] != name]

    def _refresh_map(self, thickness):
        view = thickness.ViewObject
        if not isinstance(view.Proxy, ThicknessView):
            ThicknessView(view)  # the document was saved without a window
        thickness.Proxy.check(thickness)
        view.Proxy.refresh()

    def _show_bars(self):
        last = dict(self._shown)  # the most recently shown map of each document
        bars, labels = [], []
        for document in App.listDocuments():
            gui_document = Gui.getDocument(document)
            for view in gui_document.mdiViewsOfType("Gui::View3DInventor"):
                root = view.getSceneGraph()
                bar = next((bar for bar in self._bars if bar.is_in(root)), None)
                content = self._content(document, last.get(document))
                if content is not None:
                    bar = bar or ColourBarNode(view)
                    bar.show(content)
                    bars.append(bar)
                elif bar is not None:
                    bar.remove()
                    bar = None
                node = self._show_labels(view, root, document, last.get(document), bar)
                if node is not None:
                    labels.append(node)
        self._bars, self._labels = bars, labels

    def _show_labels(self, view, root, document, name, bar):
        """The LabelNode of a view; None where nothing is labelled."""
        node = next((node for node in self._labels if node.is_in(root)), None)
        content = None if name is None or not preference("MapLabels") else _proxy(document, name).labels
        if content is None:
            if node is not None:
                node.remove()
            return None
        node = node or LabelNode(view)
        node.obstacles = [] if bar is None else [bar]
        node.show(content)
        return node

    def _content(self, document, name):
        return None if name is None or not preference("ColourBarShown") else _proxy(document, name).bar


def _proxy(document, name):
    return App.getDocument(document).getObject(name).ViewObject.Proxy
