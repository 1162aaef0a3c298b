# SPDX-License-Identifier: LGPL-2.1-or-later
import csv

from thinpart_workbench.core.kinds.file_marks import TABLE
from thinpart_workbench.storage.output_file import bears_mark
from thinpart_workbench.storage.part_table import PartRow, failed_row, part_table, write_table


def test_what_cannot_be_text_and_what_must_be_quoted_is_written(tmp_path):
    error = {"kind": "crash", "message": 'it ended, "as said"\nand again'}
    row = failed_row("a,b/\udcff.step", None, None, error)
    form = part_table()
    write_table(tmp_path / "table.csv", form, [form.text([row])])
    assert bears_mark(tmp_path / "table.csv", TABLE)
    with open(tmp_path / "table.csv", newline="", encoding="utf-8") as file:
        head, row = csv.reader(file)
    assert tuple(head) == PartRow._fields
    assert row[0] == "a,b/\\udcff.step"
    assert row[1:-2] == [""] * (len(PartRow._fields) - 3)
    assert row[-2:] == ["crash", error["message"]]
