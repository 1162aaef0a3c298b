# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of the window is translated, whole, into every language, and none escapes translation."""

import ast
import json
import re
import string
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
TRANSLATIONS = ROOT / "resources" / "translations"
sys.path.insert(0, str(TRANSLATIONS))

import texts_of_code  # noqa: E402
import ts_file  # noqa: E402
import update_translations  # noqa: E402

GUI = sorted((ROOT / "thinpart_workbench" / "gui").rglob("*.py"))
BELOW = [path for layer in ("core", "storage", "freecad_adapter", "workflow", "api", "window_processes")
         for path in sorted((ROOT / "thinpart_workbench" / layer).rglob("*.py"))]
FILES = sorted(TRANSLATIONS.glob("ThinPart_*.ts"))
CALL = "call resources/translations/update_translations.py and translate what it lists"


@pytest.fixture(params=FILES, ids=lambda path: path.stem)
def translations(request):
    return ts_file.read_ts(request.param)


def test_there_are_german_and_french():
    assert [path.name for path in FILES] == ["ThinPart_de.ts", "ThinPart_fr.ts"]


def test_every_text_is_translated_and_no_other(translations):
    assert set(translations) == set(texts_of_code.all_texts()), CALL
    assert [key for key, translation in translations.items() if not translation] == [], CALL


def test_messages_tables_and_profiles_are_among_the_texts():
    below = {text for context, text in texts_of_code.all_texts() if context == texts_of_code.BELOW}
    assert {"{file} is empty (0 bytes).", "Volume of the part", "the memory limit was reached", "same fill",
            "Plate"} <= below


def fields(text):
    """Fields with their numbers and formats, and how %-fields look."""
    found, number = [], 0
    for _, name, form, conversion in string.Formatter().parse(text):
        if name is not None:
            found.append((name or str(number), form, conversion))
            number += 1
    return sorted(found), sorted(re.findall(r"%[\d(]*[a-z)]", text))


def test_translations_have_the_same_fields(translations):
    for (_, text), translation in translations.items():
        assert fields(translation) == fields(text), translation


def test_translations_start_and_end_alike(translations):
    for (_, text), translation in translations.items():
        assert re.match(r"\s*", translation).group() == re.match(r"\s*", text).group(), translation
        assert re.search(r"\s*$", translation).group() == re.search(r"\s*$", text).group(), translation
        for end in ("\u2026", ".", "?", ":"):
            assert translation.strip().endswith(end) == text.strip().endswith(end), translation
        assert text.count("\n") == translation.count("\n"), translation


def mnemonics(text):
    return re.findall(r"&(\w)", text.replace("&&", ""))


def test_translations_have_a_letter_to_press_where_the_text_has(translations):
    for (_, text), translation in translations.items():
        assert len(mnemonics(translation)) == len(mnemonics(text)), translation


def test_lines_of_one_form_are_pressed_by_different_letters(translations):
    """Those of the window for folders, which are all seen at once."""
    names = ("form.py", "dialog.py", "results_panel.py")
    texts = {ast.literal_eval(call.args[1]) for name in names
             for call in texts_of_code.calls(texts_of_code.tree_of(ROOT / "thinpart_workbench/gui/folder" / name))}
    # One button, which says one or the other.
    letters = [letter.lower() for text in texts - {"Resu&me"}
               for letter in mnemonics(translations["ThinPart", text])]
    assert len(letters) > 10 and len(letters) == len(set(letters))


NO_TEXTS = {
    "D2/D3 > 6 and F[0;0.05] >= 0.5",  # what a condition looks like
    "Unable to allocate",  # what others say
    "go on",
    '<span style="color: #{:02x}{:02x}{:02x}">\u25a0</span>&nbsp;{}',  # mark-up
    "User parameter:BaseApp/Preferences/Units",  # where FreeCAD keeps its own
    r"\s|File \"|Traceback|(Current t|T)hread\b|Extension modules:|\.\.\.$|<",  # Python's traces
    "Facets and edges",  # what documents keep of how a map is shown
}
"""What looks like a text in the window's modules and is none."""

