# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences from below the window in the user's language, by Qt's own reading of the compiled translations."""

import json
import string
import sys
from pathlib import Path

import pytest

from thinpart_workbench.core.message import joined, message, restored, with_messages

TRANSLATIONS = Path(__file__).resolve().parents[2] / "resources" / "translations"
sys.path.insert(0, str(TRANSLATIONS))

import ts_file  # noqa: E402

FILES = sorted(TRANSLATIONS.glob("ThinPart_*.ts"))
BELOW = "ThinPartCore"


def _with_translator(freecad, path):
    from thinpart_workbench.gui.application.qt import QtCore

    application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
    translator = QtCore.QTranslator()
    assert translator.load(str(path.with_suffix(".qm")))
    application.installTranslator(translator)
    yield translator
    application.removeTranslator(translator)


@pytest.fixture(params=FILES, ids=lambda path: path.stem)
def language(request, freecad):
    """Each language, as a dict from text to translation of what comes from below."""
    for _ in _with_translator(freecad, request.param):
        texts = ts_file.read_ts(request.param)
        yield {text: translation for (context, text), translation in texts.items() if context == BELOW}


@pytest.fixture
def german(freecad):
    yield from _with_translator(freecad, TRANSLATIONS / "ThinPart_de.ts")


def translated(text):
    from thinpart_workbench.gui.application.sentences import translated as function

    return function(text)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_compiled_file_says_what_the_other_does(path, freecad):
    translations = ts_file.read_ts(path)
    for translator in _with_translator(freecad, path):
        read = {key: translator.translate(*key) for key in translations}
    assert read == translations, "call resources/translations/update_translations.py"


NAMES = ("bracket.step", "It holds no triangles.", "a (b)", "Plate", "{file}", "d: e")
"""What fields may say, texts that are known as such among them."""


def example(text):
    """Fields for a template: numbers where it has them in a format, else names."""
    fields = [(name, form) for _, name, form, _ in string.Formatter().parse(text) if name]
    return {name: 12345 if form else NAMES[place % len(NAMES)] for place, (name, form) in enumerate(fields)}


def test_every_sentence_is_said_whatever_its_fields_say(language):
    assert len(language) > 150
    for text, translation in language.items():
        fields = example(text)
        said = translated(message(text, **fields))
        assert said == translation.format(**fields) and type(said) is str, text


def test_in_english_everything_stays(freecad):
    for text in ("It holds no triangles.", message("{file} is empty (0 bytes).", file="plate.step"), ""):
        assert translated(text) == text


def test_an_error_is_said_in_german(german):
    from thinpart_workbench.core.errors import ThinPartError
    from thinpart_workbench.core.judging.conditions import search_conditions

    with pytest.raises(ThinPartError) as caught:
        search_conditions("D2/D3 > six")
    assert translated(caught.value) == "'six' in der Bedingung 'D2/D3 > six' ist keine Zahl."


NOT_AN_INFO_FILE = message("{info_file} is not a ThinPart info file.", info_file="x.thinpart.json")


@pytest.mark.parametrize("said, german_text", [
    # several
    (joined([message("The surface is open ({edges} free edges), so it has no certain volume.", edges=4),
             message("{count} duplicate triangles were left out.", count=3)]),
     "Die Oberfläche ist offen (4 freie Kanten), daher ist das Volumen nicht sicher. 3 doppelte Dreiecke "
     "wurden weggelassen."),
    # one in a field of another
    (message("{sentence} It was not changed: move it away to have a new one written.", sentence=NOT_AN_INFO_FILE),
     "x.thinpart.json ist keine Infodatei von ThinPart. Sie blieb unverändert: Verschieben Sie sie, damit sie "
     "neu geschrieben wird."),
    (message("{profile} is not well formed: {problem}.", profile=message("the profile"),
             problem=ValueError(message("{first} and {second} exclude each other", first="V > 2", second="V < 1"))),
     "Das Profil ist nicht wohlgeformt: V > 2 und V < 1 schließen sich aus."),
    # what it is about, before it
    (message("{about}: {sentence}", about="Block: a", sentence=message("Its surface encloses no volume.")),
     "Block: a: Die Oberfläche umschließt kein Volumen."),
    # one that was told by another process
    (restored(json.loads(json.dumps(with_messages({"failure": NOT_AN_INFO_FILE}))))["failure"],
     "x.thinpart.json ist keine Infodatei von ThinPart."),
    # a title
    ("Plate", "Platte"),
    # names that read like texts
    (message("'{object}' is a closed shell but not a solid: convert it to a solid first.", object="Plate"),
     "„Plate“ ist eine geschlossene Schale, aber kein Volumenkörper: Wandeln Sie sie zuerst in einen "
     "Volumenkörper um."),
    (message("'{object}' has an empty shape: recompute the document or delete it.", object="same fill"),
     "„same fill“ hat eine leere Form: Berechnen Sie das Dokument neu oder löschen Sie das Objekt."),
])
def test_what_is_known_is_said_in_german(german, said, german_text):
    assert translated(said) == german_text


@pytest.mark.parametrize("text", [
    "Thick enough for casting", "Some other program says so.", "A: b.", "", "{}", "{} is too large.",
    "It holds no triangles", "Already in German: „Platte“.", "plate.step is empty (0 bytes).",
    message("{file} was made by another program.", file="a.step"), message("{file}", file="It holds no triangles."),
])
def test_what_is_not_known_stays(german, text):
    assert translated(text) == text


def test_reasons_are_translated_one_by_one(german):
    from thinpart_workbench.gui.application.sentences import translated_list

    assert translated_list("same fill, longer box, of my own") == (
        "gleiche Füllung, längerer Quader, of my own")
    assert translated_list("") == ""


def test_another_language_is_not_mixed_with_the_last_one(freecad):
    sentence = message("{file} is empty (0 bytes).", file="plate.step")
    said = [translated(sentence)]
    for path in FILES:
        for _ in _with_translator(freecad, path):
            said.append(translated(sentence))
    assert [*said, translated(sentence)] == [
        sentence, "plate.step ist leer (0 Byte).", "plate.step est vide (0 octet).", sentence]
