"""What is known of the part that is selected in the list."""

from ..core.criteria import profile_from
from ..core.errors import ThinPartError
from .distribution_comparison import DistributionComparison
from .found_table import part_name
from .kept_fields import KeptFields
from .length_unit import length_unit
from .part_pictures import neutral_picture
from .qt import QtCore, QtWidgets, translate
from .result_view import ResultView, show_text, text_line
from .sentences import translated, translated_list

VERDICT, NOTES, COMPARISON = range(3)


class PartDetails(QtWidgets.QTabWidget):
    """Verdict, notes and, where parts are compared, the two distributions.

    Parameters
    ----------
    pictures : PartPictures
    """

    def __init__(self, pictures, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_PartDetails")
        self._pictures, self._part, self._wanted, self._told = pictures, None, None, None
        self.kept = KeptFields(self)
        self._add_verdict()
        self.addTab(_scrolled(self.kept), translate("ThinPart", "Notes"))
        self._add_comparison()
        pictures.came.connect(self._show_picture)
        self.show_part(None)

    @property
    def part(self):
        """The part that is shown, or None."""
        return self._part

    def show_part(self, part):
        """Turn to another part; its record follows in `show_record`."""
        self._part, self._told = part, None
        self.kept.show_part(part)
        self._result.hide()
        self._show_picture()
        self._file.setText("" if part is None else part.file)
        self._file.setToolTip(self._file.text())
        show_text(self._sentence, "" if part is None else translated(part.error_message or ""))
        self._compare()

    def show_record(self, told):
        """Show a part's record, unless another part was selected meanwhile.

        Parameters
        ----------
        told : dict
            ``info_file``, ``name``, and ``record`` and ``profile``, or a ``sentence``.
        """
        if self._part is None or (told["info_file"], told["name"]) != (self._part.info_file, self._part.name):
            return
        try:
            if "sentence" in told:
                raise ThinPartError(told["sentence"])
            self._show_result(told)
        except ThinPartError as error:
            show_text(self._sentence, translated(error))
            return
        except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
            show_text(self._sentence, translate(
                "ThinPart", "The info file {} is damaged ({}): classify its document again."
            ).format(told["info_file"], type(error).__name__))
            return
        self._told = told
        self._result.show_legend(False)
        self._result.show()
        self.kept.show_record(told["record"])
        self._compare()

    def show_unit(self):
        """Write the lengths of what is shown in the unit of this moment."""
        if self._told is not None:
            self._show_result(self._told)

    def _show_result(self, told):
        self._result.show_record(told["record"], profile_from(told["profile"]), length_unit())

    def compare_with(self, name, record):
        """Compare what is selected with a part from now on; with none where `record` is None."""
        self._wanted = None if record is None else (name, record["descriptors"]["distribution"])
        if self._wanted is None and self.currentIndex() == COMPARISON:
            self.setCurrentIndex(VERDICT)
        self.setTabEnabled(COMPARISON, self._wanted is not None)
        if self._wanted is not None:
            self.setCurrentIndex(COMPARISON)
        self._compare()

    def edit_notes(self):
        """Show the notes with the cursor in them."""
        self.setCurrentIndex(NOTES)
        self.kept.edit()

    def _add_verdict(self):
        page = QtWidgets.QWidget(self)
        column = QtWidgets.QVBoxLayout(page)
        column.setContentsMargins(4, 4, 4, 4)
        self._picture = QtWidgets.QLabel(page)
        self._picture.setObjectName("ThinPart_PartPicture")
        column.addWidget(self._picture)
        # Paths have no places where a label could break them.
        self._file = QtWidgets.QLineEdit(page)
        self._file.setObjectName("ThinPart_PartFile")
        self._file.setReadOnly(True)
        self._file.setFrame(False)
        self._file.setPlaceholderText(translate("ThinPart", "Select a part in the list."))
        self._file.setStyleSheet("QLineEdit { background: transparent; }")
        column.addWidget(self._file)
        self._sentence = text_line(page, column, "ThinPart_PartSentence")
        self._result = ResultView(page)
        column.addWidget(self._result)
        column.addStretch(1)
        self.addTab(_scrolled(page), translate("ThinPart", "Verdict"))

    def _add_comparison(self):
        page = QtWidgets.QWidget(self)
        column = QtWidgets.QVBoxLayout(page)
        column.setContentsMargins(4, 4, 4, 4)
        self._chart = DistributionComparison(page)
        column.addWidget(self._chart)
        self._likeness = text_line(page, column, "ThinPart_Likeness")
        column.addStretch(1)
        self.addTab(_scrolled(page), translate("ThinPart", "Comparison"))
        self.setTabEnabled(COMPARISON, False)

    def _compare(self):
        named = [self._wanted] if self._wanted else []
        if named and self._told is not None:
            named.append((part_name(self._part), self._told["record"]["descriptors"]["distribution"]))
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


def _scrolled(page):
    area = QtWidgets.QScrollArea()
    area.setWidget(page)
    area.setWidgetResizable(True)
    area.setFrameShape(QtWidgets.QFrame.NoFrame)
    area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAsNeeded)
    return area