STYLE_SHEET = re.compile(r"\{ [a-z-]+: .*; \}")


@pytest.mark.parametrize("path", GUI, ids=lambda path: path.stem)
def test_all_that_looks_like_a_text_is_translated(path):
    texts = texts_of_code.prose(texts_of_code.tree_of(path))
    assert {each for each in texts if not STYLE_SHEET.search(each)} <= NO_TEXTS


SHOWING = {
    "QLabel", "QPushButton", "QToolButton", "QCheckBox", "QRadioButton", "QGroupBox", "QAction", "QMessageBox",
    "setText", "setTitle", "setToolTip", "setStatusTip", "setWhatsThis", "setWindowTitle", "setPlaceholderText",
    "setPrefix", "setSuffix", "setSpecialValueText", "setHeaderLabels", "setHorizontalHeaderLabels",
    "setInformativeText", "setTabText", "setTabToolTip", "addAction", "addMenu", "addTab", "addItem", "addItems",
    "addRow", "showMessage", "openTransaction", "information", "warning", "critical", "question",
}
SYMBOLS = {"V/VBB", "D2/D3 > 6 and F[0;0.05] >= 0.5"}


@pytest.mark.parametrize("path", GUI, ids=lambda path: path.stem)
def test_what_is_handed_to_qt_to_be_shown_is_translated(path):
    for call in ast.walk(texts_of_code.tree_of(path)):
        if isinstance(call, ast.Call) and _name(call) in SHOWING:
            literals = [each.value for argument in call.args for each in _outside_calls(argument)]
            assert {each for each in literals if re.search("[A-Za-z]{2}", each)} <= SYMBOLS, call.lineno


def _name(call):
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


