"""The walls under each B-Rep face of a part, as a table."""

from dataclasses import dataclass

from ..core.map_summary import FaceSummary
from .length_unit import MILLIMETRE
from .qt import translate
from .row_table import RowColumn, RowTable
from .verdict_text import percent

_LINES = 10


@dataclass(frozen=True)
class FaceRow:
    """A face.

    Attributes
    ----------
    summary : FaceSummary
    feature : str
        What made it, empty where that is not known.
    """

    summary: FaceSummary
    feature: str = ""

    @property
    def name(self):
        """As FreeCAD calls it."""
        return f"Face{self.summary.face + 1}"


class FaceTable(RowTable):
    """Faces with thinnest and median wall and the shares that are thin or not measured."""

    def __init__(self, parent=None):
        super().__init__("ThinPart_FaceTable", _columns(False, MILLIMETRE), _LINES, parent)

    def show_faces(self, summaries, features, unit):
        """Show the faces of a part; those that are selected stay so if there are as many.

        Parameters
        ----------
        summaries : list of FaceSummary
        features : list of str
            What made each face, by its number; empty where that is not known.
        unit : LengthUnit
        """
        self.set_columns(_columns(any(features), unit))
        rows = [FaceRow(each, features[each.face] if each.face < len(features) else "") for each in summaries]
        self.update_rows(rows, lambda one, other: one.name == other.name)

    def select_face(self, face):
        """Select the row of a face by its number from 0, without a signal; no row where it is None."""
        self.select(None if face is None else lambda row: row.summary.face == face)


def _columns(with_features, unit):
    columns = [RowColumn(translate("ThinPart", "Face"), lambda row: row.name, lambda row: row.summary.face)]
    if with_features:
        columns.append(RowColumn(translate("ThinPart", "Made by"), lambda row: row.feature,
                                 lambda row: row.feature.casefold() or None))
    return columns + [
        _number_column(translate("ThinPart", "Thinnest, {}").format(unit.symbol), "thinnest", unit.number,
                       translate("ThinPart", "Thinnest wall under the face")),
        _number_column(translate("ThinPart", "Median, {}").format(unit.symbol), "median", unit.number,
                       translate("ThinPart", "Half of the face lies over thinner walls")),
        _number_column(translate("ThinPart", "Thin"), "thin_share", percent,
                       translate("ThinPart", "Share of the face over walls under the threshold")),
        _number_column(translate("ThinPart", "Unmeasured"), "unmeasured_share", percent,
                       translate("ThinPart", "Share of the face where no wall could be measured")),
    ]


def _number_column(title, name, text, meaning):
    return RowColumn(title, lambda row: text(getattr(row.summary, name)),
                     lambda row: getattr(row.summary, name), is_number=True, meaning=meaning)
