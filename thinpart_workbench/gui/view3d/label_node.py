# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels in one 3D view, drawn over the scene beside what they name; saved pictures show them too."""

import time

import numpy as np
from pivy import coin

from ...core.rendering.label_places import label_places
from ..application.qt import QtCore, QtGui
from ..scene.coin_nodes import add_children, flat_colours, skipped_by_fit_all, take_out_of, unpickable
from ..scene.view_pixels import free_pixels, is_size_of, pixels_drawn, place_on_screen, projected, set_image

_INK, _PLATE, _LINE = (25, 25, 25), (255, 255, 255, 235), (217, 0, 89)
_AROUND = 6
"""Pixels around a label's drawing, for the width of its lines."""

_OUTWARD = -0.05
"""A place whose surface turns away from the eye by more than this cosine is hidden by its own wall."""

_AT_REST = 0.2
"""Seconds without a new picture until it is looked whether other objects hide a place, which takes longer."""


MAP, MARK = "ThinPart_MapLabels", "ThinPart_MarkLabels"
"""Kinds of labels: those of a map, and the mark of the wall that was flown to. Also the dynamic properties of the widget of
a view with the labels that it shows, each as its text, its QRect, and the QPoint that it names, in device pixels."""


def shown_labels(view, kind=MAP):
    """The labels that a view shows in the window: list of (str, QRect, QPoint)."""
    return _shown(view.graphicsView().viewport(), kind)


def _shown(widget, kind):
    return [tuple(label) for label in widget.property(kind) or ()]


