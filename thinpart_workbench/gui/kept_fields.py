"""Fields for what is kept with a part: notes, mesh settings and a link."""

import json

from .qt import QtGui, QtCore, QtWidgets, Signal, translate
from .result_view import show_text, text_line
from .sentences import translated


class KeptFields(QtWidgets.QWidget):
    """Shows what is kept with a part and has it kept when it was changed.

    What was written is not lost where it cannot be kept: it is shown again with its part.

    Signals
    -------
    keep_asked(object, object)
        The part, and a dict of what was changed: ``notes``, ``mesh``, ``link``.
    told(str)
        A sentence about a part that is not shown any more.
    """

    keep_asked = Signal(object, object)
    told = Signal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._part, self._stored = None, {}
        self._unkept = {}
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        column.addWidget(QtWidgets.QLabel(translate("ThinPart", "Notes"), self))
        self._notes = QtWidgets.QPlainTextEdit(self)
        self._notes.setObjectName("ThinPart_KeptNotes")
        self._notes.setTabChangesFocus(True)
        self._notes.setMinimumHeight(3 * self.fontMetrics().height())
        self._notes.textChanged.connect(self._show_state)
        column.addWidget(self._notes, 1)
        grid = QtWidgets.QGridLayout()
        self._mesh = self._line(grid, 0, "ThinPart_KeptMesh", translate("ThinPart", "Mesh settings"),
                                translate("ThinPart", "a file, or a JSON object"))
        self._button(grid, 0, "ThinPart_ChooseMesh", translate("ThinPart", "Choose\u2026"), self._choose)
        self._link = self._line(grid, 1, "ThinPart_KeptLink", translate("ThinPart", "Link"),
                                translate("ThinPart", "an address or a folder"))
        self._open = self._button(
            grid, 1, "ThinPart_OpenLink", translate("ThinPart", "Open"), self._open_link)
        grid.setColumnStretch(1, 1)
        column.addLayout(grid)
        self._message = text_line(self, column, "ThinPart_KeptMessage")
        self._save = QtWidgets.QPushButton(translate("ThinPart", "Save"), self)
        self._save.setObjectName("ThinPart_KeepNotes")
        self._save.clicked.connect(lambda *_: self.save())
        column.addWidget(self._save)
        self.show_part(None)

    @property
    def is_changed(self):
        """Whether something was written that is not kept yet."""
        return bool(self.changes)

    @property
    def changes(self):
        """dict: what differs from what is kept."""
        texts = self._texts()
        return {key: texts[key] for key, value in self._stored.items() if texts[key] != value}

    def show_part(self, part):
        """Turn to another part, whose record follows; what was written for the last one is saved."""
        self.save()
        self._part, self._stored = part, {}
        self._fill({"notes": "", "mesh": "", "link": ""})
        self.setEnabled(False)
        show_text(self._message, "")

    def show_record(self, record):
        """Show what is kept with the part."""
        changes = self.changes
        self._stored = {"notes": record.get("notes") or "", "mesh": _mesh_text(record.get("mesh")),
                        "link": record.get("link") or ""}
        texts, sentence = self._unkept.get(_key(self._part), ({}, ""))
        self._fill({**self._stored, **texts, **changes})
        self.setEnabled(True)
        show_text(self._message, sentence)

    def save(self):
        """Have what was changed kept."""
        changes = self.changes
        if self._part is not None and changes:
            self._unkept[_key(self._part)] = changes, ""
            self.keep_asked.emit(self._part, changes)

    def show_kept(self, kept):
        """Say whether it was kept.

        Parameters
        ----------
        kept : dict
            ``info_file``, ``name`` and ``sentence``, which is empty where it was.
        """
        key, sentence = (kept["info_file"], kept["name"]), translated(kept["sentence"])
        texts, _ = self._unkept.pop(key, ({}, ""))
        if sentence:
            self._unkept[key] = texts, "\u26a0 " + sentence
        if self._part is None or key != _key(self._part):
            self.told.emit(sentence)
            return
        if not sentence:
            self._stored.update(texts)
            self._show_state()
        show_text(self._message, "\u26a0 " + sentence if sentence else translate("ThinPart", "Saved."))

    def edit(self):
        """Put the cursor into the notes."""
        self._notes.setFocus()
        self._notes.moveCursor(QtGui.QTextCursor.End)

    def _texts(self):
        return {"notes": self._notes.toPlainText(), "mesh": self._mesh.text(), "link": self._link.text()}

    def _fill(self, texts):
        self._notes.setPlainText(texts["notes"])
        self._mesh.setText(texts["mesh"])
        self._link.setText(texts["link"])
        self._show_state()

    def _show_state(self, *_):
        self._save.setEnabled(self.is_changed)
        self._open.setEnabled(bool(self._link.text().strip()))
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

    def _button(self, grid, row, name, text, act):
        button = QtWidgets.QPushButton(text, self)
        button.setObjectName(name)
        button.clicked.connect(lambda *_: act())
        grid.addWidget(button, row, 2)
        return button

    def _choose(self):
        file, _ = QtWidgets.QFileDialog.getOpenFileName(
            self, translate("ThinPart", "Choose a file with mesh settings"), self._mesh.text())
        if file:
            self._mesh.setText(file)

    def _open_link(self):
        url = QtCore.QUrl.fromUserInput(self._link.text().strip())
        if not QtGui.QDesktopServices.openUrl(url):
            show_text(self._message, "\u26a0 " + translate(
                "ThinPart", "No program opens {} here.").format(self._link.text()))


def _key(part):
    return part.info_file, part.name


def _mesh_text(mesh):
    if not mesh:
        return ""
    if "file" in mesh:
        return mesh["file"]
    return json.dumps(mesh.get("settings"), ensure_ascii=False)
