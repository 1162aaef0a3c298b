# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks where and as what a thickness map is to be written, and writes it."""

import os
from pathlib import Path

from ...api.document_maps import parts_of
from ...core.errors import ThinPartError
from ...core.kinds.file_marks import MAPS
from ...storage.exchange.map_export import MAP_FORMATS, write_map_file
from ...storage.output_file import write_output
from ...storage.png import marked_png
from ...storage.temporary_folder import temporary_folder
from ..application.qt import QtWidgets, execute, named, translate
from ..application.sentences import translated
from ..colour_bar.colours import ThicknessColours
from ..widgets.confirmation import may_overwrite
from .view_picture import view_picture

PICTURE = ".png"
"""Ending of pictures of the view."""

WIDTH, HEIGHT = 1600, 1200
"""Size of a picture that is offered at first, pixels."""

_MOST_PIXELS = 16_000


class ExportDialog(QtWidgets.QFileDialog):
    """File dialog with the formats for a map, and the size of a picture."""

    def __init__(self, thickness, parent=None):
        super().__init__(parent, translate("ThinPart", "Export thickness map"))
        self._thickness = thickness
        self.setObjectName("ThinPart_ExportMap")
        # The system's own dialog has no place for the size.
        self.setOption(QtWidgets.QFileDialog.DontUseNativeDialog, True)
        self.setAcceptMode(QtWidgets.QFileDialog.AcceptSave)
        self._endings = {
            translate("ThinPart", "Picture of the view (*.png)"): PICTURE,
            **{translated(each.title): ending for ending, each in MAP_FORMATS.items()},
        }
        self.setNameFilters(list(self._endings))
        self.filterSelected.connect(self._on_filter)
        file = thickness.Document.FileName
        if file:
            self.setDirectory(os.path.dirname(file))
        self.selectFile(f"{os.path.splitext(os.path.basename(file))[0] or thickness.Document.Label}-thickness")
        row = QtWidgets.QHBoxLayout()
        self._size = QtWidgets.QWidget(self)
        self._size.setLayout(row)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(QtWidgets.QLabel(translate("ThinPart", "Size"), self._size))
        self.width_field, self.height_field = (self._pixels(row, name, value) for name, value in (
            ("ThinPart_PictureWidth", WIDTH), ("ThinPart_PictureHeight", HEIGHT)))
        row.addWidget(QtWidgets.QLabel(translate("ThinPart", "pixels"), self._size))
        row.addStretch(1)
        self.layout().addWidget(self._size, self.layout().rowCount(), 1)
        self._on_filter(self.selectedNameFilter())

    @property
    def ending(self):
        """str: of the chosen format."""
        return self._endings.get(self.selectedNameFilter(), PICTURE)

    def write(self, path):
        """Write the map to a file; the user is asked before one is replaced that ThinPart did not write: whether it was.

        Raises
        ------
        ThinPartError
            kind ``usage`` or ``failed``, with a sentence.
        """
        try:
            overwrite = may_overwrite(self, path, MAPS[self.ending], [self._thickness.Document.FileName])
            if overwrite is None:
                return False
            if self.ending == PICTURE:
                write_output(path, marked_png(self._picture()), MAPS[PICTURE], overwrite)
            else:
                colours = ThicknessColours.of(self._thickness).of_corners
                write_map_file(path, self.ending, parts_of(self._thickness), colours, overwrite)
            return True
        except OSError as error:
            raise ThinPartError(translate("ThinPart", "{} cannot be written ({}): choose another place.").format(
                path, error.strerror or error), "failed") from None

    def _picture(self):
        """What the view shows with the colour bar beside it, as the bytes of a PNG file."""
        picture = view_picture(self._thickness.Document, self.width_field.value(), self.height_field.value())
        with temporary_folder() as folder:
            file = Path(folder) / f"view{PICTURE}"
            picture.save(str(file))
            return file.read_bytes()

    def _pixels(self, row, name, value):
        field = named(QtWidgets.QSpinBox(self._size), name)
        field.setRange(16, _MOST_PIXELS)
        field.setValue(value)
        row.addWidget(field)
        return field

    def _on_filter(self, _):
        self.setDefaultSuffix(self.ending[1:])
        self._size.setVisible(self.ending == PICTURE)


def export_map(thickness, parent):
    """Ask for a file and write a map; return what to say: str, empty where the user cancelled."""
    dialog = ExportDialog(thickness, parent)
    try:
        if execute(dialog) != QtWidgets.QDialog.Accepted:
            return ""
        path = dialog.selectedFiles()[0]
        if not dialog.write(path):
            return ""
    except ThinPartError as error:
        return translated(error)
    finally:
        dialog.deleteLater()
    return translate("ThinPart", "Written: {}").format(os.path.basename(path))
