# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits the annotation of a part: notes, mesh settings and a link."""

import json

from ...api.annotations import link_address
from ...core.errors import ThinPartError
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, translate
from ..application.sentences import translated
from ..application.thread_work import check_path_in_thread
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button
from ..widgets.confirmation import is_confirmed
from .mesh_settings import MeshSettings, settings_text


class NotesPage(QtWidgets.QWidget):
    """Shows the annotation of a part and requests saving when it was changed.

    If saving fails, the changes are not lost: they reappear when the part is shown again.

    Signals
    -------
    save_requested(object, object)
        The part, and a dict of the changed fields: ``notes``, ``mesh``, ``link``.
    message(str)
        Save result of a part that is no longer shown.
    """

    save_requested = Signal(object, object)
    message = Signal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._part, self._stored = None, {}
        self._unsaved = {}
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        column.addWidget(QtWidgets.QLabel(translate("ThinPart", "Notes"), self))
        self._notes = QtWidgets.QPlainTextEdit(self)
        self._notes.setObjectName("ThinPart_KeptNotes")
        self._notes.setTabChangesFocus(True)
        self._notes.setMinimumHeight(3 * self.fontMetrics().height())
        self._notes.textChanged.connect(self._show_state)
        column.addWidget(self._notes, 1)
        label = QtWidgets.QLabel(translate("ThinPart", "Mesh settings"), self)
        column.addWidget(label)
        self._settings = MeshSettings(self)
        self._settings.edited.connect(self._show_state)
        label.setBuddy(self._settings)
        column.addWidget(self._settings)
        grid = QtWidgets.QGridLayout()
        self._mesh = self._line(grid, 0, "ThinPart_KeptMesh", translate("ThinPart", "Mesh file"),
                                translate("ThinPart", "a file with mesh settings"))
        add_button(grid, self, "ThinPart_ChooseMesh", translate("ThinPart", "Choose\u2026"), self._choose, 0, 2)
        self._link = self._line(grid, 1, "ThinPart_KeptLink", translate("ThinPart", "Link"),
                                translate("ThinPart", "an address or a folder"))
        self._open = add_button(grid, self, "ThinPart_OpenLink", translate("ThinPart", "Open"), self._open_link, 1, 2)
        grid.setColumnStretch(1, 1)
        column.addLayout(grid)
        self._save = add_button(column, self, "ThinPart_KeepNotes", translate("ThinPart", "Save"), self.save)
        self._message = text_line(self, column, "ThinPart_KeptMessage")
        self.show_part(None)

    @property
    def is_changed(self):
        """Whether there are unsaved changes."""
        return bool(self.changes)

    @property
    def changes(self):
        """dict: fields that differ from the stored annotation."""
        texts = self._texts()
        return {key: texts[key] for key, value in self._stored.items() if texts[key] != value}

    def show_part(self, part):
        """Save changes and show another part, whose record arrives later."""
        self.save()
        self._part, self._stored = part, {}
        self._fill({"notes": "", "mesh": "", "link": ""})
        self.setEnabled(False)
        show_text(self._message, "")

    def show_record(self, record):
        """Show the annotation of a record."""
        changes = self.changes
        self._stored = {"notes": record.get("notes") or "", "mesh": _mesh_text(record.get("mesh")),
                        "link": record.get("link") or ""}
        texts, sentence = self._unsaved.get(_key(self._part), ({}, ""))
        self._fill({**self._stored, **texts, **changes})
        self.setEnabled(True)
        show_text(self._message, sentence)

    def save(self):
        """Request to save the changes."""
        changes = self.changes
        if self._part is not None and changes:
            self._unsaved[_key(self._part)] = changes, ""
            self.save_requested.emit(self._part, changes)

    def show_save_result(self, result):
        """Show whether saving succeeded.

        Parameters
        ----------
        result : dict
            ``info_file``, ``name`` and ``sentence``, which is empty on success.
        """
        key, sentence = (result["info_file"], result["name"]), translated(result["sentence"])
        texts, _ = self._unsaved.pop(key, ({}, ""))
        if sentence:
            self._unsaved[key] = texts, "\u26a0 " + sentence
        if self._part is None or key != _key(self._part):
            self.message.emit(sentence)
            return
        if not sentence:
            self._stored.update(texts)
            self._show_state()
        show_text(self._message, "\u26a0 " + sentence if sentence else translate("ThinPart", "Saved."))

    def show_unit(self):
        """Show lengths in the current unit."""
        self._settings.show_unit()

    def edit(self):
        """Put the cursor at the end of the notes."""
        self._notes.setFocus()
        self._notes.moveCursor(QtGui.QTextCursor.End)

    def _texts(self):
        return {"notes": self._notes.toPlainText(), "mesh": self._mesh.text() or settings_text(self._settings.settings()),
                "link": self._link.text()}

    def _fill(self, texts):
        self._notes.setPlainText(texts["notes"])
        settings = _settings_in(texts["mesh"])
        self._mesh.setText("" if settings else texts["mesh"])
        self._settings.show_settings(settings)
        self._link.setText(texts["link"])
        self._show_state()

    def _show_state(self, *_):
        self._save.setEnabled(self.is_changed)
        self._open.setEnabled(bool(self._link.text().strip()))
        self._settings.setEnabled(not self._mesh.text())  # those are in the file
        if self.is_changed:
            show_text(self._message, "")

    def _line(self, grid, row, name, title, hint):
        label = QtWidgets.QLabel(title, self)
        field = QtWidgets.QLineEdit(self)
        field.setObjectName(name)
        field.setPlaceholderText(hint)
        field.textChanged.connect(self._show_state)
        label.setBuddy(field)
        grid.addWidget(label, row, 0)
        grid.addWidget(field, row, 1)
        return field

    def _choose(self):
        file, _ = QtWidgets.QFileDialog.getOpenFileName(
            self, translate("ThinPart", "Choose a file with mesh settings"), self._mesh.text())
        if file:
            self._mesh.setText(file)

    def _open_link(self):
        """Resolve the link, ask the user, and open it: another person may have written it."""
        part, text = self._part, self._link.text()
        check_path_in_thread(lambda: _resolve(text, part), lambda resolved: self._ask_to_open(text, resolved), self)

    def _ask_to_open(self, text, resolved):
        if text != self._link.text():
            return  # another part is shown meanwhile
        address, sentence = resolved or (None, translate("ThinPart", "{} cannot be reached.").format(text))
        if address is None:
            show_text(self._message, "\u26a0 " + sentence)
            return
        url = QtCore.QUrl(address) if "://" in address else QtCore.QUrl.fromLocalFile(address)
        # Shown percent-encoded, because some characters look alike.
        shown = bytes(url.toEncoded()).decode() if "://" in address else address
        if is_confirmed(self, "ThinPart_OpenLinkQuestion", QtWidgets.QMessageBox.Question, shown,
                        translate("ThinPart", "This link is stored with the part. Open it outside FreeCAD?"),
                        QtWidgets.QMessageBox.Open) and not QtGui.QDesktopServices.openUrl(url):
            show_text(self._message, "\u26a0 " + translate(
                "ThinPart", "No program was found that opens {}.").format(shown))


def _resolve(text, part):
    """Return (address, ""), or (None, reason why the link cannot be opened)."""
    try:
        return link_address(text, part.root, part.info_file), ""
    except ThinPartError as error:
        return None, translated(error)


def _key(part):
    return part.info_file, part.name


def _mesh_text(mesh):
    if not mesh:
        return ""
    if "file" in mesh:
        return mesh["file"]
    return settings_text(mesh.get("settings"))


def _settings_in(text):
    """The settings of a text of `_mesh_text`, empty for the name of a file."""
    try:
        settings = json.loads(text)
    except ValueError:
        return {}
    return settings if isinstance(settings, dict) else {}
