# SPDX-License-Identifier: LGPL-2.1-or-later
"""Details of the part selected in the list."""

from ...core.errors import ThinPartError
from ...core.judging.criteria import profile_from
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtWidgets, Signal, translate
from ..application.sentences import translated, translated_list
from ..record.record_view import RecordView, show_text, text_line
from ..record.thumbnails import neutral_picture
from .distribution_comparison import DistributionComparison
from .found_rows import part_name
from .notes_page import NotesPage

VERDICT, NOTES, COMPARISON = range(3)


class PartDetails(QtWidgets.QTabWidget):
    """Tabs with the verdict, the notes and, during a comparison, the two distributions.

    Parameters
    ----------
    pictures : Thumbnails

    Signals
    -------
    labelled(object, str, bool)
        The part, and what `LabelButton.label_chosen` says of it.
    """

    labelled = Signal(object, str, bool)

    def __init__(self, pictures, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_PartDetails")
        self._pictures, self._part, self._reference, self._response = pictures, None, None, None
        self.notes = NotesPage(self)
        self._add_verdict()
        self.addTab(scrolled(self.notes), translate("ThinPart", "Notes"))
        self._add_comparison()
        pictures.loaded.connect(self._show_picture)
        self.show_part(None)

    @property
    def part(self):
        """The shown part, or None."""
        return self._part

    def show_part(self, part):
        """Show another part; its record arrives later in `show_record`."""
        self._part, self._response = part, None
        self.notes.show_part(part)
        self._result.hide()
        self._show_picture()
        self._file.setText("" if part is None else part.file)
        self._file.setToolTip(self._file.text())
        show_text(self._sentence, "" if part is None else translated(part.error_message or ""))
        self._compare()

    def show_record(self, response):
        """Show the record of a part, unless another part has been selected since the request.

        Parameters
        ----------
        response : dict
            ``info_file``, ``name``, and either ``record`` and ``profile`` or a ``sentence``.
        """
        if self._part is None or (response["info_file"], response["name"]) != (self._part.info_file, self._part.name):
            return
        try:
            if "sentence" in response:
                raise ThinPartError(response["sentence"])
            self._show_result(response)
        except ThinPartError as error:
            show_text(self._sentence, translated(error))
            return
        except (KeyError, TypeError, ValueError, AttributeError, IndexError):
            show_text(self._sentence, translate(
                "ThinPart", "The info file {} is damaged ({}): classify its document again."
            ).format(response["info_file"], translate("ThinPart", "values are missing or of another kind")))
            return
        self._response = response
        self._result.show_legend(False)
        self._result.show()
        self.notes.show_record(response["record"])
        self._compare()

    def show_kept_label(self, request):
        """Show a label that was kept, or why not, where it is of the shown part: an answered `Request`."""
        arguments = request.arguments
        if self._response is None or (arguments["path"], arguments["part"]) != (self._part.info_file, self._part.name):
            return
        record = self._response["record"]
        if not request.sentence:
            record["labels"] = request.answer
        self._result.show_labels(record.get("labels", ()), "\u26a0 " + request.sentence if request.sentence else "")

    def show_unit(self):
        """Show lengths in the current unit."""
        self.notes.show_unit()
        if self._response is not None:
            self._show_result(self._response)

    def _show_result(self, response):
        self._result.file = self._part.file
        self._result.show_record(response["record"], profile_from(response["profile"]), length_unit())

    def compare_with(self, name, record):
        """Compare the selected part with a reference part; no comparison if `record` is None."""
        self._reference = None if record is None else (name, record["descriptors"]["distribution"])
        if self._reference is None and self.currentIndex() == COMPARISON:
            self.setCurrentIndex(VERDICT)
        self.setTabEnabled(COMPARISON, self._reference is not None)
        if self._reference is not None:
            self.setCurrentIndex(COMPARISON)
        self._compare()

    def edit_notes(self):
        """Show the notes and put the cursor into them."""
        self.setCurrentIndex(NOTES)
        self.notes.edit()

    def _add_verdict(self):
        page = QtWidgets.QWidget(self)
        column = QtWidgets.QVBoxLayout(page)
        column.setContentsMargins(4, 4, 4, 4)
        self._picture = QtWidgets.QLabel(page)
        self._picture.setObjectName("ThinPart_PartPicture")
        column.addWidget(self._picture)
        # A line edit, because a label cannot wrap a path.
        self._file = QtWidgets.QLineEdit(page)
        self._file.setObjectName("ThinPart_PartFile")
        self._file.setReadOnly(True)
        self._file.setFrame(False)
        self._file.setPlaceholderText(translate("ThinPart", "Select a part in the list."))
        self._file.setStyleSheet("QLineEdit { background: transparent; }")
        column.addWidget(self._file)
        self._sentence = text_line(page, column, "ThinPart_PartSentence")
        self._result = RecordView(page)
        self._result.labelled.connect(lambda category, is_sure: self.labelled.emit(self._part, category, is_sure))
        column.addWidget(self._result)
        column.addStretch(1)
        self.addTab(scrolled(page), translate("ThinPart", "Verdict"))

    def _add_comparison(self):
        page = QtWidgets.QWidget(self)
        column = QtWidgets.QVBoxLayout(page)
        column.setContentsMargins(4, 4, 4, 4)
        self._chart = DistributionComparison(page)
        column.addWidget(self._chart)
        self._likeness = text_line(page, column, "ThinPart_Likeness")
        column.addStretch(1)
        self.addTab(scrolled(page), translate("ThinPart", "Comparison"))
        self.setTabEnabled(COMPARISON, False)

    def _compare(self):
        named = [self._reference] if self._reference else []
        if named and self._response is not None:
            named.append((part_name(self._part), self._response["record"]["descriptors"]["distribution"]))
        self._chart.show_parts(named)
        score = getattr(self._part, "score", None)
        show_text(self._likeness, "" if score is None else translate("ThinPart", "{}\u00a0% like: {}").format(
            round(score), translated_list(self._part.reasons)))

    def _show_picture(self):
        part = self._part
        self._picture.setVisible(part is not None)
        if part is None:
            return
        ratio = self.devicePixelRatioF()
        line = self.fontMetrics().height()
        size = QtCore.QSize(8 * line, 6 * line)
        picture = self._pictures.picture(part)
        if picture is None:
            picture = neutral_picture(part, size / 2, ratio)
        else:
            picture = picture.scaled(size * ratio, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation)
            picture.setDevicePixelRatio(ratio)
        self._picture.setPixmap(picture)


def scrolled(page):
    """A QScrollArea without a frame around a page."""
    area = QtWidgets.QScrollArea()
    area.setWidget(page)
    area.setWidgetResizable(True)
    area.setFrameShape(QtWidgets.QFrame.NoFrame)
    return area
