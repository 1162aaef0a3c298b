# SPDX-License-Identifier: LGPL-2.1-or-later
"""A thickness map is written as a picture, as PolyData and as PLY."""

import window_actions as window
from read_png import read_png

from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets


def export(path, kind, size=None):
    """Press the button, choose a format and a file in its dialog, and accept it."""
    seen = []

    def fill():
        dialog = next((each for each in QtWidgets.QApplication.topLevelWidgets()
                       if each.objectName() == "ThinPart_ExportMap" and each.isVisible()), None)
        if dialog is None:
            QtCore.QTimer.singleShot(50, fill)
            return
        seen.append(dialog.width_field.isVisible())
        name, = [name for name in dialog.nameFilters() if f"*.{kind})" in name]
        dialog.selectNameFilter(name)
        dialog.filterSelected.emit(name)
        seen.append(dialog.width_field.isVisible())
        if size:
            dialog.width_field.setValue(size[0])
            dialog.height_field.setValue(size[1])
        dialog.findChild(QtWidgets.QLineEdit, "fileNameEdit").setText(str(path))
        dialog.accept()

    QtCore.QTimer.singleShot(50, fill)
    window.widget("ThinPart_ExportButton").click()
    window.settle(50)
    return seen


def test_a_map_is_exported_in_every_format(document, tmp_path):
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    assert len(thickness_objects(document)) == 1
    assert export(tmp_path / "view.png", "png", (320, 240)) == [True, True]
    image = read_png(tmp_path / "view.png")
    assert image.shape[:2] == (240, 320) and len({tuple(pixel) for row in image[::8, ::8] for pixel in row}) > 8
    assert "Written: view.png" in window.text("ThinPart_ExportText")
    assert export(tmp_path / "map", "vtp") == [True, False]
    assert (tmp_path / "map.vtp").read_text().startswith('<?xml version="1.0"?>\n<VTKFile type="PolyData"')
    export(tmp_path / "map", "ply")
    assert (tmp_path / "map.ply").read_bytes().startswith(b"ply\nformat binary_little_endian 1.0")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["map.ply", "map.vtp", "view.png"]


def test_what_cannot_be_written_is_told_and_cancelling_says_nothing(document, tmp_path):
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    (tmp_path / "locked.vtp").mkdir()
    from thinpart_workbench.core.errors import ThinPartError
    from thinpart_workbench.gui.map_export.export_dialog import ExportDialog

    thickness, = thickness_objects(document)
    dialog = ExportDialog(thickness)
    dialog.selectNameFilter(next(name for name in dialog.nameFilters() if "vtp" in name))
    try:
        dialog.write(str(tmp_path / "locked.vtp"))
        raise AssertionError("a folder was overwritten")
    except ThinPartError as error:
        assert "locked.vtp cannot be written" in str(error)
    dialog.deleteLater()
    assert not window.text("ThinPart_ExportText")
