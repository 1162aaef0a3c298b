"""The thickness under the cursor, and probes that are pinned by a click."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from ..core.errors import ThinPartError
from ..core.map_search import MapSearch
from ..freecad_adapter.edge import guarded_methods
from ..workflow.document_maps import map_version, parts_of
from ..workflow.thickness_probes import Probe, moved_matrix, probes_of, set_probes, wall_at_place
from .length_unit import length_unit
from .qt import QtCore, QtWidgets, Signal, mouse_place, soon, translate
from .transaction import transaction
from .view_ray import line_of_sight, seen_first

_STILL = 3
"""Pixels within which a press and a release are a click and not a drag."""


def add_probe(thickness, point, opposite, value):
    """Pin a probe; can be undone.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
    point, opposite : array_like of shape (3,), mm
        In the coordinates of the document, as it is now.
    value : float, mm
    """
    back = np.linalg.inv(moved_matrix(thickness))
    ends = [tuple(back[:3, :3] @ np.asarray(each, dtype=float) + back[:3, 3]) for each in (point, opposite)]
    _set(thickness, [*probes_of(thickness), Probe(*ends, float(value))],
         translate("ThinPart", "Pin thickness"))


def remove_probe(thickness, number):
    """Remove a probe by its number, from 0; can be undone."""
    probes = probes_of(thickness)
    del probes[number]
    _set(thickness, probes, translate("ThinPart", "Remove thickness"))


def probe_ends(thickness, number):
    """Point and opposite of a probe as they stand now, two ndarray of shape (3,), mm."""
    matrix, probe = moved_matrix(thickness), probes_of(thickness)[number]
    return tuple(matrix[:3, :3] @ np.array(each) + matrix[:3, 3] for each in (probe.point, probe.opposite))


def _set(thickness, probes, name):
    with transaction(thickness.Document, name):
        set_probes(thickness, probes)


@guarded_methods(eventFilter=False)
class ThicknessPicker(QtCore.QObject):
    """Follows the mouse over the 3D views of one thickness map, from `start` to `stop`.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject

    Signals
    -------
    hovered(object)
        None, or a dict: ``part`` and ``face`` (numbers from 0), ``place``, ``thickness`` (mm, None where
        nothing was measured), ``point`` and ``opposite`` (ndarray of shape (3,), mm, in the document).
    probed()
        A probe was pinned.
    """

    hovered = Signal(object)
    probed = Signal()

    def __init__(self, thickness, parent=None):
        super().__init__(parent)
        self._names = thickness.Document.Name, thickness.Name
        self._views = []  # (view, its widget, label, what its selection was set to)
        self._searches = None
        self._pressed = None
        self._place = None
        self._timer = QtCore.QTimer(self)  # moves come faster than they can be answered
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._hover)

    @property
    def is_active(self):
        """Whether it follows the mouse."""
        return bool(self._views)

    def start(self):
        """Follow the mouse; FreeCAD's own selection rests in these views meanwhile."""
        self.stop()
        for view in Gui.getDocument(self._names[0]).mdiViewsOfType("Gui::View3DInventor"):
            widget = view.graphicsView().viewport()
            widget.installEventFilter(self)
            tracked = widget.hasMouseTracking()
            widget.setMouseTracking(True)
            self._views.append((view, widget, _label(widget), (_rest(view), tracked)))

    def stop(self):
        """Let go of the mouse."""
        self._timer.stop()
        views, self._views = self._views, []
        self._pressed = self._place = None
        for view, widget, label, (selection, tracked) in views:
            try:
                widget.removeEventFilter(self)
                widget.setMouseTracking(tracked)
                label.hide()
                label.deleteLater()
                _resume(view, selection)
            except (RuntimeError, ReferenceError):
                continue  # the view was closed
        if views:
            self.hovered.emit(None)

    def wall_at(self, view, place):
        """What `hovered` tells, of any place of a view (QPoint); None beside the map."""
        thickness = self._thickness
        if thickness is None or not thickness.ViewObject.Visibility:
            return None
        try:
            near, direction = line_of_sight(view, place)
            wall = self._met(thickness, near, direction)
        except ThinPartError:
            return None  # its view provider has told that the map cannot be read
        return None if wall is None or self._is_hidden(view, place, wall, direction) else wall

    def eventFilter(self, widget, event):
        """Look at what the mouse does, and leave it to the view."""
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove:
            self._place = widget, mouse_place(event)
            if not self._timer.isActive():
                self._timer.start(15)
        elif kind == QtCore.QEvent.Leave:
            self._place = widget, None
            self._timer.start(0)
        elif kind == QtCore.QEvent.MouseButtonPress:
            # A second button held down turns or moves the view in most navigation styles.
            alone = event.button() == event.buttons() == QtCore.Qt.LeftButton
            plain = event.modifiers() == QtCore.Qt.NoModifier
            self._pressed = mouse_place(event) if alone and plain else None
        elif kind == QtCore.QEvent.MouseButtonRelease and self._pressed is not None:
            if event.button() == QtCore.Qt.LeftButton and (
                    (mouse_place(event) - self._pressed).manhattanLength() <= _STILL):
                # After the view has had the event.
                place = mouse_place(event)
                soon(self, lambda: self._pin(widget, place))
            self._pressed = None
        return False

    @property
    def _thickness(self):
        document, name = self._names
        if document not in App.listDocuments():
            return None
        return App.getDocument(document).getObject(name)

    def _view_of(self, widget):
        return next((each for each in self._views if each[1] is widget or each[1] == widget), None)

    def _hover(self):
        if self._place is None:
            return
        widget, place = self._place
        found = self._view_of(widget)
        if found is None:
            return
        view, _, label, _ = found
        if not _exists(label):
            return  # the view was closed since the mouse was moved over it
        wall = None if place is None else self.wall_at(view, place)
        if wall is None:
            label.hide()
        else:
            label.setText(_text(wall["thickness"], length_unit(self._thickness.Document)))
            label.adjustSize()
            label.move(_beside(place, label.size(), widget.size()))
            label.show()
        self.hovered.emit(wall)

    def _pin(self, widget, place):
        found = self._view_of(widget)
        wall = None if found is None else self.wall_at(found[0], place)
        if wall is None or wall["thickness"] is None:
            return
        add_probe(self._thickness, wall["point"], wall["opposite"], wall["thickness"])
        self.probed.emit()

    def _is_hidden(self, view, place, wall, direction):
        """Whether another object stands before the map; its source does not."""
        names, point = seen_first(view, place)
        thickness = self._thickness
        own = {(each.Document.Name, each.Name) for each in (thickness, *thickness.Sources)}
        if names is None or names in own:
            return False
        length = np.linalg.norm(direction)
        return (wall["point"] - point) @ direction / length > 1e-3 * thickness.Diagonal

    def _met(self, thickness, near, direction):
        parts = parts_of(thickness)
        version = map_version(thickness)
        if self._searches is None or self._searches[0] != version:
            self._searches = version, [MapSearch(part.map) for part in parts]
        moved = moved_matrix(thickness)
        best = None
        for number, (part, search) in enumerate(zip(parts, self._searches[1])):
            for place, matrix in enumerate(part.places):
                back = np.linalg.inv(moved @ matrix)
                facet, distance = search.first_met(
                    back[:3, :3] @ near + back[:3, 3], back[:3, :3] @ direction)
                if facet >= 0 and (best is None or distance < best[0]):
                    best = distance, number, place, facet
        if best is None:
            return None
        distance, number, place, facet = best
        part = parts[number]
        point = near + distance * direction
        back = np.linalg.inv(moved)
        value, opposite = wall_at_place(part, place, facet, back[:3, :3] @ point + back[:3, 3])
        return {
            "part": number, "place": place, "face": int(part.map.face[facet]), "thickness": value,
            "point": point,
            "opposite": None if opposite is None else moved[:3, :3] @ opposite + moved[:3, 3],
        }