class LabelNode:
    """The labels of one kind in one view; "fit all" and picking ignore them.

    Parameters
    ----------
    view : View3DInventorPy
    kind : str
        `MAP` or `MARK`.

    Attributes
    ----------
    obstacles : list
        What labels are not to cover, each with a ``rect``: QRect in pixels of the picture being drawn.

    Notes
    -----
    Labels are images of their own at places computed while the view is drawn: text of Coin has no place beside what it
    names, and would be cut off at the edge of the view.
    """

    def __init__(self, view, kind=MAP):
        self._kind, self._index = kind, _index(view.getSceneGraph())
        self._root, self.obstacles = view.getSceneGraph(), []
        self._widget = view.graphicsView().viewport()
        self._content, self._drawn_for, self._chosen, self._images = None, None, {}, []
        self._covered_by_others, self._drawn_at, self._is_waiting, self._is_removed = {}, 0.0, False, False
        self.node, self._annotation = skipped_by_fit_all(), coin.SoAnnotation()
        self._annotation.renderCaching = coin.SoSeparator.OFF
        prepare = coin.SoCallback()
        self._prepare = self._draw  # pivy does not hold a reference to it
        prepare.setCallback(self._prepare)
        self._labels = coin.SoGroup()
        add_children(self._annotation, unpickable(), prepare, flat_colours(), self._labels)
        self.node.addChild(self._annotation)
        self._root.insertChild(self.node, self._index)  # before FreeCAD's clipping plane, which cuts all that follows

    def is_in(self, root):
        """Whether the labels belong to the view with this scene graph."""
        return root.findChild(self.node) >= 0

    def show(self, content):
        """Show a LabelContent."""
        if self._content is not None and content.key == self._content.key:
            return
        self._content, self._drawn_for = content, None
        self._chosen = {label.text: self._chosen.get(label.text, -1) for label in content.labels}
        while len(self._images) < len(content.labels):
            self._images.append(_Image())
        self._labels.removeAllChildren()
        for image in self._images[:len(content.labels)]:
            self._labels.addChild(image.switch)
        self.node.touch()

    def remove(self):
        """Take the labels out of the view."""
        self._is_removed = True
        take_out_of(self._root, self.node)
        try:
            self._widget.setProperty(self._kind, None)
        except RuntimeError:
            return  # the view was closed

    def _draw(self, _data, action):
        size = pixels_drawn(action) if self._content is not None else None
        if size is None:
            return
        volume = coin.SoViewVolumeElement.get(action.getState())
        free = free_pixels(self._widget, *size)
        marks = _shown(self._widget, MARK) if self._kind == MAP else []
        obstacles = [*(each.rect for each in self.obstacles), *(rect for _, rect, _ in marks)]
        drawn_for = (size, tuple(map(tuple, volume.getMatrix().getValue())), free.getRect(),
                     [rect.getRect() for rect in obstacles], self._root.getNodeId())
        if drawn_for == self._drawn_for:
            return
        self._drawn_for = drawn_for
        labels = self._content.labels
        seen = self._seen_ends(volume, size)
        em = max(11, round(min(free.height(), 1.2 * free.width()) / 52))
        seen = {number: place for number, place in seen.items() if not self._is_marked(number, marks, volume, size, em)}
        shown = sorted(seen)
        font = QtGui.QFont(QtGui.QGuiApplication.font().family())
        font.setPixelSize(em)
        plates = [_Plate(labels[number], font) for number in shown]
        found = []
        if shown:
            points = np.array([labels[number].ends[seen[number]] for number in shown])
            anchors = projected(volume, points, *size)
            area = free.left() + 4, free.top() + 4, free.left() + free.width() - 4, free.top() + free.height() - 4
            crowd = projected(volume, self._content.crowd, *size)
            corners, chosen = label_places(
                anchors, [plate.size for plate in plates], area,
                [(each.left(), each.top(), each.right() + 1, each.bottom() + 1) for each in obstacles],
                crowd[np.isfinite(crowd).all(axis=1)], [self._chosen.get(labels[number].text, -1) for number in shown])
            for row, number in enumerate(shown):
                self._chosen[labels[number].text] = int(chosen[row])
                line = projected(volume, labels[number].ends[seen[number][0]], *size) if labels[number].has_line else None
                self._images[number].draw(volume, size, plates[row], anchors[row], corners[row], line, em)
                found.append([labels[number].text, QtCore.QRect(*(round(float(value)) for value in (
                    *corners[row], *plates[row].size))), QtCore.QPoint(*(round(float(value)) for value in anchors[row]))])
        for number in range(len(labels)):
            self._images[number].switch_on(number in seen)
        if is_size_of(self._widget, *size):
            self._widget.setProperty(self._kind, found)

    def _is_marked(self, number, marks, volume, size, em):
        """Whether the mark of a flight names one of the places of a label, and says the same."""
        label = self._content.labels[number]
        if label.has_line or not marks:
            return False
        here = projected(volume, label.ends.reshape(-1, 3), *size)
        return any(label.text.endswith(text) and np.linalg.norm(here - (spot.x(), spot.y()), axis=1).min() < 2 * em
                   for text, _, spot in marks)

    def _seen_ends(self, volume, size):
        """The end that is named, by the number of the label: dict of (occurrence, end); hidden labels are left out."""
        labels, content = self._content.labels, self._content
        rows = [(number, place, end) for number, label in enumerate(labels)
                for place in range(len(label.ends)) for end in ((0, 1) if label.has_two_ends else (0,))]
        if not rows:
            return {}
        points = np.array([labels[number].ends[place, end] for number, place, end in rows])
        outward = points - np.array([labels[number].ends[place, 1 - end] for number, place, end in rows])
        outward /= np.maximum(np.linalg.norm(outward, axis=1), 1e-12)[:, None]
        directions, limits = _to_eye(volume, points)
        pixels = projected(volume, points, *size)
        inside = ((pixels >= 0.0) & (pixels <= np.array(size, dtype=float))).all(axis=1)
        kept, limits = self._cut(points, directions, limits)
        seen = inside & kept & (np.einsum("ij,ij->i", outward, directions) >= _OUTWARD)
        if content.covers is not None and seen.any():
            seen[seen] = ~content.covers(points[seen], directions[seen], limits[seen])
        found = {}
        for row in np.flatnonzero(seen):
            found.setdefault(rows[row][0], rows[row][1:])
        for row in np.flatnonzero(inside):
            if labels[rows[row][0]].is_always_shown:
                found.setdefault(rows[row][0], rows[row][1:])
        return self._without_covered(found, volume)

    def _cut(self, points, directions, limits):
        """Which points planes leave, and how far lines of sight go before a plane cuts off what could hide them."""
        kept = np.ones(len(points), dtype=bool)
        planes = [] if self._content.section is None else [
            (np.array(self._content.section.normal), float(self._content.section.offset))]
        for plane in _clipping_planes(self._root):
            planes.append(plane)
        for normal, offset in planes:  # what lies above is cut off
            height = points @ normal - offset
            slope = directions @ normal
            kept &= height <= 1e-6 * (1.0 + abs(offset))
            with np.errstate(divide="ignore", invalid="ignore"):
                limits = np.where(slope > 1e-9, np.minimum(limits, np.maximum(-height / slope, 0.0)), limits)
        return kept, limits

    def _without_covered(self, found, volume):
        """Leave out what other objects hide; while the camera moves, as it was at rest."""
        content, now = self._content, time.monotonic()
        is_moving, self._drawn_at = now - self._drawn_at < _AT_REST, now
        labels = content.labels
        if not content.has_others:
            return found
        if is_moving:
            self._wait()
        else:
            self._covered_by_others = {
                labels[number].text: self._is_covered(labels[number].ends[place], volume)
                for number, place in found.items()}
        return {number: place for number, place in found.items() if labels[number].is_always_shown
                or not self._covered_by_others.get(labels[number].text, False)}

    def _is_covered(self, point, volume):
        direction, limit = (part[0] for part in _to_eye(volume, point[None]))
        if not np.isfinite(limit):
            limit = 2.0 * np.linalg.norm(point - np.array(volume.getProjectionPoint().getValue())) + 1.0
        picking = coin.SoRayPickAction(coin.SbViewportRegion(100, 100))
        picking.setRay(coin.SbVec3f(*map(float, point + limit * direction)), coin.SbVec3f(*map(float, -direction)))
        picking.apply(self._root)
        picked = picking.getPickedPoint()
        if picked is None:
            return False
        hit = np.array(picked.getPoint().getValue(), dtype=float)
        return (hit - point) @ direction > self._content.tolerance

    def _wait(self):
        if not self._is_waiting:
            self._is_waiting = True
            QtCore.QTimer.singleShot(round(1000 * _AT_REST) + 50, self._look_again)

    def _look_again(self):
        self._is_waiting, self._drawn_for = False, None
        if self._is_removed:
            return  # the scene has freed the node
        try:
            self._widget.property(self._kind)
        except RuntimeError:
            return  # the view was closed meanwhile, and its scene has nobody to tell
        self.node.touch()


