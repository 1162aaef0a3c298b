# SPDX-License-Identifier: LGPL-2.1-or-later
"""A thickness map is written as a picture, as PolyData and as PLY."""

import shutil

import FreeCAD as App
import numpy as np
import pytest
import window_actions as window
from read_png import read_png
from thickness_window import bar_of_document, look_at, view_of

from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application import lifelong
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


@pytest.mark.parametrize("sample", ["ribbed_block", "plate", "bent_sheet_bracket", "flange", "tube"])
def test_the_colour_bar_of_a_picture_is_beside_the_part(sample, tmp_path):
    file = tmp_path / f"{sample}.FCStd"
    shutil.copyfile(window.SAMPLES / file.name, file)
    document = App.openDocument(str(file))
    window.show_thickness()
    window.settle(300)
    view = look_at(document)
    view.viewTop()  # flat on the screen, so that it reaches from side to side
    view.fitAll()
    window.settle(100)
    height = view.getCameraNode().height.getValue()
    export(tmp_path / f"{sample}.png", "png", (800, 500))
    assert view.getCameraNode().height.getValue() == height
    assert not bar_of_document(document).isEmpty()
    image = read_png(tmp_path / f"{sample}.png")[:, :, :3].astype(int)
    # The strip with the bar is white at its upper and lower edge and to the left; the view beside it is not.
    white = (image[[0, 1, 2, -3, -2, -1]] == 255).all(axis=(0, 2))
    strip = int(np.argmin(white))
    assert 60 < strip < 330 and not white[strip:].any()
    assert (image[:, :4] == 255).all()
    coloured = np.ptp(image, axis=2) > 60
    assert coloured[:, :strip].any(), "the colours of the bar"
    # The part lies within the rest, and nothing of a second bar: colours end before its edges.
    found = np.flatnonzero(coloured[:, strip:].any(axis=0))
    assert len(found) and found[0] > 0 and found[-1] < 800 - strip - 1


def test_a_picture_without_colour_bar_is_as_wide_as_asked_for(document, tmp_path):
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    window.widget("ThinPart_ColourBarShown").click()
    try:
        window.wait_until(lambda: lifelong.scene_sync.bar_in(view_of(document)) is None)
        export(tmp_path / "view.png", "png", (320, 240))
        image = read_png(tmp_path / "view.png")
        assert image.shape[:2] == (240, 320) and not (image[:, :4, :3] == 255).all()
    finally:
        set_preference("ColourBarShown", True)
