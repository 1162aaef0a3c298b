# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of the profile editor with the limits of the wall by process: the shipped ones and the user's own."""

import copy
import re

from ...api.window.limits import shipped_processes
from ...core.errors import ThinPartError
from ...storage.user_limits import user_limits, user_limits_file, write_user_limits
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtWidgets, Signal, translate
from ..application.sentences import translated
from ..guide.command import lead_to_guide
from ..guide.pages import LIMITS
from ..record.record_view import show_text, show_warning, text_line
from ..widgets.buttons import add_button
from ..widgets.flow_layout import add_flow
from .edited_profile import free_name
from .limits_form import LimitsForm

_ID = re.compile(r"[A-Za-z0-9_\-]{1,40}")


class LimitsPage(QtWidgets.QWidget):
    """Edits limits; what differs from the shipped ones is written to the user's own file.

    Signals
    -------
    changed
        What would be saved has changed, or was saved.
    """

    changed = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self._processes, self._own, self._is_readable = [], set(), True
        self._shipped = {process["id"].casefold(): process for process in shipped_processes()}
        lead_to_guide(self, LIMITS)
        column = QtWidgets.QVBoxLayout(self)
        row = QtWidgets.QHBoxLayout()
        self._tree = self._new_tree()
        row.addWidget(self._tree, 3)
        side = QtWidgets.QVBoxLayout()
        self._form = LimitsForm(self)
        self._form.changed.connect(self._on_edited)
        side.addWidget(self._form)
        self._problem = text_line(self, side, "ThinPart_LimitsProblem")
        side.addStretch(1)
        row.addLayout(side, 2)
        column.addLayout(row, 1)
        self._add_buttons(add_flow(column, self))
        self._message = text_line(self, column, "ThinPart_LimitsMessage")
        self.load()

    @property
    def is_changed(self):
        """Whether something would be lost without saving."""
        return self._own_processes() != self._saved

    def load(self):
        """Show the limits that are known now."""
        try:
            own, sentence, self._is_readable = user_limits(), "", True
        except ThinPartError as error:
            own, sentence, self._is_readable = [], translated(error), False
        self._own = {process["id"].casefold() for process in own}
        shipped = [process for name, process in self._shipped.items() if name not in self._own]
        self._processes = copy.deepcopy([*shipped, *own])
        self._saved = self._own_processes()
        show_text(self._message, sentence or translate(
            "ThinPart", "What you change is saved as your own limits in {}.").format(user_limits_file()))
        self._fill()

    def save(self):
        """Write the user's own limits; returns whether that was done."""
        found = self._first_problem()
        if found is not None:
            self._fill(found[0])
            return False
        try:
            file = write_user_limits(self._own_processes())
        except ThinPartError as error:
            show_text(self._message, translated(error))
            return False
        self._saved = self._own_processes()
        show_text(self._message, translate(
            "ThinPart", "Saved in {}. Wherever you choose processes, these limits hold from now on.").format(file))
        self._show_state()
        self.changed.emit()
        return True

    def add_process(self):
        """Add a process of one's own."""
        name = free_name("own_{}", {process["id"].casefold() for process in self._processes})
        self._processes.append({"id": name, "title": translate("ThinPart", "New process"), "min_mm": 1.0, "max_mm": None})
        self._own.add(name.casefold())
        self._on_added((len(self._processes) - 1, None))

    def add_material(self):
        """Add a material to the selected process."""
        number, _ = self._place()
        process = self._made_own(number)
        materials = process.setdefault("materials", [])
        materials.append({
            "id": free_name("own_{}", {each["id"].casefold() for each in materials}), "title": translate(
                "ThinPart", "New material"), "min_mm": process["min_mm"], "max_mm": process["max_mm"]})
        self._on_added((number, len(materials) - 1))

    def remove(self):
        """Remove the selected material or process; a shipped process gets its shipped limits again."""
        number, material = self._place()
        process = self._processes[number]
        if material is not None:
            self._made_own(number)
            del process["materials"][material]
        else:
            self._own.discard(process["id"].casefold())
            shipped = self._shipped.get(process["id"].casefold())
            if shipped is None:
                del self._processes[number]
            else:
                self._processes[number] = copy.deepcopy(shipped)
        self._fill((min(number, len(self._processes) - 1), None))
        self.changed.emit()

    def _add_buttons(self, flow):
        def add(name, text, callback):
            return add_button(flow, self, f"ThinPart_Limits{name}", text, callback, is_for_enter=False)

        self._add_process = add("AddProcess", translate("ThinPart", "Add a process"), self.add_process)
        self._add_material = add("AddMaterial", translate("ThinPart", "Add a material"), self.add_material)
        self._remove = add("Remove", translate("ThinPart", "Remove"), self.remove)
        self._reset = add("Reset", translate("ThinPart", "Reset to saved"), self.load)
        self._save = add("Save", translate("ThinPart", "Save the limits"), self.save)

    def _new_tree(self):
        tree = QtWidgets.QTreeWidget(self)
        tree.setObjectName("ThinPart_LimitsTree")
        unit = length_unit().symbol
        tree.setHeaderLabels([
            translate("ThinPart", "Process and material"), translate("ThinPart", "At least, {}").format(unit),
            translate("ThinPart", "At most, {}").format(unit)])
        tree.setAlternatingRowColors(True)
        header = tree.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        header.setSectionResizeMode(0, QtWidgets.QHeaderView.Stretch)
        tree.currentItemChanged.connect(lambda *_: self._on_selected())
        return tree

    def _fill(self, place=None):
        """Show all rows, and select that of a place: (process, material or None)."""
        place = place or self._place() or (0, None)
        expanded = {self._tree.topLevelItem(row).data(0, QtCore.Qt.UserRole)[0] for row in range(
            self._tree.topLevelItemCount()) if self._tree.topLevelItem(row).isExpanded()}
        self._tree.blockSignals(True)
        self._tree.clear()
        for number, process in enumerate(self._processes):
            item = QtWidgets.QTreeWidgetItem(self._tree)
            self._show_row(item, (number, None))
            for index, _ in enumerate(process.get("materials", ())):
                self._show_row(QtWidgets.QTreeWidgetItem(item), (number, index))
            item.setExpanded(number in expanded or (number == place[0] and place[1] is not None))
        item = self._item(place)
        self._tree.setCurrentItem(item)
        self._tree.blockSignals(False)
        self._tree.scrollToItem(item)
        self._on_selected()

    def _show_row(self, item, place):
        row, unit = self._row(place), length_unit()
        title = translated(row["title"])
        is_own = self._processes[place[0]]["id"].casefold() in self._own
        item.setText(0, translate("ThinPart", "{} (own)").format(title) if is_own and place[1] is None else title)
        for column, key in ((1, "min_mm"), (2, "max_mm")):
            item.setText(column, unit.number(row[key]))
            item.setTextAlignment(column, QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        font = item.font(0)
        font.setBold(is_own)
        item.setFont(0, font)
        item.setToolTip(0, row["id"])
        item.setData(0, QtCore.Qt.UserRole, list(place))

    def _item(self, place):
        item = self._tree.topLevelItem(place[0])
        return item if place[1] is None else item.child(place[1])

    def _place(self):
        item = self._tree.currentItem()
        return tuple(item.data(0, QtCore.Qt.UserRole)) if item is not None else None

    def _row(self, place):
        process = self._processes[place[0]]
        return process if place[1] is None else process["materials"][place[1]]

    def _on_selected(self):
        place = self._place()
        if place is not None:
            self._form.show_row(self._row(place))
        self._show_state()

    def _on_edited(self):
        place = self._place()
        number = place[0]
        was = self._processes[number]["id"].casefold()
        process = self._made_own(number)
        row = self._row(place)
        changed = self._form.row()
        row.clear()
        row.update(changed)
        if place[1] is None and process["id"].casefold() != was:
            self._own.discard(was)
            self._own.add(process["id"].casefold())
        self._show_row(self._item(place), place)
        self._show_row(self._item((number, None)), (number, None))
        self._show_state()
        self.changed.emit()

    def _on_added(self, place):
        self._fill(place)
        self._form.focus_title()
        self.changed.emit()

    def _made_own(self, number):
        """The process at a position, from now on among the user's own: dict."""
        process = self._processes[number]
        self._own.add(process["id"].casefold())
        return process

    def _own_processes(self):
        return copy.deepcopy([process for process in self._processes if process["id"].casefold() in self._own])

    def _first_problem(self):
        """Place and sentence of the first row that cannot be used; None if there is none."""
        for number, process in enumerate(self._processes):
            rows = [(None, process), *enumerate(process.get("materials", ()))]
            for material, row in rows:
                others = [each["id"].casefold() for each in (
                    self._processes if material is None else process["materials"]) if each is not row]
                sentence = _problem(row, others)
                if sentence:
                    return (number, material), sentence
        return None

    def _show_state(self):
        place, found = self._place(), self._first_problem()
        is_own = place is not None and self._processes[place[0]]["id"].casefold() in self._own
        is_shipped = place is not None and self._processes[place[0]]["id"].casefold() in self._shipped
        sentence = found[1] if found is not None else ""
        if found is not None and found[0] != place:
            sentence = f"{translated(self._row(found[0])['title'])}: {sentence}"
        show_warning(self._problem, sentence)
        self._remove.setText(translate("ThinPart", "Back to the shipped limits") if is_own and is_shipped
                             and place[1] is None else translate("ThinPart", "Remove"))
        self._remove.setEnabled(self._is_readable and place is not None and (is_own or place[1] is not None))
        self._form.setEnabled(self._is_readable and place is not None)
        for button in (self._add_process, self._add_material):
            button.setEnabled(self._is_readable)
        self._save.setEnabled(self._is_readable and self.is_changed and found is None)
        self._reset.setEnabled(self.is_changed)


def _problem(row, others):
    """What is wrong with a row, given the short names beside it in lower case: str."""
    if not _ID.fullmatch(row["id"]):
        return translate("ThinPart", "The short name consists of 1 to 40 letters, digits, - and _.")
    if row["id"].casefold() in others:
        return translate("ThinPart", "The short name {} is there twice.").format(row["id"])
    if row["min_mm"] is None and row["max_mm"] is None:
        return translate("ThinPart", "There has to be a least or a greatest wall.")
    if None not in (row["min_mm"], row["max_mm"]) and row["min_mm"] >= row["max_mm"]:
        return translate("ThinPart", "The least wall has to be thinner than the greatest.")
    return ""
