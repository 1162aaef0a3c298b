# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables on terminals that are too narrow, and in pipes, which have no width."""

import io
import os

import pytest

from thinpart_workbench.cli.terminal_table import TableColumn, print_table

ROWS = [("p089_Profile-20x20-B-Type_Slot6_A.step", "similar wall distribution, different proportions",
         "1.0e+03 x 20.99 x 0.998", "0.0735 edge, wall 0.8793")]
COLUMNS = (TableColumn("File", lambda row: row[0]), TableColumn("Why", lambda row: row[1]),
           TableColumn("D1 x D2 x D3 mm", lambda row: row[2], True), TableColumn("Thinnest mm", lambda row: row[3], True))


class Terminal(io.StringIO):
    def isatty(self):
        return True


def printed(stream):
    print_table(stream, COLUMNS, lambda: ROWS)
    return stream.getvalue()


@pytest.mark.parametrize("width", [20, 60, 80, 100])
def test_numbers_and_words_stay_whole_on_a_narrow_terminal(monkeypatch, width):
    monkeypatch.setenv("COLUMNS", str(width))
    monkeypatch.setenv("NO_COLOR", "1")
    text = printed(Terminal())
    for word in " ".join(ROWS[0][1 if width >= 60 else 2:]).split():
        assert word in text.split()
    assert "".join(line.split()[0] for line in text.splitlines()[1:] if line[:1] != " ").startswith("p089_Profile")
    assert width < 80 or max(map(len, text.splitlines())) <= width


def test_nothing_is_cut_in_a_pipe():
    title, line = printed(io.StringIO()).splitlines()
    assert all(cell in line for cell in ROWS[0]) and os.linesep not in line and title.startswith("File")
