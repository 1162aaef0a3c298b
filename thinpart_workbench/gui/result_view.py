"""The widget that shows one part record."""

from .criteria_table import CriteriaTable
from .distribution_chart import DistributionChart
from .length_unit import MILLIMETRE
from .qt import QtCore, QtWidgets, colour, translate
from .sentences import translated
from .thin_faces import legend
from .verdict_text import (
    category_colour, category_title, how_sure, number, percent, why,
)


class ResultView(QtWidgets.QWidget):
    """Verdict, evidence, dimensions, walls, distribution, warnings."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self._unit = MILLIMETRE
        self.setObjectName("ThinPart_ResultView")
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._add_headline(column)
        self._why = text_line(self, column, "ThinPart_Why")
        self._how_sure = text_line(self, column, "ThinPart_HowSure")
        self._legend = QtWidgets.QWidget(self)
        self._legend.setObjectName("ThinPart_Legend")
        column.addWidget(self._legend)
        self._fill_legend()
        self._own_limit = text_line(self, column, "ThinPart_OwnLimit")
        self._box = text_line(self, column, "ThinPart_Box")
        self._walls = text_line(self, column, "ThinPart_Walls")
        self._chart = DistributionChart(self)
        column.addWidget(self._chart)
        self._shares = text_line(self, column, "ThinPart_Shares")
        self._table = CriteriaTable(self)
        column.addWidget(self._table)
        self._warnings = text_line(self, column, "ThinPart_Warnings")

    def show_record(self, record, profile, unit):
        """Show a part.

        Parameters
        ----------
        record : dict
            Part record.
        profile : Profile
            By which it was judged.
        unit : LengthUnit
        """
        self._unit = unit
        self._headline.setText(category_title(record["category"], profile))
        paint_swatch(self._swatch, category_colour(record["category"]))
        self._part.setText(record["label"])
        show_text(self._why, why(record))
        show_text(self._how_sure, how_sure(record, profile))
        measured = record["descriptors"]
        show_text(self._box, _box(measured, unit))
        show_text(self._walls, _walls(measured["thickness_mm"], unit))
        shares = measured["shares"]
        show_text(self._shares, translate(
            "ThinPart", "Measured: {} parallel, {} tapered, {} nothing opposite"
        ).format(percent(shares["parallel"]), percent(shares["nonparallel"]),
                 percent(shares["unmeasured"])))
        self._chart.show_distribution(
            measured["distribution"]["bins"], measured["distribution"]["area"],
            record["thin_limit_mm"] / measured["diagonal_mm"], measured["diagonal_mm"], unit)
        self._table.show_evidence(record["evidence"])
        show_text(self._warnings, "\n".join(
            "\u26a0 " + unit.of_sentence(translated(each)) for each in record["warnings"]))

    def show_legend(self, shown, own_limit=None):
        """Say what the colours on the part mean, where it has some.

        Parameters
        ----------
        shown : bool
        own_limit : float, optional, mm
            Where walls are shown as thin under another limit than the verdict's.
        """
        self._legend.setVisible(shown)
        show_text(self._own_limit, "" if own_limit is None else translate(
            "ThinPart", "Shown as thin: below {}, as the preferences say. The verdict does not "
            "depend on it.").format(self._unit.text(own_limit)))

    def _add_headline(self, column):
        row = QtWidgets.QHBoxLayout()
        self._swatch = swatch(self, "ThinPart_Swatch", 22)
        row.addWidget(self._swatch, 0, QtCore.Qt.AlignTop)
        words = QtWidgets.QVBoxLayout()
        words.setSpacing(0)
        self._headline = text_line(self, words, "ThinPart_Headline")
        font = self._headline.font()
        font.setPointSizeF(font.pointSizeF() * 1.3)
        font.setBold(True)
        self._headline.setFont(font)
        self._part = text_line(self, words, "ThinPart_PartLabel")
        row.addLayout(words, 1)
        column.addLayout(row)

    def _fill_legend(self):
        rows = QtWidgets.QVBoxLayout(self._legend)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(2)
        for number_, (rgb, meaning) in enumerate(legend()):
            row = QtWidgets.QHBoxLayout()
            square = swatch(self._legend, f"ThinPart_LegendSwatch{number_}", 12)
            paint_swatch(square, rgb)
            row.addWidget(square, 0, QtCore.Qt.AlignVCenter)
            label = QtWidgets.QLabel(meaning, self._legend)
            label.setObjectName(f"ThinPart_LegendText{number_}")
            row.addWidget(label, 1)
            rows.addLayout(row)


def text_line(parent, layout, name):
    """A label that wraps, can be copied from, and takes no room while it is empty."""
    label = QtWidgets.QLabel(parent)
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setTextFormat(QtCore.Qt.PlainText)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    # A long word must not widen the panel beyond FreeCAD's.
    label.setMinimumWidth(1)
    layout.addWidget(label)
    return label


def show_text(label, text):
    """Set a label's text; hide it where there is none."""
    label.setText(text)
    label.setVisible(bool(text))


def swatch(parent, name, size):
    """A small square for a colour."""
    square = QtWidgets.QFrame(parent)
    square.setObjectName(name)
    square.setFixedSize(size, size)
    square.setFrameShape(QtWidgets.QFrame.Box)
    square.setAutoFillBackground(True)
    return square


def paint_swatch(square, rgb):
    """Give a swatch its colour."""
    # A style sheet, since FreeCAD's own themes would overrule a palette.
    square.setStyleSheet(
        f"QFrame {{ background-color: {colour(rgb).name()}; border: 1px solid #444; }}")


def _box(measured, unit):
    sides = " \u00d7 ".join(map(unit.number, measured["box_mm"]))
    text = translate("ThinPart", "Bounding box {}").format(unit.with_symbol(sides))
    if measured["volume_ratio"] is None:
        return text + translate("ThinPart", "\nIts volume is unknown.")
    return text + translate("ThinPart", "\nFilled to {} (V/VBB = {})").format(
        percent(measured["volume_ratio"]), number(measured["volume_ratio"]))


def _walls(thickness, unit):
    if thickness["min"] is None:
        return translate("ThinPart", "No wall could be measured.")
    return translate(
        "ThinPart", "Wall thickness: min {}, median {}, max {} (\u00b1\u00a0{})"
    ).format(unit.number(thickness["min"]), unit.number(thickness["median"]), unit.text(thickness["max"]),
             unit.bound_text(thickness["error_bound"]))
