# SPDX-License-Identifier: LGPL-2.1-or-later
"""Updates colour bars, covered sources and staleness from the thickness maps in the documents."""

import FreeCAD as App
import FreeCADGui as Gui

from ...freecad_adapter.objects.thickness_object import thickness_objects
from ...freecad_adapter.preferences import preference
from ..application import lifelong
from ..application.qt import QtWidgets
from ..colour_bar.colour_bar_node import ColourBarNode
from ..scene.document_views import views_of
from .covered_sources import CoveredSources
from .label_node import LabelNode
from .navigation_watch import NavigationWatch
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
        self._bars, self._labels, self._watches = [], [], []  # of the views that show a map
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
            first = self._first_colours(name)
            if first is not None:
                sources |= {(name, covered) for covered in first.covered}
            for thickness in thickness_objects(document):
                if getattr(thickness, "ViewObject", None) is None:
                    continue
                self._refresh_map(thickness)
                thickness.ViewObject.Proxy.cover(
                    lifelong.map_events.set_aside.get(name, False)
                    or first is not None and first.stands_for(thickness.Name))
                if thickness.ViewObject.Visibility:
                    visible.append((name, thickness.Name))
                    if thickness.ViewObject.Proxy.is_complete:
                        sources |= {(source.Document.Name, source.Name) for source in thickness.Sources}
        if busy:
            lifelong.map_events.refresh_soon()
            return
        self._shown = [key for key in self._shown if key in visible] + [
            key for key in visible if key not in self._shown]
        self._covered.cover(sources, lifelong.map_events.shown_again)
        lifelong.map_events.shown_again.clear()
        self._show_bars()

    def bar_in(self, view):
        """The ColourBarNode of a view, or None."""
        return next((bar for bar in self._bars if bar.is_in(view.getSceneGraph())), None)

    def forget(self, name):
        """Drop the maps of a document that is being closed."""
        self._covered.forget(name)
        lifelong.map_events.first_colours.pop(name, None)
        lifelong.map_events.set_aside.pop(name, None)
        self._shown = [key for key in self._shown if key[0] != name]

    def _first_colours(self, name):
        """The FirstColours in a document, or None."""
        first = lifelong.map_events.first_colours.get(name)
        if first is not None:
            first.refresh()
        return lifelong.map_events.first_colours.get(name)

    def _refresh_map(self, thickness):
        view = thickness.ViewObject
        if not isinstance(view.Proxy, ThicknessView):
            ThicknessView(view)  # the document was saved without a window
        thickness.Proxy.check(thickness)
        view.Proxy.refresh()

    def _show_bars(self):
        last = dict(self._shown)  # the most recently shown map of each document
        bars, labels, watches = [], [], []
        for document in App.listDocuments():
            first, name = lifelong.map_events.first_colours.get(document), last.get(document)
            shown = None if document in lifelong.map_events.set_aside else first or _proxy(document, name)
            for view in views_of(document):
                content = shown.bar if shown is not None and preference("ColourBarShown") else None
                bar = _node_in(view, self._bars, ColourBarNode, content)
                if bar is not None:
                    bar.show(content)
                    bars.append(bar)
                content = shown.labels if shown is not None and first is None and preference("MapLabels") else None
                node = _node_in(view, self._labels, LabelNode, content)
                if node is not None:
                    node.obstacles = [] if bar is None else [bar]
                    node.show(content)
                    labels.append(node)
                if first is not None or name is not None:
                    root = view.getSceneGraph()
                    watch = next((watch for watch in self._watches if watch.is_in(root)), None)
                    watches.append(watch or NavigationWatch(view, document))
        for watch in self._watches:
            if watch not in watches:
                watch.end()
        self._bars, self._labels, self._watches = bars, labels, watches


def _node_in(view, nodes, kind, content):
    """The one of some nodes that is in a view, or a new one of a kind; None, and none is there, without content."""
    node = next((node for node in nodes if node.is_in(view.getSceneGraph())), None)
    if content is not None:
        return node or kind(view)
    if node is not None:
        node.remove()
    return None


def _proxy(document, name):
    """The ThicknessView of a map; None where no map is named."""
    return None if name is None else App.getDocument(document).getObject(name).ViewObject.Proxy
