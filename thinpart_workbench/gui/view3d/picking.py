# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows the thickness under the cursor and pins probes on click."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from ...api.document_maps import map_version, parts_of
from ...core.errors import ThinPartError
from ...core.maps.map_search import MapSearch
from ...core.rigid_transform import inverse, transform_directions, transform_points
from ...freecad_adapter.guard import guarded_methods
from ...freecad_adapter.objects.thickness_probes import Probe, moved_matrix, probes_of, set_probes, wall_at_placement
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtWidgets, Signal, call_later, mouse_position, translate
from ..colour_bar.bar_handle import is_on_bar
from ..document.transaction import transaction
from ..record.measure_text import here_sentence
from ..scene.coin_nodes import put_into, take_out_of
from ..scene.document_views import views_of
from ..scene.view_ray import first_object, line_of_sight
from .probe_nodes import ProbeNodes

_CLICK_DISTANCE = 3
"""Maximum distance in pixels between press and release of a click; anything longer is a drag."""


def add_probe(thickness, point, opposite, value):
    """Pin a probe, in mm, its ends array_like of shape (3,) in current document coordinates; can be undone."""
    ends = map(tuple, transform_points(inverse(moved_matrix(thickness)), (point, opposite)))
    _set(thickness, [*probes_of(thickness), Probe(*ends, float(value))],
         translate("ThinPart", "Pin thickness"))


def remove_probe(thickness, number):
    """Remove a probe by its number, from 0; can be undone."""
    probes = probes_of(thickness)
    del probes[number]
    _set(thickness, probes, translate("ThinPart", "Remove thickness"))


def probe_ends(thickness, number):
    """Current positions of both ends of a probe: two ndarray of shape (3,), mm."""
    matrix, probe = moved_matrix(thickness), probes_of(thickness)[number]
    return tuple(transform_points(matrix, (probe.point, probe.opposite)))


def _set(thickness, probes, name):
    with transaction(thickness.Document, name):
        set_probes(thickness, probes)


