"""A table of the wall thickness under each B-Rep face of a part."""

from dataclasses import dataclass

from ...core.maps.map_summary import FaceSummary
from ..application.length_unit import MILLIMETRE
from ..application.numbers import percent
from ..application.qt import translate
from ..widgets.record_table_view import RecordColumn
from ..widgets.wall_table_view import WallTableView

_VISIBLE_ROWS = 10


@dataclass(frozen=True)
class FaceRow:
    """A row of the table.

    Attributes
    ----------
    summary : FaceSummary
    feature : str
        The feature that made the face, empty if unknown.
    """

    summary: FaceSummary
    feature: str = ""

    @property
    def name(self):
        """FreeCAD's name of the face."""
        return f"Face{self.summary.face + 1}"


class FaceTable(WallTableView):
    """Faces with their thinnest and median wall and their thin and unmeasured shares."""

    def __init__(self, parent=None):
        super().__init__("ThinPart_FaceTable", _columns(False, MILLIMETRE), _VISIBLE_ROWS, _walls, parent)

    def show_faces(self, summaries, features, unit):
        """Show the faces of a part; the selection stays if the number of faces is the same.

        Parameters
        ----------
        summaries : list of FaceSummary
        features : list of str
            The feature that made each face, by face number; empty if unknown.
        unit : LengthUnit
        """
        self.set_columns(_columns(any(features), unit))
        rows = [FaceRow(summary, features[summary.face] if summary.face < len(features) else "") for summary in summaries]
        self.update_rows(rows, lambda one, other: one.name == other.name)

    def select_face(self, face):
        """Select the row of a face by its number from 0, or clear the selection for None; emits no signal."""
        self.select(None if face is None else lambda row: row.summary.face == face)


def _walls(row):
    return [] if row.summary.thinnest is None else [(row.summary.thinnest, row.summary)]


def _columns(with_features, unit):
    columns = [RecordColumn(translate("ThinPart", "Face"), lambda row: row.name, lambda row: row.summary.face)]
    if with_features:
        columns.append(RecordColumn(translate("ThinPart", "Made by"), lambda row: row.feature,
                                 lambda row: row.feature.casefold() or None))
    return columns + [
        _number_column(translate("ThinPart", "Thinnest, {}").format(unit.symbol), "thinnest", unit.number,
                       translate("ThinPart", "Thinnest wall under the face")),
        _number_column(translate("ThinPart", "Median, {}").format(unit.symbol), "median", unit.number,
                       translate("ThinPart", "Half of the face's area has thinner walls")),
        _number_column(translate("ThinPart", "Thin"), "thin_share", percent,
                       translate("ThinPart", "Share of the face whose walls are thinner than the threshold")),
        _number_column(translate("ThinPart", "Unmeasured"), "unmeasured_share", percent,
                       translate("ThinPart", "Share of the face where no wall could be measured")),
    ]


def _number_column(title, name, text, tool_tip):
    return RecordColumn(title, lambda row: text(getattr(row.summary, name)),
                     lambda row: getattr(row.summary, name), is_number=True, meaning=tool_tip)
