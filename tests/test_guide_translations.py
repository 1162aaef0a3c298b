# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guide in other languages: each page follows its English one, is built like it, and uses the words of the window."""

import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

from thinpart_workbench.gui.guide import pages
from thinpart_workbench.gui.guide.pages import CONTENTS, ENGLISH, PAGE_OF, heading_anchor, headings, languages, page_in

ROOT = Path(__file__).resolve().parents[1]
GUIDE = ROOT / "docs" / "guide"
TRANSLATIONS = ROOT / "resources" / "translations"
sys.path.insert(0, str(TRANSLATIONS))

import ts_file  # noqa: E402
import update_guide  # noqa: E402

PAGES = update_guide.translated_pages()
COMPLETE = ("de", "fr")
EACH_PAGE = pytest.mark.parametrize("page", PAGES, ids=lambda page: f"{page.parent.name}/{page.stem}")


def text(page):
    """A page, without the line that says which text it translates."""
    return re.sub(r"\A<!--.*-->\n", "", page.read_text(encoding="utf-8"))


def both(page):
    """The English text of a page and its own."""
    return text(update_guide.english_of(page)), text(page)


@EACH_PAGE
def test_a_page_translates_the_english_page_as_it_is_now(page):
    assert update_guide.lag(page) == ""


def test_all_pages_are_there_in_the_languages_of_the_window():
    english = {page.name for page in GUIDE.glob("*.md")}
    assert set(COMPLETE) == {path.stem.partition("_")[2] for path in TRANSLATIONS.glob("ThinPart_*.ts")}
    for language in COMPLETE:
        assert {page.name for page in PAGES if page.parent.name == language} == english, f"docs/guide/{language}"


# -- built alike

def outline(content):
    """Levels of headings, numbers of items, and the kinds of the other lines that are not plain text, in their order; of
    a row of a table, the lines between its cells too."""
    starts = re.findall(r"^(#+ |\d+\. |- | *\./thinpart| *!\[|\|.*)", content, re.MULTILINE)
    return [re.sub(r"[^|]", "", start) or start for start in starts]


def code(content):
    """Lines of commands, in their order, and what is marked as code within the text."""
    commands = [line for line in content.splitlines() if line.startswith("    ") and line.strip().startswith("./")]
    return commands, Counter(re.findall(r"`([^`]+)`", content))


def links(page, content):
    """Targets of links and pictures, as what of the repository they name, in whatever language; anchors of pages of the
    guide as the number of the heading."""
    found = []
    for picture, target in re.findall(r"(!?)\[[^\]]*\]\(([^)]+)\)", content):
        name, _, anchor = target.partition("#")
        if name.startswith("https://"):
            found.append((picture, target))
            continue
        file = (page.parent / name).resolve()
        assert file.is_file(), f"{page}: {target}"
        anchors = [heading_anchor(each) for each in headings(text(file))] if file.suffix == ".md" else []
        assert not anchor or anchor in anchors, f"{page}: there is no heading {anchor} in {file.name}"
        inside = file.is_relative_to(GUIDE)
        found.append((picture, file.name if inside else file, anchors.index(anchor) if inside and anchor else anchor))
    return Counter(found)


@EACH_PAGE
def test_a_page_has_the_headings_lists_tables_and_commands_of_the_english_one(page):
    english, translated = both(page)
    assert outline(translated) == outline(english)
    assert code(translated) == code(english)


@EACH_PAGE
def test_a_page_has_the_links_and_pictures_of_the_english_one(page):
    english, translated = both(page)
    assert links(page, translated) == links(update_guide.english_of(page), english)


@EACH_PAGE
def test_links_stay_within_the_language_where_it_has_the_page(page):
    for label, name in re.findall(r"\[([^\]]*)\]\(([^)#]*\.md)", text(page)):
        target = (page.parent / name).resolve()
        if target.parent == GUIDE and label != "English":
            assert not (page.parent / target.name).is_file(), f"{page}: link {target.name}, not {name}"


# -- the words of the window

def plain(words):
    """A text of the window as the guide names it: without the letter to press, or what ends it."""
    return re.sub(r"&(?=\w)", "", words.replace("\xa0", " ")).strip().rstrip("\u2026:.").strip()


def window_texts(language):
    """What the window calls its texts: dict of set of str."""
    found = {}
    for (_, english), translation in ts_file.read_ts(TRANSLATIONS / f"ThinPart_{language}.ts").items():
        found.setdefault(plain(english), set()).add(plain(translation))
    return found


TEXTS = {language: window_texts(language) for language in languages()[1:]}


def emphasised(content):
    """What is bold or italic, in one line each: list of str."""
    content = re.sub(r"`[^`]*`", "", content)
    found = re.findall(r"\*\*([^*]+)\*\*|\*([^*\s][^*]*)\*", content)
    return [plain(" ".join((bold or italic).split())) for bold, italic in found]


def cells(content):
    """What stands in tables, but for their heads."""
    rows = re.findall(r"^\|(?! ---)(.*)\|$", content, re.MULTILINE)
    return [plain(cell.strip(" *")) for row in rows for cell in row.split("|")]


