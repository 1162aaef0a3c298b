# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of the results of a folder."""

from ..application.numbers import number
from ..application.qt import translate
from ..application.sentences import translated
from ..record.label_button import labels_sentence
from ..record.part_columns import category_column, measured, quantity_columns, risk_column, thinnest_column
from ..record.thumbnails import RowPictures, show_pictures
from ..record.verdict_text import criterion_titles
from ..record.wall_checks import SYMBOLS
from ..tables.column import Column, count, figures
from ..tables.kept_rows import KeptRows

_MOST = 50
"""Greatest width of a column, in characters."""


class Results(KeptRows):
    """Model of PartRows.

    Parameters
    ----------
    profile : Profile
        Titles categories and criteria.
    pictures : Thumbnails

    Attributes
    ----------
    pictures : RowPictures
    """

    def __init__(self, profile, pictures, parent=None):
        self.pictures = RowPictures(pictures)
        super().__init__(result_columns(profile, (), self.pictures), parent)
        pictures.loaded.connect(lambda: show_pictures(self))

    def begin(self, profile, limits):
        """Show no rows, and columns for another profile and the limits that are checked."""
        self.set_rows([])
        self.show_columns(result_columns(profile, limits, self.pictures))

    def tip(self, row, column):
        """Why a part failed, or what is to be known of it; its file where there is nothing."""
        return translated(row.error or row.warnings or "", self.unit) or row.file


def result_columns(profile, limits, pictures):
    """Columns for PartRows, one for each of the limits too, with RowPictures: list of Column."""
    titles = criterion_titles(profile)

    def criteria(row):
        # Names of criteria give way first, since the tool tip shows them whole.
        return ", ".join(titles.get(name, name) for name in (row.criteria or "").split())

    columns = [
        Column("file", translate("ThinPart", "File"), lambda row: row.file, is_path=True, stretches=True, most=_MOST,
               least=26),
        Column("label", translate("ThinPart", "Part"), lambda row: row.label or row.part, picture=pictures.of,
               most=_MOST, least=26),
        category_column(profile, most=_MOST, least=35),
        *(_check_column(number, each) for number, each in enumerate(limits)),
        Column("criteria", translate("ThinPart", "Criteria"), criteria, tip=lambda row, unit: criteria(row), most=_MOST,
               least=14),
        Column("box", translate("ThinPart", "Box, {}"), lambda row: row.d1_mm, _box, is_number=True, has_unit=True,
               most=_MOST),
        measured("volume_ratio", "V/VBB", lambda value, unit: number(value)),
        thinnest_column(),
        figures("instances", translate("ThinPart", "Instances"), lambda row: row.instances, count),
        Column("labels", translate("ThinPart", "Labels"), lambda row: labels_sentence(getattr(row, "said", ()), profile),
               most=_MOST),
        risk_column(),
    ]
    return columns + quantity_columns({column.key for column in columns})


def _box(row, unit):
    return "" if row.d1_mm is None else " \u00d7 ".join(map(unit.number, (row.d1_mm, row.d2_mm, row.d3_mm)))


def _check_column(number, limits):
    def result(row):
        """The result of the check, None for a failure."""
        checks = getattr(row, "checks", ())
        return checks[number] if number < len(checks) else None

    def text(row):
        check = result(row)
        words = {True: translate("ThinPart", "passes"), False: translate("ThinPart", "fails"),
                 None: translate("ThinPart", "unknown")}
        return check and f"{SYMBOLS[check['passes']]} {words[check['passes']]}"

    return Column(f"check {limits.name}", translated(limits.full_title), text, most=_MOST,
                  tip=lambda row, unit: result(row) and translated(result(row)["sentence"], unit))
