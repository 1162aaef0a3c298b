# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window writes: a file that ThinPart did not write is replaced only where the user says so, some never."""

import os

import pytest
import window_actions as window
from folder_dialog_use import dialog, folder, message, no_choices, run  # noqa: F401 - fixtures among them
from profile_editor import named, opened, own_files, told  # noqa: F401 - a fixture among them

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.kinds.file_marks import MAPS, PROFILE, TABLE
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.application.qt import QtWidgets
from thinpart_workbench.gui.map_export.export_dialog import ExportDialog
from thinpart_workbench.storage.output_file import bears_mark

QUESTION = "ThinPart_OverwriteQuestion"


def answer(button, seen):
    def press(box):
        seen.append(f"{box.text()} {box.informativeText()}")
        box.button(button).click()

    window.answer(QUESTION, press)


def in_file_dialog(name, path):
    """Have a file chosen in a dialog, and its own question, whether to replace it, answered by yes."""
    def choose(box):
        box.setOption(QtWidgets.QFileDialog.DontConfirmOverwrite, True)
        box.findChild(QtWidgets.QLineEdit).setText(str(path))
        box.accept()

    window.answer(name, choose)


def test_a_map_replaces_nothing_of_the_users_without_a_question(document, tmp_path):
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    thickness, = thickness_objects(document)
    export = ExportDialog(thickness)
    export.width_field.setValue(160)
    export.height_field.setValue(120)
    for ending in (".png", ".vtp"):
        path = tmp_path / f"mine{ending}"
        path.write_bytes(b"mine")
        export.selectNameFilter(next(name for name in export.nameFilters() if ending in name))
        seen = []
        answer(QtWidgets.QMessageBox.Cancel, seen)
        assert not export.write(str(path)) and path.read_bytes() == b"mine"
        answer(QtWidgets.QMessageBox.Yes, seen)
        assert export.write(str(path)) and bears_mark(path, MAPS[ending])
        assert seen == [f"{path} was not written by ThinPart. Replace it? What it contains will be lost."] * 2
        assert export.write(str(path)), "what ThinPart wrote is written anew without a question"
    export.selectNameFilter(next(name for name in export.nameFilters() if ".ply" in name))
    (tmp_path / "scan.ply").write_bytes(b"ply\nformat ascii 1.0\nend_header\n")
    (tmp_path / "part.step").write_bytes(b"ISO-10303-21;\n")
    (tmp_path / "link.ply").symlink_to("part.step")
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    for name, sentence in (("scan.ply", "is a CAD file that ThinPart did not write"), ("link.ply", "is a link to"),
                           ("part.step", "has the name of a CAD file"), ("new.stl", "has the name of a CAD file"),
                           ("part.step.thinpart.json", "is an info file")):
        with pytest.raises(ThinPartError, match=sentence):
            export.write(str(tmp_path / name))
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before
    export.deleteLater()


def test_a_table_replaces_nothing_of_the_users_without_a_question(dialog, folder, tmp_path):
    run(folder)
    path, seen = tmp_path / "costs.csv", []
    path.write_text("part,costs\n")
    for button, is_written in ((QtWidgets.QMessageBox.Cancel, False), (QtWidgets.QMessageBox.Yes, True)):
        in_file_dialog("ThinPart_FolderExportDialog", path)
        answer(button, seen)
        window.click("ThinPart_FolderExport")
        window.wait_until(lambda: len(seen) == 1 or message() != "")
        assert bears_mark(path, TABLE) == is_written
    assert len(seen) == 2
    os.rename(path, tmp_path / "other")
    path.symlink_to(folder / "block.FCStd")
    in_file_dialog("ThinPart_FolderExportDialog", path)
    window.click("ThinPart_FolderExport")
    window.wait_until(lambda: "is a link to" in message())


def test_a_profile_replaces_nothing_of_the_users_without_a_question(own_files):
    editor = opened()
    editor.choose("paper")
    path, seen = own_files / "letters.json", []
    path.write_text('{"to": "Anna"}')
    for button, is_written in ((QtWidgets.QMessageBox.Cancel, False), (QtWidgets.QMessageBox.Yes, True)):
        in_file_dialog("ThinPart_ProfileSaveDialog", path)
        answer(button, seen)
        window.click("ThinPart_ProfileSaveAs")
        window.settle(50)
        assert bears_mark(path, PROFILE) == is_written, told(editor)
    assert len(seen) == 2
    info = own_files / "part.step.thinpart.json"
    info.write_text("{}")
    in_file_dialog("ThinPart_ProfileSaveDialog", info)
    window.click("ThinPart_ProfileSaveAs")
    window.settle(50)
    assert "is an info file and was not changed" in told(editor) and info.read_text() == "{}"
    editor.end()