def _text(value, unit):
    return translate("ThinPart", "not measured") if value is None else unit.text(value)


def _label(widget):
    label = QtWidgets.QLabel(widget)
    label.setObjectName("ThinPart_Hover")
    label.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
    label.setStyleSheet(
        "QLabel { background: white; color: #1a1a1a; border: 1px solid #808080; padding: 2px 5px; }")
    label.hide()
    return label


def _exists(label):
    """Whether Qt has not deleted a widget that Python still knows."""
    try:
        label.objectName()
    except RuntimeError:
        return False
    return True


def _beside(place, size, room):
    """Right below the cursor, or on its other side where there is no room."""
    x, y = place.x() + 16, place.y() + 18
    if x + size.width() > room.width():
        x = place.x() - 8 - size.width()
    if y + size.height() > room.height():
        y = place.y() - 8 - size.height()
    return QtCore.QPoint(x, y)


_SELECTION_FIELDS = ("selectionMode", "highlightMode", "preselectionMode")


def _rest(view):
    """Switch selection in a view off, and return what it was: the fields that this FreeCAD has."""
    root, kept = view.getSceneGraph(), {}
    for name in _SELECTION_FIELDS:
        field = root.getField(name)
        if field is not None:
            kept[name] = field.get()
            root.set(f"{name} OFF")
    return kept


def _resume(view, kept):
    for name, text in kept.items():
        view.getSceneGraph().set(f"{name} {text}")
