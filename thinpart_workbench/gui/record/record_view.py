# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widget that shows one part record."""

from ...api.window.verdicts import thinnest_kind
from ...core.length_unit import MILLIMETRE
from ...freecad_adapter.preferences import preference
from ..application.numbers import number, percent
from ..application.qt import QtCore, QtWidgets, Signal, colour, translate
from ..application.sentences import translated
from .criteria_tree import CriteriaTree
from .distribution_chart import DistributionChart
from .fold import Fold
from .kept_room import keep_room
from .label_button import LabelButton, labels_sentence, own_label
from .regions_table import RegionsTable
from .verdict_text import (
    category_colour,
    confidence_text,
    headline_text,
    marked_thinnest,
    paper_text,
    reason_text,
    risk_text,
    thinnest_text,
)
from .wall_checks import checks_text


class RecordView(QtWidgets.QWidget):
    """Shows verdict, evidence, dimensions, walls, wall regions, thickness distribution and warnings.

    Attributes
    ----------
    file : str
        Path of the shown part's document, for files of its walls.

    Signals
    -------
    faces_chosen(object)
        The user has chosen a wall region: tuple of its face numbers, from 0.
    labelled(str, bool)
        See `LabelButton.label_chosen`.
    visited(object)
        The user wants to see where a region is thinnest: see `RegionsTable`.
    """

    faces_chosen = Signal(object)
    labelled = Signal(str, bool)
    visited = Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._unit, self._profile, self.file = MILLIMETRE, None, ""
        self.setObjectName("ThinPart_ResultView")
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._add_headline(column)
        self._why = text_line(self, column, "ThinPart_Why")
        self._confidence = text_line(self, column, "ThinPart_HowSure")
        self._paper = text_line(self, column, "ThinPart_PaperVerdict")
        self._risk = text_line(self, column, "ThinPart_MeshRisk")
        self._checks = text_line(self, column, "ThinPart_Checks")
        self._legend = QtWidgets.QWidget(self)
        self._legend.setObjectName("ThinPart_Legend")
        column.addWidget(self._legend)
        self._fill_legend()
        self._own_limit = text_line(self, column, "ThinPart_OwnLimit")
        self._box = text_line(self, column, "ThinPart_Box")
        self._walls = text_line(self, column, "ThinPart_Walls")
        self._thinnest = text_line(self, column, "ThinPart_Thinnest")
        self._regions = RegionsTable(self)
        self._regions.faces_chosen.connect(self.faces_chosen)
        self._regions.visited.connect(self.visited)
        column.addWidget(self._regions)
        self._other_regions = text_line(self, column, "ThinPart_OtherRegions")
        self._flight = text_line(self, column, "ThinPart_FlightText")
        keep_room(self._flight, 2)
        self.show_flight("")
        self._chart = DistributionChart(self)
        column.addWidget(self._chart)
        self._shares = text_line(self, column, "ThinPart_Shares")
        self._table = CriteriaTree(self)
        column.addWidget(Fold(translate("ThinPart", "Criteria and their quantities"), "ThinPart_CriteriaFold",
                              self._table, self))
        self._labels = text_line(self, column, "ThinPart_Labels")
        self._label_message = text_line(self, column, "ThinPart_LabelMessage")
        self._warnings = text_line(self, column, "ThinPart_Warnings")

    def show_record(self, record, profile, unit):
        """Show the record of a part that was judged by a profile, in a LengthUnit."""
        self._unit, self._profile = unit, profile
        self.show_labels(record.get("labels", ()))
        self._headline.setText(headline_text(record, profile))
        paint_swatch(self._swatch, category_colour(record["category"]))
        self._part.setText(record["label"])
        show_text(self._why, reason_text(record, unit))
        show_text(self._confidence, confidence_text(record, profile))
        show_text(self._paper, paper_text(record, profile, unit))
        show_text(self._risk, risk_text(record, unit))
        show_text(self._checks, checks_text(record, unit))
        measured = record["descriptors"]
        show_text(self._box, _box(measured, unit))
        show_text(self._walls, _walls(record, unit))
        show_text(self._thinnest, thinnest_text(record, unit))
        self._regions.show_regions(record, unit, file=self.file)
        show_text(self._other_regions, other_regions_text(record))
        self.show_flight("")
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
            "\u26a0 " + translated(warning, unit) for warning in record["warnings"]))

    def show_labels(self, labels, sentence=""):
        """Show what people say of the part, and a sentence about what the user just said."""
        self._label.show_labels(labels, self._profile)
        others = [label for label in labels if label != own_label(labels)]
        show_text(self._labels, others and translate("ThinPart", "Labels: {}").format(
            labels_sentence(others, self._profile)) or "")
        show_text(self._label_message, sentence)

    def show_flight(self, sentence):
        """Show what there is to say about the last flight to a wall."""
        show_text(self._flight, sentence)

    def show_legend(self, shown, own_limit_mm=None):
        """Show or hide the legend of the face colours, and the preferred thin limit, mm, where the verdict has another."""
        self._legend.setVisible(shown)
        show_text(self._own_limit, "" if own_limit_mm is None else translate(
            "ThinPart", "Shown as thin: below {}, as the preferences say. The verdict does not "
            "depend on it.").format(self._unit.text(own_limit_mm)))

    def _add_headline(self, column):
        row = QtWidgets.QHBoxLayout()
        self._swatch = swatch(self, "ThinPart_Swatch", 22)
        row.addWidget(self._swatch, 0, QtCore.Qt.AlignTop)
        texts = QtWidgets.QVBoxLayout()
        texts.setSpacing(0)
        self._headline = text_line(self, texts, "ThinPart_Headline")
        font = self._headline.font()
        font.setPointSizeF(font.pointSizeF() * 1.3)
        font.setBold(True)
        self._headline.setFont(font)
        self._part = text_line(self, texts, "ThinPart_PartLabel")
        row.addLayout(texts, 1)
        self._label = LabelButton(self)
        self._label.label_chosen.connect(self.labelled)
        row.addWidget(self._label, 0, QtCore.Qt.AlignTop)
        column.addLayout(row)

    def _fill_legend(self):
        rows = QtWidgets.QVBoxLayout(self._legend)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(2)
        for index, (rgb, meaning) in enumerate(_legend()):
            row = QtWidgets.QHBoxLayout()
            square = swatch(self._legend, f"ThinPart_LegendSwatch{index}", 12)
            paint_swatch(square, rgb)
            row.addWidget(square, 0, QtCore.Qt.AlignVCenter)
            label = QtWidgets.QLabel(meaning, self._legend)
            label.setObjectName(f"ThinPart_LegendText{index}")
            row.addWidget(label, 1)
            rows.addLayout(row)