@guarded_methods(eventFilter=False)
class ThicknessPicker(QtCore.QObject):
    """Tracks the mouse over the 3D views of one thickness map, from `start` to `stop`.

    Signals
    -------
    hovered(object)
        None, or a dict: ``part``, ``face``, ``facet`` and ``placement`` (numbers from 0), ``thickness`` (mm, None
        where unmeasured), ``point`` and ``opposite`` (ndarray of shape (3,), mm, in the document).
    """

    hovered = Signal(object)

    def __init__(self, thickness, parent=None):
        super().__init__(parent)
        self._names = thickness.Document.Name, thickness.Name
        self._views = []  # (view, widget, label, (selection fields, mouse tracking) to restore)
        self._searches = None
        self._pressed = None
        self._position = None
        self._pins = self._is_told = False
        self._root = None  # of the view that has the line
        self._line = ProbeNodes()
        self._timer = QtCore.QTimer(self)  # mouse moves arrive faster than they can be handled
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._hover)

    def start(self, pins=True):
        """Start tracking the mouse; clicks may pin probes, which disables FreeCAD's selection in these views."""
        self.stop()
        self._pins = pins
        for view in views_of(self._names[0]):
            widget = view.graphicsView().viewport()
            widget.installEventFilter(self)
            tracked = widget.hasMouseTracking()
            widget.setMouseTracking(True)
            self._views.append((view, widget, _label(widget), (_disable_selection(view) if pins else {}, tracked)))

    def stop(self):
        """Stop tracking the mouse and restore the views."""
        self._timer.stop()
        views, self._views = self._views, []
        self._tell(None, None)
        self._pressed = self._position = None
        for view, widget, label, (selection, tracked) in views:
            try:
                widget.removeEventFilter(self)
                widget.setMouseTracking(tracked)
                label.hide()
                label.deleteLater()
                _enable_selection(view, selection)
            except (RuntimeError, ReferenceError):
                continue  # the view was closed
        if views:
            self.hovered.emit(None)

    def wall_at(self, view, position):
        """The payload of `hovered` for any position (QPoint) in a view; None beside the map."""
        thickness = self._thickness
        if thickness is None or not thickness.ViewObject.Visibility:
            return None
        try:
            near, direction = line_of_sight(view, position)
            wall = self._first_hit(thickness, near, direction)
        except ThinPartError:
            return None  # the view provider has reported that the map cannot be read
        return None if wall is None or self._is_hidden(view, position, wall, direction) else wall

    def eventFilter(self, widget, event):
        """Observe mouse events and pass them on to the view."""
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove:
            # Not while the part is turned, which is to be smooth.
            self._position = widget, mouse_position(event) if event.buttons() == QtCore.Qt.NoButton else None
            if not self._timer.isActive():
                self._timer.start(15)
        elif kind == QtCore.QEvent.Leave:
            self._position = widget, None
            self._timer.start(0)
        elif kind == QtCore.QEvent.MouseButtonPress:
            # A second button held down turns or moves the view in most navigation styles.
            alone = self._pins and event.button() == event.buttons() == QtCore.Qt.LeftButton
            plain = event.modifiers() == QtCore.Qt.NoModifier
            self._pressed = mouse_position(event) if alone and plain and not is_on_bar(
                widget, mouse_position(event)) else None
        elif kind == QtCore.QEvent.MouseButtonRelease and self._pressed is not None:
            if event.button() == QtCore.Qt.LeftButton and (
                    (mouse_position(event) - self._pressed).manhattanLength() <= _CLICK_DISTANCE):
                # After the view has handled the event.
                position = mouse_position(event)
                call_later(self, lambda: self._pin(widget, position))
            self._pressed = None
        return False

    @property
    def _thickness(self):
        document, name = self._names
        if document not in App.listDocuments():
            return None
        return App.getDocument(document).getObject(name)

    def _view_of(self, widget):
        return next((entry for entry in self._views if entry[1] is widget or entry[1] == widget), None)

    def _hover(self):
        if self._position is None:
            return
        widget, position = self._position
        entry = self._view_of(widget)
        if entry is None:
            return
        view, _, label, _ = entry
        if not _exists(label):
            return  # the view was closed since the mouse was moved over it
        wall = None if position is None or is_on_bar(widget, position) else self.wall_at(view, position)
        if wall is None:
            label.hide()
        else:
            label.setText(_text(wall["thickness"], length_unit(self._thickness.Document)))
            label.adjustSize()
            label.move(_beside(position, label.size(), widget.size()))
            label.show()
        self._tell(view, wall)
        self.hovered.emit(wall)

    def _tell(self, view, wall):
        """Show a wall as a line through it, and in the status bar; None for no wall."""
        has_value = wall is not None and wall["thickness"] is not None
        root = view.getSceneGraph() if has_value else None
        if self._root is not None and self._root is not root:
            take_out_of(self._root, self._line.root)
        if root is not None:
            self._line.show([Probe(tuple(wall["point"]), tuple(wall["opposite"]), wall["thickness"])])
            put_into(root, self._line.root)
        self._root = root
        bar = Gui.getMainWindow().statusBar()
        if has_value:
            unit = length_unit(self._thickness.Document)
            bar.showMessage(here_sentence(self._thickness.Measure, unit.text(wall["thickness"])))
        elif self._is_told:
            bar.clearMessage()
        self._is_told = has_value

    def _pin(self, widget, position):
        entry = self._view_of(widget)
        wall = None if entry is None else self.wall_at(entry[0], position)
        if wall is None or wall["thickness"] is None:
            return
        add_probe(self._thickness, wall["point"], wall["opposite"], wall["thickness"])

    def _is_hidden(self, view, position, wall, direction):
        """Whether another object, other than the map's sources, hides the map."""
        names, point = first_object(view, position)
        thickness = self._thickness
        own = {(member.Document.Name, member.Name) for member in (thickness, *thickness.Sources)}
        if names is None or names in own:
            return False
        length = np.linalg.norm(direction)
        return (wall["point"] - point) @ direction / length > 1e-3 * thickness.Diagonal

    def _first_hit(self, thickness, near, direction):
        parts = parts_of(thickness)
        version = map_version(thickness)
        if self._searches is None or self._searches[0] != version:
            self._searches = version, [MapSearch(part.map) for part in parts]
        moved = moved_matrix(thickness)
        plane, direction = thickness.ViewObject.Proxy.section, np.asarray(direction)
        if plane is not None:
            entry = plane.entry(near, direction)
            if np.isinf(entry):
                return None
            near = near + entry * direction
        best = None
        for number, (part, search) in enumerate(zip(parts, self._searches[1])):
            for placement, matrix in enumerate(part.matrices):
                back = inverse(moved @ matrix)
                facet, distance = search.first_hit(transform_points(back, near), transform_directions(back, direction))
                if facet >= 0 and (best is None or distance < best[0]):
                    best = distance, number, placement, facet
        if best is None:
            return None
        distance, number, placement, facet = best
        part = parts[number]
        point = near + distance * direction
        outward = transform_directions(moved @ part.matrices[placement], part.map.normal(facet))
        if plane is not None and outward @ direction > 0.0 and plane.heights(near) > -1e-6 * thickness.Diagonal:
            return None  # the material in the cut, which lies before that wall
        value, opposite = wall_at_placement(part, placement, facet, transform_points(inverse(moved), point))
        return {
            "part": number, "placement": placement, "face": int(part.map.face[facet]), "facet": int(facet),
            "thickness": value, "point": point,
            "opposite": None if opposite is None else transform_points(moved, opposite),
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
    """Whether the underlying Qt widget still exists."""
    try:
        label.objectName()
    except RuntimeError:
        return False
    return True


def _beside(position, size, room):
    """QPoint below and right of the cursor, or on the other side where there is no room."""
    x, y = position.x() + 16, position.y() + 18
    if x + size.width() > room.width():
        x = position.x() - 8 - size.width()
    if y + size.height() > room.height():
        y = position.y() - 8 - size.height()
    return QtCore.QPoint(x, y)


_SELECTION_FIELDS = ("selectionMode", "highlightMode", "preselectionMode")


def _disable_selection(view):
    """Disable selection in a view; return the previous values of the fields that this FreeCAD version has."""
    root, fields = view.getSceneGraph(), {}
    for name in _SELECTION_FIELDS:
        field = root.getField(name)
        if field is not None:
            fields[name] = field.get()
            root.set(f"{name} OFF")
    return fields


def _enable_selection(view, fields):
    for name, text in fields.items():
        view.getSceneGraph().set(f"{name} {text}")
