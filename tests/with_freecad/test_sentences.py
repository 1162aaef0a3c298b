"""Sentences from below the window in the user's language, by Qt's own reading of the compiled translations."""

import sys
from pathlib import Path

import pytest

TRANSLATIONS = Path(__file__).resolve().parents[2] / "resources" / "translations"
sys.path.insert(0, str(TRANSLATIONS))

import ts_file  # noqa: E402

FILES = sorted(TRANSLATIONS.glob("ThinPart_*.ts"))
BELOW = "ThinPartCore"


def _with_translator(freecad, path):
    from thinpart_workbench.gui.qt import QtCore

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
    from thinpart_workbench.gui.sentences import translated as function

    return function(text)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_compiled_file_says_what_the_other_does(path, freecad):
    translations = ts_file.read_ts(path)
    for translator in _with_translator(freecad, path):
        read = {key: translator.translate(*key) for key in translations}
    assert read == translations, "call resources/translations/update_translations.py"


def test_every_sentence_is_found_again_whatever_its_fields_say(language):
    assert len(language) > 150
    for text, translation in language.items():
        names = [f"{name}-{number}" for number, name in enumerate(["bracket.step", "12.5", "a (b)", "d: e"] * 3)]
        names = names[:text.count("{}")]
        assert translated(text.format(*names)) == translation.format(*names), text


def test_in_english_everything_stays(freecad):
    for text in ("It holds no triangles.", "plate.step is empty (0 bytes).", ""):
        assert translated(text) == text


def test_an_error_is_said_in_german(german):
    from thinpart_workbench.core.conditions import search_conditions
    from thinpart_workbench.core.errors import ThinPartError

    with pytest.raises(ThinPartError) as caught:
        search_conditions("D2/D3 > six")
    assert translated(caught.value) == "'six' in der Bedingung 'D2/D3 > six' ist keine Zahl."


@pytest.mark.parametrize("text, german_text", [
    # several, of which one starts with a field
    ("The surface is open (4 free edges), so it has no certain volume. 3 duplicate triangles were left out.",
     "Die Oberfläche ist offen (4 freie Kanten), daher ist das Volumen nicht sicher. 3 doppelte Dreiecke "
     "wurden weggelassen."),
    # one in a field of another
    ("x.thinpart.json is not a ThinPart info file. It was left as it is: move it away to have it written anew.",
     "x.thinpart.json ist keine Infodatei von ThinPart. Sie blieb unverändert: Verschieben Sie sie, damit sie "
     "neu geschrieben wird."),
    ("the profile is not well formed: a threshold must be finite.",
     "Das Profil ist nicht wohlgeformt: ein Schwellenwert muss endlich sein."),
    # what it is about, before it
    ("Block: a: Its surface encloses no volume.", "Block: a: Die Oberfläche umschließt kein Volumen."),
    # the more exact of two that fit
    ("The info file x cannot be read (no).", "Die Infodatei x kann nicht gelesen werden (no)."),
    # a title
    ("Plate", "Platte"),
    # names that read like texts
    ("'Plate' is a closed shell but no solid: convert it to a solid first.",
     "„Plate“ ist eine geschlossene Schale, aber kein Volumenkörper: Wandeln Sie sie zuerst in einen "
     "Volumenkörper um."),
    ("'same fill' has an empty shape: recompute the document or delete it.",
     "„same fill“ hat eine leere Form: Berechnen Sie das Dokument neu oder löschen Sie das Objekt."),
])
def test_what_is_known_is_said_in_german(german, text, german_text):
    assert translated(text) == german_text


@pytest.mark.parametrize("text", [
    "Thick enough for casting", "Some other program says so.", "A: b.", "", "{}", "{} is too large.",
    "It holds no triangles", "Already in German: „Platte“.",
])
def test_what_is_not_known_stays(german, text):
    assert translated(text) == text


def test_reasons_are_translated_one_by_one(german):
    from thinpart_workbench.gui.sentences import translated_list

    assert translated_list("same fill, longer box, of my own") == (
        "gleiche Füllung, längerer Quader, of my own")
    assert translated_list("") == ""


def test_another_language_is_not_mixed_with_the_last_one(freecad):
    sentence = "plate.step is empty (0 bytes)."
    said = [translated(sentence)]
    for path in FILES:
        for _ in _with_translator(freecad, path):
            said.append(translated(sentence))
    assert [*said, translated(sentence)] == [
        sentence, "plate.step ist leer (0 Byte).", "plate.step est vide (0 octet).", sentence]