def text_line(parent, layout, name):
    """Add a QLabel with word wrap and selectable text to a layout, and return it."""
    label = QtWidgets.QLabel(parent)
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setTextFormat(QtCore.Qt.PlainText)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    # A long word must not widen FreeCAD's task panel.
    label.setMinimumWidth(1)
    layout.addWidget(label)
    return label


def show_text(label, text):
    """Set a label's text, and hide the label where it is empty."""
    label.setText(text)
    label.setVisible(bool(text))


def show_warning(label, sentence):
    """Show in a label what is wrong; hide the label where the sentence is empty."""
    show_text(label, "\u26a0 " + sentence if sentence else "")


def swatch(parent, name, size):
    """A small square frame; see `paint_swatch`."""
    square = QtWidgets.QFrame(parent)
    square.setObjectName(name)
    square.setFixedSize(size, size)
    square.setFrameShape(QtWidgets.QFrame.Box)
    square.setAutoFillBackground(True)
    return square


def paint_swatch(square, rgb):
    """Give a swatch its colour."""
    # A style sheet, because FreeCAD's themes would override a palette.
    square.setStyleSheet(
        f"QFrame {{ background-color: {colour(rgb).name()}; border: 1px solid #444; }}")


def _legend():
    """list of (colour, meaning) of thin faces, the most important first."""
    return [
        (preference("ThinColour"), translate("ThinPart", "thin on half of the face or more")),
        (preference("PartlyThinColour"), translate("ThinPart", "thin in places")),
    ]


def _box(measured, unit):
    sides = " \u00d7 ".join(map(unit.number, measured["box_mm"]))
    text = translate("ThinPart", "Bounding box {}").format(unit.with_symbol(sides))
    if measured["volume_ratio"] is None:
        return text + translate("ThinPart", "\nIts volume is unknown.")
    return text + translate("ThinPart", "\nFilled to {} (V/VBB = {})").format(
        percent(measured["volume_ratio"]), number(measured["volume_ratio"]))


def other_regions_text(record):
    """How many smaller regions a part record leaves out; empty for none."""
    regions = record.get("regions")
    if not regions or not regions["others"]:
        return ""
    share = percent(regions["others_share"])
    if regions["others"] == 1:
        return translate("ThinPart", "and a smaller wall, {} of the surface").format(share)
    return translate("ThinPart", "and {} smaller walls, {} of the surface").format(regions["others"], share)


def _walls(record, unit):
    thickness = record["descriptors"]["thickness_mm"]
    if thickness["min"] is None:
        return translate("ThinPart", "No wall could be measured.")
    least = marked_thinnest(unit.number(thickness["min"]), thinnest_kind(record))
    return translate("ThinPart", "Wall thickness: min {}, median {}, max {} (\u00b1\u00a0{})").format(
        least, unit.number(thickness["median"]), unit.text(thickness["max"]), unit.bound_text(thickness["error_bound"]))