def _outside_calls(node):
    """Literals of an expression that no function gets."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node
    elif not isinstance(node, (ast.Call, ast.Subscript, ast.Lambda)):
        for each in ast.iter_child_nodes(node):
            yield from _outside_calls(each)


@pytest.mark.parametrize("path", GUI, ids=lambda path: path.stem)
def test_sentences_of_errors_are_shown_translated(path):
    for handler in ast.walk(texts_of_code.tree_of(path)):
        if isinstance(handler, ast.ExceptHandler) and handler.name and (
                "ThinPartError" in ast.dump(handler.type)):
            good = {each for call in ast.walk(handler) if isinstance(call, ast.Call)
                    and _name(call) == "translated" for each in ast.walk(call)}
            good |= {each.value for each in ast.walk(handler) if isinstance(each, ast.Attribute)}
            used = {each for each in ast.walk(handler)
                    if isinstance(each, ast.Name) and each.id == handler.name}
            assert used <= good, f"line {handler.lineno}: translated({handler.name})"


@pytest.mark.parametrize("path", BELOW, ids=lambda path: path.stem)
def test_sentences_are_not_put_together_from_pieces(path):
    for node in ast.walk(texts_of_code.tree_of(path)):
        if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Mod)):
            for side in (node.left, node.right):
                if isinstance(side, (ast.Constant, ast.JoinedStr)):
                    assert not texts_of_code.prose(ast.Module([ast.Return(side)], [])), node.lineno


@pytest.fixture
def copied(tmp_path, monkeypatch):
    """Files of translations that a test may change."""
    for path in FILES:
        (tmp_path / path.name).write_bytes(path.read_bytes())
    monkeypatch.setattr(update_translations, "HERE", tmp_path)
    return tmp_path


def test_the_template_has_every_text_and_no_translation(copied):
    update_translations.main()
    path = TRANSLATIONS / "ThinPart.ts"
    assert path.read_bytes() == (copied / path.name).read_bytes(), CALL
    assert ts_file.read_ts(path) == dict.fromkeys(texts_of_code.all_texts(), "")
    assert " language=" not in path.read_text(encoding="utf-8").partition(">\n<context")[0]


def test_the_files_are_as_the_command_writes_them(copied):
    update_translations.main()
    for path in FILES:
        assert (copied / path.name).read_bytes() == path.read_bytes()


def test_what_is_said_outside_of_the_window_is_written_for_programs_without_qt(copied):
    update_translations.main()
    for path in FILES:
        name = f"sentences_{path.stem.partition('_')[2]}.json"
        written = (copied / name).read_text(encoding="utf-8")
        assert (TRANSLATIONS / name).read_text(encoding="utf-8") == written, CALL
        assert json.loads(written) == {text: translation for (context, text), translation in ts_file.read_ts(path).items()
                                       if context == texts_of_code.BELOW}


def test_texts_of_report_pages_are_among_the_texts():
    # That nothing else is written there is checked in test_messages.
    assert {"Where it is thin", "Wall thickness of {count} parts", "thin below {limit}"} <= set(texts_of_code.report_texts())


def test_what_is_translated_is_kept_and_what_is_gone_is_dropped(copied, capsys):
    path = copied / "ThinPart_de.ts"
    before = ts_file.read_ts(path)
    missing = "ThinPart", "Which part do you mean?"
    ts_file.write_ts(path, "de", {**before, missing: "", ("ThinPart", "Once upon a time"): "Es war einmal"})
    assert update_translations.main() == 1
    assert "'Which part do you mean?'" in capsys.readouterr().out
    assert ts_file.read_ts(path) == {**before, missing: ""}


def test_a_new_language_is_an_empty_file(copied):
    (copied / "ThinPart_eo.ts").touch()
    assert update_translations.main() == 1
    assert set(ts_file.read_ts(copied / "ThinPart_eo.ts").values()) == {""}


def test_without_a_compiler_it_says_what_to_install(copied, monkeypatch, capsys):
    monkeypatch.setattr(ts_file, "COMPILERS", ("no-such-program",))
    assert update_translations.main() == 1
    assert "apt-get install qttools5-dev-tools" in capsys.readouterr().out
    assert not list(copied.glob("*.qm"))


@pytest.mark.parametrize("code, found", [
    ('translate("ThinPart", "Now")', {("ThinPart", "Now")}),
    ('translate("ThinPart", "Now" if here else "Then")', {("ThinPart", "Now"), ("ThinPart", "Then")}),
    ('QT_TRANSLATE_NOOP("ThinPart_Do", "Do")', {("ThinPart_Do", "Do")}),
    ('translate("ThinPart", title)', set()),
])
def test_marked_texts_are_collected(code, found, monkeypatch, tmp_path):
    (tmp_path / "InitGui.py").write_text(code)
    monkeypatch.setattr(texts_of_code, "ROOT", tmp_path)
    monkeypatch.setattr(texts_of_code, "PACKAGE", tmp_path / "none")
    assert set(texts_of_code.marked_texts()) == found


@pytest.mark.parametrize("code", ['translate("ThinPart", f"{x} parts")', 'translate("ThinPart", "a" + x)'])
def test_a_text_with_its_fields_filled_in_cannot_be_translated(code, monkeypatch, tmp_path):
    (tmp_path / "InitGui.py").write_text(code)
    monkeypatch.setattr(texts_of_code, "ROOT", tmp_path)
    monkeypatch.setattr(texts_of_code, "PACKAGE", tmp_path / "none")
    with pytest.raises(ValueError, match="InitGui.py, line 1"):
        list(texts_of_code.marked_texts())


def test_forms_are_read(monkeypatch, tmp_path):
    (tmp_path / "resources").mkdir()
    (tmp_path / "resources" / "page.ui").write_text(
        "<ui><class>Page</class><widget><property><string>Memory</string></property>"
        '<property><string notr="true">paper</string></property></widget></ui>')
    monkeypatch.setattr(texts_of_code, "ROOT", tmp_path)
    assert list(texts_of_code.form_texts()) == [("Page", "Memory")]