def _index(root):
    """Where labels are inserted: behind the colour bar, which they have to keep clear of, and before all that is cut off."""
    kind = coin.SoType.fromName("SoSkipBoundingGroup")
    number = 0
    while number < root.getNumChildren() and root.getChild(number).isOfType(kind):
        number += 1
    return number


def _to_eye(volume, points):
    """Unit vectors from points towards the eye, and how far it is: ndarray of shape (k, 3) and (k,), mm."""
    if volume.getProjectionType() == coin.SbViewVolume.ORTHOGRAPHIC:
        look = np.array(volume.getProjectionDirection().getValue(), dtype=float)
        return np.tile(-look / np.linalg.norm(look), (len(points), 1)), np.full(len(points), np.inf)
    away = np.array(volume.getProjectionPoint().getValue(), dtype=float) - points
    lengths = np.linalg.norm(away, axis=1)
    return away / np.maximum(lengths, 1e-12)[:, None], lengths


def _clipping_planes(root):
    """FreeCAD's clipping planes of a view, as (normal, offset) with what is cut off above."""
    kind = coin.SoClipPlane.getClassTypeId()
    for number in range(root.getNumChildren()):
        node = root.getChild(number)
        if node.isOfType(kind) and node.getField("on").getValue():
            plane = node.getField("plane").getValue()
            yield -np.array(plane.getNormal().getValue(), dtype=float), -float(plane.getDistanceFromOrigin())


