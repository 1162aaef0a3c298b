# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of others comes back as one datum from the real reader of each language that it is written into."""

import csv
import io
import json
import os
import re
import shutil
import sqlite3
import subprocess
import unicodedata
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser
from urllib.parse import unquote_to_bytes, urlsplit

import numpy as np
import pytest
from hostile_texts import ALL, NAMED

from thinpart_workbench.core.foreign_text import (
    LONGEST_CELL,
    LONGEST_GMSH,
    LONGEST_HEAD,
    csv_form,
    csv_text,
    csv_value,
    gmsh_text,
    head_text,
    html_text,
    is_gmsh_text,
    json_text,
    printable,
    safe_name,
    sql_like,
    sql_text,
    terminal_cell,
    url_path,
    xml_text,
)
from thinpart_workbench.core.shells.shell_mesh import ShellMesh
from thinpart_workbench.storage.exchange.shell_files import SHELL_FORMATS, write_shell
from thinpart_workbench.workflow.report.html_elements import element, page_bytes


def unseen(text, kept=""):
    """Whether a text has characters that command terminals, or that are none."""
    return any(unicodedata.category(each) in ("Cc", "Cf", "Cs", "Zl", "Zp") and each not in kept for each in text)


def test_a_terminal_gets_one_line_of_characters_that_it_shows():
    for text in ALL:
        shown = printable(text)
        assert not unseen(shown) and len(shown.splitlines()) <= 1, ascii(text)
        assert shown == text or unseen(text)
        assert len(terminal_cell(text)) <= LONGEST_CELL and not unseen(terminal_cell(text))


def test_csv():
    table = csv_text([(text, number, None, text) for number, text in enumerate(ALL)])
    assert not unseen(table, "\r\n\t") and table.encode()
    rows = list(csv.reader(io.StringIO(table, newline=""), strict=True))
    assert [[row[1], row[2]] for row in rows] == [[str(number), ""] for number in range(len(ALL))]
    for text, row in zip(ALL, rows):
        assert row[0] == row[3] and not row[0].startswith(("=", "+", "-", "@", "\t", "\r"))
        assert csv_value(row[0]) == csv_form(text) or text.startswith("'"), ascii(text)


def test_json_lines():
    for text in ALL:
        line = json_text({"label": text, text: [text]})
        assert not unseen(line) and len(line.splitlines()) == 1 and line.encode()
        assert json.loads(line) == {"label": text, text: [text]}
        assert json.loads(json_text([text], indent=1)) == [text]
    with pytest.raises(ValueError, match="JSON"):
        json_text(float("nan"))


class _Page(HTMLParser):
    def __init__(self, page):
        super().__init__(convert_charrefs=True)
        self.tags, self.text = [], []
        self.feed(page)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, attributes))

    def handle_data(self, text):
        self.text.append(text)


def test_html():
    for text in ALL:
        shown = html_text(text)
        page = _Page(page_bytes(element("p", text, title=text)).decode().partition("\n")[2].removesuffix("\n"))
        assert not unseen(shown, "\n\t") and page.tags == [("p", [("title", shown)])] and "".join(page.text) == shown


def test_xml():
    for text in ALL:
        root = ElementTree.fromstring(f"<a>{xml_text(text)}</a>".encode())
        assert len(root) == 0 and (root.text or "") == "".join(
            each if each in "\t\n\r" or each >= " " and not "\ud800" <= each <= "\udfff" and each not in "\ufffe\uffff"
            else each.encode("unicode_escape").decode() for each in text)


def test_addresses_of_pages():
    for text in ALL:
        address = url_path(text)
        assert unquote_to_bytes(address) == os.fsencode(text)
        parts = urlsplit(address)
        assert (parts.scheme, parts.netloc, parts.query, parts.fragment) == ("", "", "", "") or text.startswith("//")


def test_sql():
    stored = sorted({sql_text(text) for text in ALL})
    database = sqlite3.connect(":memory:")
    database.execute("CREATE TABLE texts (text TEXT)")
    database.executemany("INSERT INTO texts VALUES (?)", [(f",{text},",) for text in stored])
    for text in stored:
        found = [row for row, in database.execute("SELECT text FROM texts WHERE text LIKE ? ESCAPE '!'",
                                                  (f",{sql_like(text)},",))] if len(text) < 10_000 else [f",{text},"]
        assert f",{text}," in found and {each.lower() for each in found} == {f",{text},".lower()}, ascii(text)
    database.close()


def test_names_of_copies_are_plain():
    for text in ALL:
        name = safe_name(text)
        assert name.isascii() and len(name) <= 60 and not set(name) & set(" \\/:*?\"'<>|\n;$`") and not name.startswith(".")


@pytest.mark.skipif(not shutil.which("gmsh"), reason="Gmsh is not installed")
def test_gmsh_reads_each_string_as_it_is_and_runs_none(tmp_path):
    held = [text for text in ALL if is_gmsh_text(text)]
    assert {"bracket 3 mm", "Größe 1", "%n%s%d%%", "'; DROP TABLE parts; --", "x" * LONGEST_GMSH} <= {*held, "x" * 1000}
    for text in set(ALL) - set(held):
        with pytest.raises(ValueError) as refusal:
            gmsh_text(text)
        assert refusal.value.args == (text,)
    refused = {name for name, text in NAMED.items() if text not in held}
    assert refused >= {"gmsh", "gmsh back", "gmsh line", "gmsh long", "gmsh long wide", "terminal", "nul", "bytes", "breaks"}
    script = tmp_path / "strings.geo"
    script.write_text("".join(f'text = {gmsh_text(each)};\nPrintf(text) >> "found";\n' for each in held), encoding="utf-8")
    subprocess.run(["gmsh", script.name, "-0", "-v", "1"], cwd=tmp_path, timeout=60, check=False)
    assert (tmp_path / "found").read_text(encoding="utf-8") == "".join(f"{each}\n" for each in held)
    assert not list(tmp_path.glob("PWNED*"))


@pytest.mark.parametrize("ending", SHELL_FORMATS)
def test_no_label_becomes_a_card_or_a_section_of_a_shell_file(ending, tmp_path):
    shell = ShellMesh(np.array([[0.0, 0, 0], [9, 0, 0], [0, 9, 0]]), np.array([[0, 1, 2]]), np.array([0]), np.array([1.0]))
    file = tmp_path / f"shell{ending}"
    write_shell(file, shell, "plain")

    def written():
        return re.sub(r" \[[0-9a-f]{16}\]$", "", file.read_bytes().decode(), count=1, flags=re.MULTILINE).splitlines()

    expected = written()
    for text in NAMED.values():
        write_shell(file, shell, text)
        lines = written()
        changed = [(line, other) for line, other in zip(lines, expected) if line != other]
        assert len(lines) == len(expected) and len(changed) <= 1, ascii(text)
        for line, _ in changed:
            assert line.removeprefix("** ").startswith("Mid-surface of ") and len(line) < 170 and not unseen(line)
        assert len(head_text(text)) <= LONGEST_HEAD
