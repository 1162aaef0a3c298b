# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of the wall thickness under each B-Rep face of a part."""

from dataclasses import dataclass

from ...core.maps.map_summary import FaceSummary
from ..application.numbers import percent
from ..application.qt import translate
from ..tables.column import Column, area, figures, length
from ..tables.wall_table import WallTable

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


class FaceTable(WallTable):
    """Faces with their thinnest and median wall and their thin and unmeasured shares."""

    def __init__(self, parent=None):
        super().__init__("ThinPart_FaceTable", _columns(False), _VISIBLE_ROWS, _walls, parent)

    def show_faces(self, summaries, features, unit, record, file=""):
        """Show the faces of a part; the selection stays if the number of faces is the same.

        Parameters
        ----------
        summaries : list of FaceSummary
        features : list of str
            The feature that made each face, by face number; empty if unknown.
        file : str, optional
            Path of the part's document.
        """
        rows = [FaceRow(summary, features[summary.face] if summary.face < len(features) else "") for summary in summaries]
        self.show_rows(rows, _columns(any(features)), unit, lambda one, other: one.name == other.name,
                       (file, record["name"], record["label"]))

    def select_face(self, face):
        """Select the row of a face by its number from 0, or clear the selection for None; emits no signal."""
        self.select(None if face is None else lambda row: row.summary.face == face)


def _walls(row):
    return [] if row.summary.thinnest is None else [(row.summary.thinnest, row.summary)]


def _columns(with_features):
    columns = [Column("face", translate("ThinPart", "Face"), lambda row: row.name,
                      order=lambda row: row.summary.face)]
    if with_features:
        columns.append(Column("made_by", translate("ThinPart", "Made by"), lambda row: row.feature, least=6))
    return columns + [
        _of_summary("thinnest", translate("ThinPart", "Thinnest, {}"), length,
                    translate("ThinPart", "Thinnest wall under the face")),
        _of_summary("median", translate("ThinPart", "Median, {}"), length,
                    translate("ThinPart", "Half of the face's area has thinner walls")),
        _of_summary("thin_share", translate("ThinPart", "Thin"), _share,
                    translate("ThinPart", "Share of the face whose walls are thinner than the threshold")),
        _of_summary("unmeasured_share", translate("ThinPart", "Unmeasured"), _share,
                    translate("ThinPart", "Share of the face where no wall could be measured")),
        figures("area_mm2", translate("ThinPart", "Area, {}\u00b2"), lambda row: row.summary.area, area, is_hidden=True),
    ]


def _of_summary(name, title, shown, meaning):
    key = f"{name}_mm" if shown is length else name
    return figures(key, title, lambda row: getattr(row.summary, name), shown, meaning=meaning)


def _share(share, unit):
    return percent(share)