class _Plate:
    """How a label looks.

    Attributes
    ----------
    size : (int, int), pixels
    """

    def __init__(self, label, font):
        self._label, self._font = label, font
        self._metrics = metrics = QtGui.QFontMetrics(font)
        self._em = font.pixelSize()
        self._swatch = 0 if label.rgb is None else round(0.9 * self._em)
        width = metrics.boundingRect(label.text).width() + self._em
        self.size = width + (self._swatch and self._swatch + round(0.4 * self._em)), round(1.6 * self._em)

    def draw(self, painter, left, top):
        width, height = self.size
        painter.setPen(QtGui.QPen(QtGui.QColor(*_INK), 1.0))
        painter.setBrush(QtGui.QColor(*_PLATE))
        plate, round_by = QtCore.QRectF(left + 0.5, top + 0.5, width - 1, height - 1), 0.25 * self._em
        painter.drawRoundedRect(plate, round_by, round_by)
        text_left = left + 0.5 * self._em
        if self._swatch:
            painter.setBrush(QtGui.QColor(*self._label.rgb))
            painter.drawRect(QtCore.QRectF(text_left, top + 0.5 * (height - self._swatch), self._swatch, self._swatch))
            text_left += self._swatch + round(0.4 * self._em)
        painter.setFont(self._font)
        painter.drawText(QtCore.QPointF(text_left, top + 0.5 * (height + self._metrics.capHeight())), self._label.text)


class _Image:
    """The nodes of one label: its plate, its leader, and the line through the wall."""

    def __init__(self):
        self.switch, self._translation, self._image = coin.SoSwitch(), coin.SoTranslation(), coin.SoImage()
        separator = coin.SoSeparator()
        separator.renderCaching = coin.SoSeparator.OFF
        self._image.vertAlignment, self._image.horAlignment = coin.SoImage.BOTTOM, coin.SoImage.LEFT
        # Coin finds out whether an image is transparent when it is told of a change.
        self._image.image.setValue(coin.SbVec2s(1, 1), 4, bytes(4))
        add_children(separator, self._translation, self._image)
        self.switch.addChild(separator)
        for node in (self.switch, self._translation, self._image):
            node.enableNotify(False)  # set during rendering, which must not trigger another rendering

    def switch_on(self, is_on):
        self.switch.whichChild = coin.SO_SWITCH_ALL if is_on else coin.SO_SWITCH_NONE

    def draw(self, volume, size, plate, anchor, corner, line, em):
        points = np.array([anchor, corner, corner + np.array(plate.size), *([] if line is None else line)])
        low = np.maximum(np.floor(points.min(axis=0)) - _AROUND, 0.0).astype(int)
        high = np.minimum(np.ceil(points.max(axis=0)) + _AROUND, size).astype(int)
        width, height = (max(int(length), 1) for length in high - low)
        image = QtGui.QImage(width, height, QtGui.QImage.Format_RGBA8888)
        image.fill(QtCore.Qt.transparent)
        painter = QtGui.QPainter(image)
        try:
            painter.setRenderHint(QtGui.QPainter.Antialiasing)
            painter.translate(-float(low[0]), -float(low[1]))
            if line is not None:
                _draw_line(painter, line[0], line[1], _LINE, em)
                for end in line:
                    _draw_dot(painter, end, _LINE, em)
            beside = np.clip(anchor, corner, corner + np.array(plate.size))
            _draw_line(painter, anchor, beside, _INK, em)
            _draw_dot(painter, anchor, _INK if line is None else _LINE, em)
            plate.draw(painter, round(float(corner[0])), round(float(corner[1])))
        finally:
            painter.end()
        set_image(self._image, image)
        self._translation.translation = place_on_screen(
            volume, low[0] + 0.5, size[1] - (low[1] + height) + 0.5, *size)


def _draw_line(painter, start, end, rgb, em):
    start, end = (QtCore.QPointF(float(x), float(y)) for x, y in (start, end))
    for colour, width in ((QtGui.QColor(255, 255, 255, 220), 0.27 * em), (QtGui.QColor(*rgb), 0.11 * em)):
        painter.setPen(QtGui.QPen(colour, width, QtCore.Qt.SolidLine, QtCore.Qt.RoundCap))
        painter.drawLine(start, end)


def _draw_dot(painter, place, rgb, em):
    painter.setPen(QtGui.QPen(QtGui.QColor(255, 255, 255), 0.11 * em))
    painter.setBrush(QtGui.QColor(*rgb))
    painter.drawEllipse(QtCore.QPointF(float(place[0]), float(place[1])), 0.27 * em, 0.27 * em)
