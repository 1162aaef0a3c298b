# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people store with a part is printed in a few lines, searched whatever its bytes, and commands no terminal."""

import csv
import json
import os
import unicodedata
from html.parser import HTMLParser

import pytest
from hostile_texts import NAMED
from program import thinpart

NOTE = "begin " + "note " * 24_000 + "end"


def obeyed(text):
    """Characters of a text that a terminal would obey."""
    return {each for each in text if unicodedata.category(each) in ("Cc", "Cf", "Cs") and each not in "\r\n\t"}


def test_a_long_note_takes_a_few_lines_of_a_table_and_is_kept_whole(library):
    assert thinpart("note", library / "plate.step", "--set", NOTE).returncode == 0
    for run in (thinpart("find", library), thinpart("similar", library / "plate.step", library)):
        assert run.returncode == 0 and len(run.stdout.splitlines()) < 20
    found = thinpart("find", library)
    assert "begin note" in "".join(found.stdout.split("\n")) and "..." in found.stdout
    assert json.loads(thinpart("find", library, "--json").stdout)["notes"] == NOTE


@pytest.mark.parametrize("option", [("--text", "\udce9"), ("--category", "\udcff"), ("--criterion", "\udcff%"),
                                    ("--said", "\udcff")], ids=lambda option: option[0])
def test_words_that_are_not_text_are_searched(library, option):
    run = thinpart("find", library, *option)
    sentence = "There is no category \\udcff in these folders: their parts are thin." if option[0] == "--category" else (
        "No stored part fulfils all these conditions.")
    assert (run.returncode, run.stdout, run.stderr) == (0, "", f"{sentence}\n")


def test_a_category_that_nobody_uses_is_told_from_one_without_parts(library):
    run = thinpart("find", library, "--category", "thin_feature,normal")
    assert run.stderr == "There is no category thin_feature in these folders: their parts are thin.\n"
    assert thinpart("find", library, "--category", "normal").stderr == "No stored part fulfils all these conditions.\n"


def test_libraries_without_results_are_told_from_searches_without_any(library, tmp_path):
    empty = tmp_path / "empty"
    empty.mkdir()
    for run in (thinpart("find", empty), thinpart("similar", library / "plate.step", empty)):
        assert run.stdout == "" and run.stderr.startswith("There are no results below these folders: 'thinpart classify")


def test_a_sign_of_patterns_is_no_pattern(library):
    line = json.loads(thinpart("find", library, "--json").stdout)
    criterion = str(line["criteria"][0])
    assert json.loads(thinpart("find", library, "--json", "--criterion", criterion).stdout) == line
    for sign in ("%", "_", f"%{criterion}", f"{criterion[:-1]}_"):
        assert thinpart("find", library, "--json", "--criterion", sign).stdout == ""


def test_no_output_has_what_a_terminal_obeys(library):
    name = os.fsdecode(b"caf\xe9") + "\x1b[2J\x9b\u202e.step"
    part = library / name
    os.rename(library / "plate.step", part)
    os.rename(library / "plate.step.thinpart.json", library / f"{name}.thinpart.json")
    note = NAMED["terminal"] + NAMED["direction"] + NAMED["html"]
    table, labels = library / "table.csv", library / "labels.csv"
    runs = [
        thinpart("note", part, "--set", note, "--label", "thin"), thinpart("note", part, "--json"),
        thinpart("classify", library, "--csv", table), thinpart("classify", library, "--json", "--no-info"),
        thinpart("find", library, "--json"), thinpart("learn", library, "--export-labels", labels),
        thinpart("size", part), thinpart("classify", library / "none\x1b[2J.step"), thinpart("find", "--x\x1b[2J", library)]
    for run in runs:
        assert not obeyed(run.stdout + run.stderr), run.args
    assert json.loads(runs[1].stdout)["notes"] == note == json.loads(runs[4].stdout)["notes"]
    shown = r"caf\udce9\x1b[2J\x9b\u202e.step"
    for file in (table, labels):
        text = file.read_text(encoding="utf-8")
        assert not obeyed(text) and shown in {row["file"] for row in csv.DictReader(text.splitlines())}
    # Labels are found again under the name that the table shows.
    again = thinpart("learn", library, "--labels", labels, "--no-kept-labels", "--export-labels", library / "again.csv")
    assert again.returncode == 0, again.stderr
    assert (library / "again.csv").read_text(encoding="utf-8") == labels.read_text(encoding="utf-8")


class _Head(HTMLParser):
    """The title of a page, and the tags that a page of ThinPart has no reason to have."""

    def __init__(self, page):
        super().__init__(convert_charrefs=True)
        self.title, self.strange, self._is_title = None, [], False
        self.feed(page)

    def handle_starttag(self, tag, attributes):
        self._is_title = tag == "title" and self.title is None  # pictures have titles too
        names = {name for name, _ in attributes}
        if tag in ("script", "iframe") or any(name.startswith("on") for name in names):
            self.strange.append((tag, attributes))

    def handle_endtag(self, tag):
        self._is_title = False

    def handle_data(self, text):
        if self._is_title:
            self.title = (self.title or "") + text


def test_a_page_has_a_short_title_and_no_tags_of_others(library, tmp_path):
    name = "<img src=x onerror=alert(1)>\x1b[2J" + "long" * 50
    os.rename(library / "plate.step", library / f"{name}.step")
    os.remove(library / "plate.step.thinpart.json")
    run = thinpart("report", library, "-o", tmp_path / "report")
    assert run.returncode == 0, run.stderr
    page, = (each for each in (tmp_path / "report").rglob("*.html") if each.name != "index.html")
    head = _Head(page.read_text(encoding="utf-8"))
    assert head.title.startswith(r"<img src=x onerror=alert(1)>\x1b[2Jlong") and "... - wall thickness" in head.title
    assert len(head.title) <= 80 + len(" - wall thickness") and head.strange == []
