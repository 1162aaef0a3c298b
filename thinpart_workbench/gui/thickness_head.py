"""What a thickness map comes to: verdict, thinnest wall, and the parts that it shows."""

from .measuring_progress import MeasuringProgress
from .part_list import PartList
from .push_button import add_button
from .qt import QtCore, QtWidgets, Signal, translate
from .result_view import paint_swatch, show_text, swatch, text_line
from .verdict_text import category_colour, category_title, percent


class ThicknessHead(QtWidgets.QWidget):
    """One sentence or progress while there is no map, else what the map comes to.

    Signals
    -------
    cancelled, again_asked, save_asked, fly_asked
        The button of that name was pressed.
    part_chosen(str)
        See `PartList`.
    all_asked
        The parts are to be shown together again.
    """

    cancelled = Signal()
    again_asked = Signal()
    save_asked = Signal()
    fly_asked = Signal()
    part_chosen = Signal(str)
    all_asked = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_ThicknessHead")
        self.setWindowTitle(translate("ThinPart", "Thickness"))
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        self._message = text_line(self, column, "ThinPart_Message")
        self._progress = MeasuringProgress(self)
        self._progress.cancelled.connect(self.cancelled)
        column.addWidget(self._progress)
        self._stale = text_line(self, column, "ThinPart_Stale")
        show_text(self._stale, "")
        self._verdict = QtWidgets.QWidget(self)
        self._verdict.setObjectName("ThinPart_ThicknessVerdict")
        self._add_verdict(QtWidgets.QVBoxLayout(self._verdict))
        column.addWidget(self._verdict)
        self._info = text_line(self, column, "ThinPart_InfoText")
        self._save = add_button(column, self, "ThinPart_SaveButton",
                                translate("ThinPart", "Save and write info file"), self.save_asked.emit)
        self._again = add_button(column, self, "ThinPart_AgainButton",
                                 translate("ThinPart", "&Measure again"), self.again_asked.emit)
        self._verdict.hide()
        self.show_message("")
        self.show_info_file("")

    def show_message(self, sentence, can_repeat=False):
        """Show one sentence; what the map comes to stays if it was shown."""
        show_text(self._message, sentence)
        self._progress.hide()
        self._can_repeat = can_repeat
        self._again.setVisible(can_repeat)

    def show_running(self, label):
        """Show that measuring begins with a part."""
        self.show_message("")
        self.show_info_file("")
        self._progress.begin(label)

    def show_progress(self, fraction, stage):
        """See `MeasuringProgress`."""
        self._progress.show_progress(fraction, stage)

    def show_info_file(self, sentence, can_save=False, tool_tip=""):
        """Say what became of the info file."""
        show_text(self._info, sentence)
        self._info.setToolTip(tool_tip)
        self._save.setVisible(can_save)

    def show_parts(self, rows, profile, shown, unit):
        """Show what a map comes to.

        Parameters
        ----------
        rows : list of PartRow
            All parts of the map, measured.
        profile : Profile
        shown : str or None
            Name of the part that the other boxes are about; None for all.
        unit : LengthUnit
        """
        self.parts.show_parts(rows, profile, unit)
        self.parts.select_part(shown)
        self._all.setVisible(len(rows) > 1)
        self._all.setEnabled(shown is not None)
        told = [row for row in rows if shown in (None, row.name)]
        alone = told[0].record if len(told) == 1 else None
        self._title.setVisible(alone is not None)
        self._swatch.setVisible(alone is not None)
        if alone is not None:
            self._title.setText(category_title(alone["category"], profile))
            paint_swatch(self._swatch, category_colour(alone["category"]))
        show_text(self._label, told[0].label if alone is not None else translate(
            "ThinPart", "{} different parts, {} instances").format(len(rows), sum(row.instances for row in rows)))
        self._show_walls([row.record["descriptors"] for row in told], unit)
        self._verdict.show()

    def show_stale(self, is_stale):
        """Say that the sources of the map have changed, if they have, and offer to measure again."""
        show_text(self._stale, translate(
            "ThinPart", "\u26a0 The part has changed since it was measured.") if is_stale else "")
        self._again.setVisible(is_stale or self._can_repeat)

    def _add_verdict(self, column):
        column.setContentsMargins(0, 0, 0, 0)
        row = QtWidgets.QHBoxLayout()
        self._swatch = swatch(self._verdict, "ThinPart_Swatch", 18)
        row.addWidget(self._swatch, 0, QtCore.Qt.AlignTop)
        words = QtWidgets.QVBoxLayout()
        words.setSpacing(0)
        self._title = text_line(self._verdict, words, "ThinPart_Headline")
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self._label = text_line(self._verdict, words, "ThinPart_PartLabel")
        row.addLayout(words, 1)
        column.addLayout(row)
        self._walls = text_line(self._verdict, column, "ThinPart_Walls")
        self._fly = add_button(column, self._verdict, "ThinPart_FlyButton",
                               translate("ThinPart", "&Fly to thinnest place"), self.fly_asked.emit)
        self._shares = text_line(self._verdict, column, "ThinPart_Shares")
        self.parts = PartList(self._verdict)
        self.parts.part_chosen.connect(self.part_chosen)
        column.addWidget(self.parts)
        self._all = add_button(column, self._verdict, "ThinPart_AllParts",
                               translate("ThinPart", "&All parts together"), self.all_asked.emit)

    def _show_walls(self, measured, unit):
        """Thinnest wall, error bound and unmeasured share of one part, or the worst of several."""
        walls = [(each["thickness_mm"]["min"], each["thickness_mm"]["error_bound"]) for each in measured
                 if each["thickness_mm"]["min"] is not None]
        self._fly.setEnabled(bool(walls))
        if walls:
            thinnest, bound = min(walls)
            text = translate("ThinPart", "Thinnest wall {} (\u00b1\u00a0{})").format(
                unit.text(thinnest), unit.bound_text(bound))
        else:
            text = translate("ThinPart", "No wall could be measured.")
        show_text(self._walls, text)
        area = sum(each["area_mm2"] for each in measured)
        unmeasured = sum(each["shares"]["unmeasured"] * each["area_mm2"] for each in measured)
        show_text(self._shares, translate("ThinPart", "Not measured: {} of the area").format(
            percent(unmeasured / max(area, 1e-300))))
