# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the edited profile would change in a library, counted while the user types."""

import os

from ...freecad_adapter.preferences import preference_list
from ..application.qt import QtCore, QtWidgets, translate
from ..reclassify.changes_view import ChangesView
from ..widgets.buttons import small_button
from ..widgets.file_dialogs import choose_folder
from ..widgets.narrow_fields import narrow_combo


class ChangesPanel(QtWidgets.QWidget):
    """The choice of a library, and what would change in it, a ChangesView."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self._other_folders, self._behind_modal = [], False
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        label = QtWidgets.QLabel(translate("ThinPart", "What would change in"), self)
        column.addWidget(label)
        self._library = narrow_combo(self, "ThinPart_ProfileLibrary", 16)
        label.setBuddy(self._library)
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self._library, 1)
        row.addWidget(small_button(self, "ThinPart_ProfileReadAgain", "\u21bb", translate(
            "ThinPart", "Read the info files again, which may have changed"), self._on_library_chosen))
        column.addLayout(row)
        self.view = ChangesView("Profile", self)
        column.addWidget(self.view, 1)
        self._fill_libraries()
        self._library.currentIndexChanged.connect(lambda _: self._on_library_chosen())

    def begin(self, behind_modal=False):
        """Count in the libraries that there are now; see `ChangesView.open`."""
        self._behind_modal = behind_modal
        self._fill_libraries()
        self._on_library_chosen()

    def choose_folder(self, folder):
        """Count in a folder that need not be a library."""
        folder = os.path.abspath(folder)
        if folder not in self._other_folders:
            self._other_folders.append(folder)
        self._fill_libraries(folder)
        self._on_library_chosen()

    @property
    def _roots(self):
        return self._library.currentData() or []

    def _fill_libraries(self, chosen=None):
        """List the libraries of the panel that finds parts, and the folders chosen here."""
        libraries = preference_list("Libraries")
        before = [chosen] if chosen else self._roots
        blocked = self._library.blockSignals(True)
        self._library.clear()
        if len(libraries) > 1:
            self._library.addItem(translate("ThinPart", "all {} libraries").format(len(libraries)), libraries)
        for folder in [*libraries, *(each for each in self._other_folders if each not in libraries)]:
            self._library.addItem(folder, [folder])
            self._library.setItemData(self._library.count() - 1, folder, QtCore.Qt.ToolTipRole)
        if not self._library.count():
            self._library.addItem(translate("ThinPart", "no library yet"), [])
        self._library.addItem(translate("ThinPart", "Another folder\u2026"), None)
        places = [place for place in range(self._library.count() - 1) if self._library.itemData(place) == before]
        self._library.setCurrentIndex(places[0] if places else 0)
        self._library.blockSignals(blocked)

    def _on_library_chosen(self):
        if self._library.currentData() is None:
            choose_folder(self, "", self.choose_folder, translate("ThinPart", "Choose a folder with classified parts"))
            if self._library.currentData() is None:
                self._library.setCurrentIndex(0)
            return
        self._library.setToolTip("\n".join(self._roots))
        self.view.open(self._roots, translate(
            "ThinPart", "Choose a folder with classified parts, or add one under 'Libraries' in the panel 'Find parts'."),
            self._behind_modal)
