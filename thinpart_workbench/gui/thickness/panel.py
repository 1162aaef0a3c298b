# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task boxes of one thickness map in FreeCAD's task view."""

from ...api.window.profiles import profile_for_titles
from ...core.errors import ThinPartError
from ..application.icons import icon
from ..application.qt import QtCore, QtWidgets, call_later, translate
from ..application.sentences import translated
from ..document.task_dialog import TaskDialog, task_box_of
from ..section.section_box import SectionBox
from .distribution_box import DistributionBox
from .face_box import FaceBox
from .presenter import ThicknessPresenter
from .probe_box import ProbeBox
from .region_box import RegionBox
from .scale_box import ScaleBox
from .summary_box import SummaryBox


class ThicknessPanel(QtCore.QObject):
    """The boxes. While there is no map, all but the head are hidden, and created one by one.

    Attributes
    ----------
    panel : TaskDialog
    head : SummaryBox
    distribution : DistributionBox or None
    scale : ScaleBox or None
    regions : RegionBox or None
    section : SectionBox or None
    faces : FaceBox or None
    probes : ProbeBox or None
        None until created, at the latest with the first map.
    """

    def __init__(self, parent=None):
        super().__init__(parent)
        self.head = SummaryBox()
        self.distribution = self.scale = self.section = self.regions = self.faces = self.probes = None
        self._containers = {
            "regions": (_new_container(translate("ThinPart", "Wall regions")), RegionBox),
            "distribution": (_new_container(translate("ThinPart", "Distribution")), DistributionBox),
            "scale": (_new_container(translate("ThinPart", "Colours")), ScaleBox),
            "section": (_new_container(translate("ThinPart", "Section")), SectionBox),
            "faces": (_new_container(translate("ThinPart", "Faces")), FaceBox),
            "probes": (_new_container(translate("ThinPart", "Probes")), ProbeBox),
        }
        self.head.setWindowIcon(icon("ThinPart_ShowThickness"))
        self.panel = TaskDialog(
            [self.head, *(container for container, _ in self._containers.values())], "ThinPart_ShowThickness")
        self._presenter = None
        self._has_folded = False
        # Creating, filling and showing all boxes at once would block the window too long.
        self._create_timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._create_timer.timeout.connect(self._create_next_box)
        self._show_timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._show_timer.timeout.connect(lambda: self._show_others(True))
        for timer in (self._create_timer, self._show_timer):
            self.panel.closed.connect(timer.stop)

    @property
    def thickness(self):
        """The shown map, or None."""
        return self._presenter and self._presenter.thickness

    def begin(self, takes_keyboard=True):
        """Open the panel without a map; see `TaskDialog.show`."""
        self.panel.show(takes_keyboard)
        self._show_others(False)
        self._create_timer.start()

    def show_map(self, thickness):
        """Show a map, or a message if it cannot be read."""
        self.leave()
        while self._create_next_box():
            pass
        try:
            self._presenter = ThicknessPresenter(thickness, self, profile_for_titles())
        except ThinPartError as error:
            self.head.show_message(translated(error), can_repeat=True)
            return
        self._presenter.removed.connect(self._close)
        self._show_timer.start()

    def read_notes(self):
        """Read again what people say of wall regions, because an info file was written."""
        if self._presenter is not None:
            self._presenter.regions.read_notes()

    def leave(self):
        """Release the map and remove the panel's highlights from the view."""
        if self._presenter is not None:
            presenter, self._presenter = self._presenter, None
            presenter.leave()

    def _create_next_box(self):
        """Create the next missing box; return False if there is none."""
        name = next((name for name in self._containers if getattr(self, name) is None), None)
        if name is None:
            self.panel.prepare()
            return False
        container, kind = self._containers[name]
        box = kind(container)
        container.layout().addWidget(box)
        setattr(self, name, box)
        self._create_timer.start()
        return True

    def _close(self):
        self.leave()
        # Not while FreeCAD is removing the object.
        call_later(self.panel, self.panel.hide)

    def _show_others(self, is_visible):
        for container, _ in self._containers.values():
            task_box_of(container).setVisible(is_visible)
        if is_visible and not self._has_folded:
            self._has_folded = True
            _fold(task_box_of(self._containers["faces"][0]))


def _new_container(title):
    """Empty container with a title, for a box of the task view."""
    container = QtWidgets.QWidget()
    container.setWindowTitle(title)
    container.setWindowIcon(icon("ThinPart_ShowThickness"))
    QtWidgets.QVBoxLayout(container).setContentsMargins(0, 0, 0, 0)
    return container


def _fold(task_box):
    """Fold a task box, as a click on its title does; regions come first, faces are for those who want them."""
    QtCore.QMetaObject.invokeMethod(task_box, "showHide")