@EACH_PAGE
def test_buttons_panels_and_columns_are_called_as_in_the_window(page):
    texts = TEXTS[page.parent.name]
    english, translated = both(page)
    for parts in (emphasised, cells):
        assert len(parts(translated)) == len(parts(english))
        there = Counter(parts(translated))
        for name in filter(texts.get, parts(english)):
            called = next((each for each in texts[name] if there[each]), None)
            assert called, f"{page}: '{name}' is {sorted(texts[name])} in the window"
            there[called] -= 1


def fragments(cell):
    """The pieces of a message that a row of a table quotes."""
    return [each.strip(" ()*").lower() for each in re.split(r"\u2026|, | \(", cell) if len(each) > 14]


def quoted(content):
    """The messages that the table of a page explains, row by row."""
    return re.findall(r"^\| (.*?) \| .* \|$", content.replace("\xa0", " "), re.MULTILINE)[2:]


MESSAGES = [page for page in PAGES if page.stem in ("troubleshooting", "prepare-a-mesh")]


@pytest.mark.parametrize("page", MESSAGES, ids=lambda page: f"{page.parent.name}/{page.stem}")
def test_messages_are_quoted_as_they_are_said(page):
    said = {key[1].lower(): plain(translation).lower() for key, translation in
            ts_file.read_ts(TRANSLATIONS / f"ThinPart_{page.parent.name}.ts").items()}
    found = 0
    for pieces, translated in zip(*(map(fragments, quoted(content)) for content in both(page))):
        sentences = [said[sentence] for sentence in said if pieces and all(piece in sentence for piece in pieces)]
        found += bool(sentences)
        assert not sentences or any(all(piece in each for piece in translated) for each in sentences), (
            f"{page}: {translated} is in none of {sentences}")
    assert found > 3 or not said


# -- which page the window shows

def test_a_command_has_its_page_and_heading_in_each_language():
    assert languages()[0] == ENGLISH
    for language in COMPLETE:
        for name, page in PAGE_OF.items():
            file, anchor = page_in(language, page)
            assert file == GUIDE / language / page.partition("#")[0], name
            assert bool(anchor) == ("#" in page), name
            assert not anchor or anchor in map(heading_anchor, headings(text(file))), name
    file, anchor = page_in("de", PAGE_OF["ThinPart_Report"])
    assert anchor == "eine-seite-zum-weitergeben"
    assert page_in(ENGLISH, PAGE_OF["ThinPart_Report"]) == (GUIDE / file.name, "a-page-to-hand-on")


def test_a_page_that_a_language_does_not_have_is_shown_in_english(tmp_path, monkeypatch):
    for name, content in ((CONTENTS, "# Guide\n"), ("keys.md", "# Keys\n\n## Panels\n"), ("pt/keys.md", "# Teclas\n")):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(content, encoding="utf-8")
    monkeypatch.setattr(pages, "FOLDER", tmp_path)
    assert languages() == [ENGLISH, "pt"]
    assert page_in("pt", "keys.md") == (tmp_path / "pt" / "keys.md", "")
    assert page_in("pt", "keys.md#panels") == (tmp_path / "pt" / "keys.md", "")  # a heading that it does not have yet
    assert page_in("pt", CONTENTS + "#guide") == (tmp_path / CONTENTS, "guide")


# -- how a page is kept up

def test_a_changed_english_page_is_named_with_what_to_do_and_one_command_settles_it(tmp_path, monkeypatch, capsys):
    english, page = tmp_path / "docs" / "guide" / "keys.md", tmp_path / "docs" / "guide" / "de" / "keys.md"
    page.parent.mkdir(parents=True)
    english.write_text("# Keys\n", encoding="utf-8")
    page.write_text("# Tasten\n", encoding="utf-8")
    monkeypatch.setattr(update_guide, "ROOT", tmp_path)
    monkeypatch.setattr(update_guide, "GUIDE", tmp_path / "docs" / "guide")
    assert update_guide.main([]) == 1 and "compare it with docs/guide/keys.md, translate that" in capsys.readouterr().out
    assert update_guide.main([str(page)]) == 0 and page.read_text(encoding="utf-8").endswith(" -->\n# Tasten\n")
    before = update_guide.translated_id(page)
    english.write_text("# Keyboard\n", encoding="utf-8")
    assert update_guide.main([]) == 1
    assert capsys.readouterr().out.splitlines()[-1] == (
        f"docs/guide/de/keys.md lags behind the English page: see what has changed with 'git diff {before} "
        "docs/guide/keys.md', translate that, then run '/usr/bin/python3 resources/translations/update_guide.py "
        "docs/guide/de/keys.md'.")
    assert update_guide.main([str(page)]) == 0 and page.read_text(encoding="utf-8").count("<!--") == 1
    english.unlink()
    assert update_guide.main([]) == 1 and "has no English page" in capsys.readouterr().out
    assert update_guide.main([str(english)]) == 1 and "no translated page" in capsys.readouterr().err


def test_the_ids_are_those_of_git():
    for page in (GUIDE / CONTENTS, *PAGES[:2]):
        content = page.read_bytes().replace(b"\r\n", b"\n")
        run = subprocess.run(["git", "hash-object", "--stdin"], input=content, capture_output=True)
        assert run.stdout.decode().startswith(update_guide.content_id(page))
