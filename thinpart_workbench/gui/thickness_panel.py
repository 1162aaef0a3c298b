"""The boxes in FreeCAD's task view that are about one thickness map."""

from pathlib import Path

from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..freecad_adapter.settings import preference
from .distribution_box import DistributionBox
from .face_box import FaceBox
from .probe_box import ProbeBox
from .qt import QtCore, QtGui
from .scale_box import ScaleBox
from .sentences import translated
from .shown_thickness import ShownThickness
from .task_panel import TaskPanel
from .thickness_head import ThicknessHead

ICON = Path(__file__).resolve().parents[2] / "resources" / "icons" / "ThinPart_ShowThickness.svg"


class ThicknessPanel(QtCore.QObject):
    """The boxes, most of them hidden while there is no map.

    Attributes
    ----------
    panel : TaskPanel
    head : ThicknessHead
    scale : ScaleBox
    distribution : DistributionBox
    faces : FaceBox
    probes : ProbeBox
    """

    def __init__(self, parent=None):
        super().__init__(parent)
        self.head, self.scale, self.distribution = ThicknessHead(), ScaleBox(), DistributionBox()
        self.faces, self.probes = FaceBox(), ProbeBox()
        for box in (self.head, *self._others):
            box.setWindowIcon(QtGui.QIcon(str(ICON)))
        self.panel = TaskPanel([self.head, *self._others])
        self._shown = None

    @property
    def _others(self):
        return [self.distribution, self.scale, self.faces, self.probes]

    @property
    def thickness(self):
        """The map that is shown, or None."""
        return self._shown and self._shown.thickness

    def begin(self):
        """Open the panel without a map."""
        self.panel.show()
        self._show_others(False)

    def show_map(self, thickness):
        """Show a map, or one sentence where it cannot be read."""
        self.leave()
        try:
            self._shown = ShownThickness(thickness, self, _profile())
        except ThinPartError as error:
            self.head.show_message(translated(error), can_repeat=True)
            return
        self._shown.removed.connect(self._close)
        self._show_others(True)

    def leave(self):
        """Let go of the map; what only belonged to the panel goes from the view."""
        if self._shown is not None:
            shown, self._shown = self._shown, None
            shown.leave()

    def _close(self):
        self.leave()
        # Not within FreeCAD's own removing of the object.
        QtCore.QTimer.singleShot(0, self.panel.hide)

    def _show_others(self, are_there):
        for widget in self._others:
            _box_around(widget).setVisible(are_there)


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
