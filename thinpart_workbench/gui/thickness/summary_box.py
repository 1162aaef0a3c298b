# SPDX-License-Identifier: LGPL-2.1-or-later
"""Summary of a thickness map: verdict, thinnest wall, and its parts."""

from ..application.numbers import percent
from ..application.qt import QtCore, QtWidgets, Signal, blocked, named, translate
from ..record.kept_room import keep_room
from ..record.measure_text import measure_choices
from ..record.measuring_progress import MeasuringProgress
from ..record.parts_table import PartsTable
from ..record.record_view import paint_swatch, show_text, swatch, text_line
from ..record.verdict_text import category_colour, headline_text, thinnest_text
from ..tables.wall_table import step_of
from ..widgets.buttons import add_button
from ..widgets.narrow_fields import narrow_combo

_LINES_OF_PART, _LINES_TOLD = 2, 3
"""Lines of text for which room is kept: of each text of a part where there are several, and of what is said below."""


class SummaryBox(QtWidgets.QWidget):
    """A message or the progress while there is no map, otherwise the summary of the map.

    Attributes
    ----------
    progress : MeasuringProgress

    Signals
    -------
    cancelled, repeat_requested, save_requested, fly_requested
        The corresponding button was pressed.
    step_requested(int)
        The user wants to see the next wall (1) or the previous one (-1).
    part_chosen(str)
        See `PartsTable`.
    all_requested
        The user wants to see all parts together.
    measure_chosen(str)
        One of `SHOWN_MEASURES`.
    export_requested
        The user wants to write the map to a file.
    changes_requested
        The user wants to see what became thinner.
    """

    cancelled = Signal()
    repeat_requested = Signal()
    save_requested = Signal()
    fly_requested = Signal()
    step_requested = Signal(int)
    part_chosen = Signal(str)
    all_requested = Signal()
    measure_chosen = Signal(str)
    export_requested = Signal()
    changes_requested = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_ThicknessHead")
        self.setWindowTitle(translate("ThinPart", "Thickness"))
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        self._verdict = named(QtWidgets.QWidget(self), "ThinPart_ThicknessVerdict")
        self._add_verdict(QtWidgets.QVBoxLayout(self._verdict))
        column.addWidget(self._verdict)
        self._again = add_button(column, self, "ThinPart_AgainButton",
                                 translate("ThinPart", "&Measure again"), self.repeat_requested.emit)
        self._save = add_button(column, self, "ThinPart_SaveButton",
                                translate("ThinPart", "Save and write info file"), self.save_requested.emit)
        self.progress = MeasuringProgress(self)
        self.progress.cancelled.connect(self.cancelled)
        column.addWidget(self.progress)
        self._add_told(column)
        self._verdict.hide()
        self.show_message("")
        self.show_info_file("")

    def show_message(self, sentence, can_repeat=False):
        """Show a message; a summary that is already shown stays visible."""
        show_text(self._message, sentence)
        self.progress.hide()
        self._can_repeat = can_repeat
        self._show_again()

    def show_running(self, label):
        """Show that measuring has started, with the label of the first part."""
        self.show_message("")
        self.show_info_file("")
        self.progress.begin(label)
        self._show_again()

    def show_info_file(self, sentence, can_save=False, tool_tip=""):
        """Show the state of the info file."""
        show_text(self._info, sentence)
        self._info.setToolTip(tool_tip)
        self._save.setVisible(can_save)

    def show_parts(self, rows, profile, shown, unit, file):
        """Show the summary of a map.

        Parameters
        ----------
        rows : list of PartsTableRow
            All parts of the map, with records.
        profile : Profile
        shown : str or None
            Name of the part shown in the other boxes; None for all.
        unit : LengthUnit
        file : str
            Path of their document.
        """
        self.parts.show_parts(rows, profile, unit, file)
        self.parts.select_part(shown)
        self._all.setVisible(len(rows) > 1)
        self._all.setEnabled(shown is not None)
        shown_rows = [row for row in rows if shown in (None, row.name)]
        single = shown_rows[0].record if len(shown_rows) == 1 else None
        self._title.setVisible(single is not None)
        self._swatch.setVisible(single is not None)
        if single is not None:
            self._title.setText(headline_text(single, profile))
            paint_swatch(self._swatch, category_colour(single["category"]))
        show_text(self._label, shown_rows[0].label if single is not None else translate(
            "ThinPart", "{} different parts, {} instances").format(len(rows), sum(row.instances for row in rows)))
        self._show_walls([row.record for row in shown_rows], unit)
        # Another part has another verdict, longer or shorter: the table in which it was chosen stays where it is.
        for text in (self._title, self._walls):
            keep_room(text, _LINES_OF_PART if len(rows) > 1 else 1)
        self._verdict.show()
        self._told.setMinimumHeight(_LINES_TOLD * self.fontMetrics().lineSpacing())
        self._show_again()

    @property
    def measure(self):
        """The chosen one of `SHOWN_MEASURES`."""
        return self._measure.currentData()

    def show_measure(self, measure):
        """Show how the map was measured: one of `SHOWN_MEASURES`."""
        with blocked(self):
            self._measure.setCurrentIndex(max(0, self._measure.findData(measure)))

    def show_stale(self, is_stale):
        """Show or hide the warning that the sources have changed."""
        show_text(self._stale, translate(
            "ThinPart", "\u26a0 The part has changed since it was measured.") if is_stale else "")

    def show_flight(self, sentence):
        """Show what there is to say about the last flight to a wall."""
        show_text(self._flight, sentence)

    def event(self, event):
        """Keep the keys of the next and previous wall from FreeCAD's shortcuts."""
        if event.type() == QtCore.QEvent.ShortcutOverride and step_of(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event):
        """Ask for the next or the previous wall."""
        step = step_of(event)
        if step and self._fly.isEnabled():
            self.step_requested.emit(step)
        else:
            super().keyPressEvent(event)

    def _add_verdict(self, column):
        column.setContentsMargins(0, 0, 0, 0)
        row = QtWidgets.QHBoxLayout()
        self._swatch = swatch(self._verdict, "ThinPart_Swatch", 18)
        row.addWidget(self._swatch, 0, QtCore.Qt.AlignTop)
        titles = QtWidgets.QVBoxLayout()
        titles.setSpacing(0)
        self._title = text_line(self._verdict, titles, "ThinPart_Headline")
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self._label = text_line(self._verdict, titles, "ThinPart_PartLabel")
        row.addLayout(titles, 1)
        column.addLayout(row)
        self._walls = text_line(self._verdict, column, "ThinPart_Walls")
        self._fly = add_button(column, self._verdict, "ThinPart_FlyButton",
                               translate("ThinPart", "&Fly to thinnest wall"), self.fly_requested.emit)
        self._fly.setToolTip(translate("ThinPart", "The camera looks at it from where nothing stands before it. N, P: "
                                       "the next thicker wall, and the previous one"))
        row = QtWidgets.QHBoxLayout()
        self._steps = [
            add_button(row, self._verdict, name, text, lambda step=step: self.step_requested.emit(step))
            for name, text, step in (
                ("ThinPart_PreviousWall", translate("ThinPart", "Previous wall"), -1),
                ("ThinPart_NextWall", translate("ThinPart", "Next wall"), 1))]
        for button, key in zip(self._steps, "PN"):
            button.setToolTip(translate("ThinPart", "Walls are in the order of their thickness. Key: {}").format(key))
        column.addLayout(row)
        self._shares = text_line(self._verdict, column, "ThinPart_Shares")
        self._add_measure(column)
        self.parts = PartsTable(self._verdict)
        self.parts.part_chosen.connect(self.part_chosen)
        column.addWidget(self.parts)
        self._all = add_button(column, self._verdict, "ThinPart_AllParts",
                               translate("ThinPart", "&All parts together"), self.all_requested.emit)

        self._export = add_button(column, self._verdict, "ThinPart_ExportButton",
                                  translate("ThinPart", "E&xport map\u2026"), self.export_requested.emit)
        self._export.setToolTip(translate("ThinPart", "As a picture of any size, or as triangles with their thickness for "
                                          "ParaView, MeshLab and others"))
        self._changes = add_button(column, self._verdict, "ThinPart_ThinnerButton",
                                   translate("ThinPart", "What became thinner\u2026"), self.changes_requested.emit)
        self._changes.setToolTip(translate("ThinPart", "The map of before beside that of now, once the part was changed and "
                                           "measured again"))
        self.show_has_before(False)

    def show_has_before(self, has_before):
        """Show whether there is a map of before the last change."""
        self._changes.setEnabled(has_before)

    def _add_told(self, column):
        """What is said comes and goes: below all that is pressed, where room is kept for it."""
        self._told = QtWidgets.QWidget(self)
        lines = QtWidgets.QVBoxLayout(self._told)
        lines.setContentsMargins(0, 0, 0, 0)
        self._message, self._stale, self._flight, self._export_text, self._info = (
            text_line(self._told, lines, f"ThinPart_{name}")
            for name in ("Message", "Stale", "FlightText", "ExportText", "InfoText"))
        lines.addStretch(1)
        column.addWidget(self._told)
        for label in (self._stale, self._flight, self._export_text):
            show_text(label, "")

    def _show_again(self):
        """Show the button to measure again wherever there is a map or a reason, and enable it when nothing is measured."""
        self._again.setVisible(self._can_repeat or not self._verdict.isHidden())
        self._again.setEnabled(self.progress.isHidden())

    def show_export(self, sentence):
        """Show what became of the last export."""
        show_text(self._export_text, sentence)

    def _add_measure(self, column):
        row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("ThinPart", "&Colours show"), self._verdict)
        row.addWidget(label)
        self._measure = narrow_combo(self._verdict, "ThinPart_Measure")
        label.setBuddy(self._measure)
        for number, (measure, title, meaning) in enumerate(measure_choices()):
            self._measure.addItem(title, measure)
            self._measure.setItemData(number, meaning, QtCore.Qt.ToolTipRole)
        self._measure.currentIndexChanged.connect(lambda _: self.measure_chosen.emit(self.measure))
        self._measure.currentIndexChanged.connect(lambda _: self._show_measure_tip())
        self._show_measure_tip()
        row.addWidget(self._measure, 1)
        column.addLayout(row)

    def _show_measure_tip(self):
        self._measure.setToolTip(self._measure.currentData(QtCore.Qt.ToolTipRole))

    def _show_walls(self, records, unit):
        """Show thinnest wall, error bound and unmeasured share of one part, or the worst of several."""
        measured = [record["descriptors"] for record in records]
        walls = [(descriptors["thickness_mm"]["min"], number)
                 for number, descriptors in enumerate(measured) if descriptors["thickness_mm"]["min"] is not None]
        for button in (self._fly, *self._steps):
            button.setEnabled(bool(walls))
        if walls:
            text = thinnest_text(records[min(walls)[1]], unit)
        else:
            text = translate("ThinPart", "No wall could be measured.")
        show_text(self._walls, text)
        area = sum(descriptors["area_mm2"] for descriptors in measured)
        unmeasured = sum(descriptors["shares"]["unmeasured"] * descriptors["area_mm2"] for descriptors in measured)
        show_text(self._shares, translate("ThinPart", "Not measured: {} of the area").format(
            percent(unmeasured / max(area, 1e-300))))
