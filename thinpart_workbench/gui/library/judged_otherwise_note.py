# SPDX-License-Identifier: LGPL-2.1-or-later
"""Says once that other versions of a shipped profile have judged info files of the libraries."""

from ...freecad_adapter.preferences import preference_list, set_preference_list
from ..application.qt import QtWidgets, Signal, grouped, translate
from ..record.record_view import text_line
from ..widgets.buttons import add_button, small_button
from ..widgets.flow_layout import add_flow

_PREFERENCE = "ProfileVersionsTold"


class JudgedOtherwiseNote(QtWidgets.QWidget):
    """A line with the number of these files, a button that leads to judging them again, and one that hides the line.

    It is hidden where there are none. Either button ends it for these libraries until the profile changes again; of several
    profiles it shows one after the other.

    Signals
    -------
    reclassify_requested(str)
        The user wants to judge them again: name of the profile.
    """

    reclassify_requested = Signal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._libraries, self._profile = [], None
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._text = text_line(self, column, "ThinPart_JudgedOtherwise")
        row = add_flow(column, self)
        add_button(row, self, "ThinPart_JudgedOtherwiseReclassify", translate("ThinPart", "Reclassify\u2026"),
                   self._request_reclassify)
        row.addWidget(small_button(self, "ThinPart_JudgedOtherwiseHide", "\u2715", translate(
            "ThinPart", "Do not say this again"), self._end))
        self.hide()

    def show_libraries(self, libraries):
        """Show what is to be said of libraries: list of dict, as `OpenLibraries.states`."""
        self._libraries = [library for library in libraries if not library["busy"]]
        told, files = preference_list(_PREFERENCE), {}
        for library in self._libraries:
            for found in library["judged_otherwise"]:
                if _key(library, found) not in told:
                    files[found["profile"]] = files.get(found["profile"], 0) + found["files"]
        self._profile = max(files, key=files.get, default=None)
        if self._profile is not None:
            self._text.setText(translate(
                "ThinPart", "{} info files were judged by another version of the profile {}.").format(
                grouped(files[self._profile]), self._profile))
        self.setVisible(self._profile is not None)

    def _request_reclassify(self):
        profile = self._profile
        self._end()
        self.reclassify_requested.emit(profile)

    def _end(self):
        roots = preference_list("Libraries")
        told = [key for key in preference_list(_PREFERENCE) if key.split(" ", 2)[-1] in roots]
        keys = [_key(library, found) for library in self._libraries for found in library["judged_otherwise"]
                if found["profile"] == self._profile]
        set_preference_list(_PREFERENCE, list(dict.fromkeys([*told, *keys])))
        self.show_libraries(self._libraries)


def _key(library, found):
    """What is kept once it was said: the profile, its version of today and the library."""
    return f"{found['profile']} {found['version']} {library['root']}"
