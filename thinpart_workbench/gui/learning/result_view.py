# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows how good a learned profile is, what it changes, and what people disagree about."""

from ...core.judging.criteria import profile_from
from ..application.numbers import marked
from ..application.qt import QtCore, QtWidgets, grouped, translate
from ..record.record_view import show_text, text_line
from ..record.verdict_text import category_colour, category_word
from ..tables.column import Column, square
from ..tables.small_table import SmallTable

_LINES = 12
"""Rows of a table before it scrolls."""


class LearnedView(QtWidgets.QWidget):
    """A summary, and tabs with the agreement, the thresholds and the disagreement of people."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self._profile = None
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._summary = text_line(self, column, "ThinPart_LearnSummary")
        font = self._summary.font()
        font.setBold(True)
        self._summary.setFont(font)
        self._tabs = QtWidgets.QTabWidget(self)
        self._tabs.setObjectName("ThinPart_LearnTabs")
        self._add_agreement()
        self._add_thresholds()
        self._add_people()
        column.addWidget(self._tabs, 1)

    def show_learned(self, learned):
        """Show what was learned: a dict of the attributes of a `LearnedProfile`."""
        self._profile = profile_from(learned["content"])
        self._summary.setText(_summary(learned))
        show_text(self._figures, _figures_text(learned))
        self._scores.show_rows([(learned["start"], learned["before"]), (translate("ThinPart", "learned"), learned["after"])])
        for caption, table, name, scores in (
                (self._before_caption, self._before, learned["start"], learned["before"]),
                (self._after_caption, self._after, translate("ThinPart", "the learned profile"), learned["after"])):
            caption.setText(translate("ThinPart", "Labels (rows) and verdicts of {} (columns)").format(name))
            table.show_rows(list(scores["confusion"].items()),
                            self._confusion_columns(list(next(iter(scores["confusion"].values())))))
        self._changes.show_rows(learned["changes"])
        self._show_people(learned)

    def _add_agreement(self):
        page, column = self._page(translate("ThinPart", "Agreement"))
        self._figures = text_line(page, column, "ThinPart_LearnFigures")
        self._scores = self._table(page, column, "ThinPart_LearnScores", (
            _column(translate("ThinPart", "Profile"), lambda row: row[0], stretches=True),
            _column(translate("ThinPart", "Sure labels"), lambda row: share_text(row[1]["sure"])),
            _column(translate("ThinPart", "All labels, either answer"), lambda row: share_text(row[1]["either"])),
            _column(translate("ThinPart", "Error of probabilities"), lambda row: _error_text(row[1])),
        ))
        self._before_caption = text_line(page, column, "ThinPart_LearnBeforeCaption")
        self._before = self._table(page, column, "ThinPart_LearnBefore", self._confusion_columns([]))
        self._after_caption = text_line(page, column, "ThinPart_LearnAfterCaption")
        self._after = self._table(page, column, "ThinPart_LearnAfter", self._confusion_columns([]))
        column.addStretch(1)

    def _add_thresholds(self):
        page, column = self._page(translate("ThinPart", "Thresholds"))
        self._changes = self._table(page, column, "ThinPart_LearnChanges", (
            _column(translate("ThinPart", "Category"), lambda row: category_word(row["category"], self._profile),
                    picture=lambda row: square(category_colour(row["category"]))),
            _column(translate("ThinPart", "Criterion"), lambda row: row["criterion"]),
            _column(translate("ThinPart", "Start"), lambda row: row["before"]),
            _column(translate("ThinPart", "Learned"), _learned_text, stretches=True),
        ))
        column.addStretch(1)

    def _add_people(self):
        page, column = self._page(translate("ThinPart", "People"))
        self._people = text_line(page, column, "ThinPart_LearnPeople")
        self._different = self._table(page, column, "ThinPart_LearnDifferent", (
            _column(translate("ThinPart", "File"), lambda row: row["file"], stretches=True),
            _column(translate("ThinPart", "Part"), lambda row: row["part"]),
            _column(translate("ThinPart", "Answers"), self._answers_text),
        ))
        column.addStretch(1)

    def _show_people(self, learned):
        counts = ", ".join(f"{category_word(category, self._profile)} {grouped(count)}"
                           for category, count in learned["counts"].items())
        lines = [translate("ThinPart", "{} labelled parts: {}; by {}.").format(
            grouped(sum(learned["counts"].values())), counts, ", ".join(learned["people"]))]
        pairs = learned["disagreement"]["pairs"]
        if pairs["total"]:
            lines.append(translate("ThinPart", "Two answers to the same part differ in {}.").format(share_text(pairs)))
        self._people.setText("\n".join(lines))
        different = learned["disagreement"]["parts"]
        self._different.show_rows(different)
        self._different.setVisible(bool(different))

    def _answers_text(self, row):
        return ", ".join(translate("ThinPart", "{}: {}").format(person, category_word(category, self._profile))
                         for person, category in row["answers"].items())

    def _confusion_columns(self, verdicts):
        return (
            _column(translate("ThinPart", "Label"), lambda row: category_word(row[0], self._profile),
                    picture=lambda row: square(category_colour(row[0]))),
            *(_column(category_word(verdict, self._profile), lambda row, verdict=verdict: _count_text(row, verdict), True)
              for verdict in verdicts),
        )

    def _page(self, title):
        page = QtWidgets.QWidget(self)
        column = QtWidgets.QVBoxLayout(page)
        area = QtWidgets.QScrollArea(self)
        area.setWidget(page)
        area.setWidgetResizable(True)
        area.setFrameShape(QtWidgets.QFrame.NoFrame)
        area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self._tabs.addTab(area, title)
        return page, column

    @staticmethod
    def _table(page, column, name, columns):
        table = SmallTable(name, columns, _LINES, page)
        column.addWidget(table)
        return table


def share_text(share):
    """A share with its interval: "74 of 101: 73 % (64 to 81)"."""
    if not share["total"]:
        return translate("ThinPart", "none")
    return translate("ThinPart", "{} of {}: {}\u00a0% ({} to {})").format(
        grouped(share["count"]), grouped(share["total"]), round(100 * share["count"] / share["total"]),
        round(100 * share["low"]), round(100 * share["high"]))


def _summary(learned):
    if learned["after"]["either"]["count"] > learned["before"]["either"]["count"]:
        return translate("ThinPart", "The learned profile agrees with {} labels; {} does with {}.").format(
            share_text(learned["after"]["either"]), learned["start"], share_text(learned["before"]["either"]))
    return translate(
        "ThinPart", "On parts that were left out, the learned profile agrees with the labels no better than {} does: keep "
                    "{}, or label more parts.").format(learned["start"], learned["start"])


def _figures_text(learned):
    if learned["left_out"] == "folders":
        text = translate("ThinPart", "From {} profiles, each learned without some folders or groups, and tried on those. In "
                                     "brackets: intervals of 95\u00a0%.")
    else:
        text = translate("ThinPart", "From {} profiles, each learned without some parts, and tried on those. All parts are "
                                     "in one folder, so parts may be similar: the figures are too good. In brackets: "
                                     "intervals of 95\u00a0%.")
    return text.format(learned["folds"])


def _error_text(scores):
    error = scores["calibration_error"]
    return translate("ThinPart", "none stated") if error is None else marked(f"{error:.3f}")


def _learned_text(change):
    if change["after"] is None:
        return translate("ThinPart", "left out")
    return translate("ThinPart", "as before") if change["after"] == change["before"] else change["after"]


def _count_text(row, verdict):
    label, counts = row
    return f"{grouped(counts[verdict])} \u2713" if label == verdict else grouped(counts[verdict])


def _column(title, text, is_number=False, **more):
    return Column(title, title, text, is_number=is_number, most=40, **more)
