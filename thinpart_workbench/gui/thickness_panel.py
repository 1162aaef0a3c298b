"""The boxes in FreeCAD's task view that are about one thickness map."""

from pathlib import Path

from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..freecad_adapter.settings import preference
from .distribution_box import DistributionBox
from .face_box import FaceBox
from .probe_box import ProbeBox
from .qt import QtCore, QtGui, QtWidgets, soon, translate
from .scale_box import ScaleBox
from .sentences import translated
from .shown_thickness import ShownThickness
from .task_panel import TaskPanel
from .thickness_head import ThicknessHead

ICON = Path(__file__).resolve().parents[2] / "resources" / "icons" / "ThinPart_ShowThickness.svg"


class ThicknessPanel(QtCore.QObject):
    """The boxes; all but the head are hidden, and made one by one, while there is no map.

    Attributes
    ----------
    panel : TaskPanel
    head : ThicknessHead
    distribution : DistributionBox or None
    scale : ScaleBox or None
    faces : FaceBox or None
    probes : ProbeBox or None
        None until they are made; there with the first map.
    """

    def __init__(self, parent=None):
        super().__init__(parent)
        self.head = ThicknessHead()
        self.distribution = self.scale = self.faces = self.probes = None
        self._places = {
            "distribution": (_place(translate("ThinPart", "Distribution")), DistributionBox),
            "scale": (_place(translate("ThinPart", "Colours")), ScaleBox),
            "faces": (_place(translate("ThinPart", "Faces")), FaceBox),
            "probes": (_place(translate("ThinPart", "Probes")), ProbeBox),
        }
        self.head.setWindowIcon(QtGui.QIcon(str(ICON)))
        self.panel = TaskPanel([self.head, *(place for place, _ in self._places.values())])
        self._shown = None
        # To make, to fill and to show all of them at once takes longer than the window may stand still.
        self._next = QtCore.QTimer(self, singleShot=True, interval=0)
        self._next.timeout.connect(self._make_next)
        self._filled = QtCore.QTimer(self, singleShot=True, interval=0)
        self._filled.timeout.connect(lambda: self._show_others(True))
        for timer in (self._next, self._filled):
            self.panel.closed.connect(timer.stop)

    @property
    def thickness(self):
        """The map that is shown, or None."""
        return self._shown and self._shown.thickness

    def begin(self):
        """Open the panel without a map."""
        self.panel.show()
        self._show_others(False)
        self._next.start()

    def show_map(self, thickness):
        """Show a map, or one sentence where it cannot be read."""
        self.leave()
        while self._make_next():
            pass
        try:
            self._shown = ShownThickness(thickness, self, _profile())
        except ThinPartError as error:
            self.head.show_message(translated(error), can_repeat=True)
            return
        self._shown.removed.connect(self._close)
        self._filled.start()

    def leave(self):
        """Let go of the map; what only belonged to the panel goes from the view."""
        if self._shown is not None:
            shown, self._shown = self._shown, None
            shown.leave()

    def _make_next(self):
        """Make one more box, if it is not there; False where all are."""
        name = next((name for name in self._places if getattr(self, name) is None), None)
        if name is None:
            return False
        place, kind = self._places[name]
        box = kind(place)
        place.layout().addWidget(box)
        setattr(self, name, box)
        self._next.start()
        return True

    def _close(self):
        self.leave()
        # Not within FreeCAD's own removing of the object.
        soon(self.panel, self.panel.hide)

    def _show_others(self, are_there):
        for place, _ in self._places.values():
            _box_around(place).setVisible(are_there)


def _place(title):
    """Where a box will be in the task view, under its title."""
    place = QtWidgets.QWidget()
    place.setWindowTitle(title)
    place.setWindowIcon(QtGui.QIcon(str(ICON)))
    QtWidgets.QVBoxLayout(place).setContentsMargins(0, 0, 0, 0)
    return place


def _profile():
    try:
        return load_profile(preference("Profile"))
    except ThinPartError:
        return load_profile("paper")  # for the words alone: the verdict is in the record


def _box_around(widget):
    """The box with a title in which the task view shows a widget."""
    candidate = widget
    while candidate is not None:
        if candidate.metaObject().className() in ("Gui::TaskView::TaskBox", "QSint::ActionGroup"):
            return candidate
        candidate = candidate.parentWidget()
    return widget
