# SPDX-License-Identifier: LGPL-2.1-or-later
"""The languages of report pages: what is translated, how numbers look, and that fields are escaped in all of them."""

from dataclasses import replace

import pytest

from thinpart_workbench.core.figures import Length, Share
from thinpart_workbench.core.length_unit import INCH, MILLIMETRE
from thinpart_workbench.core.message import message
from thinpart_workbench.workflow.report.overview_page import overview_page
from thinpart_workbench.workflow.report.page_language import LANGUAGES, page_language


def test_the_languages_are_those_of_the_window():
    assert LANGUAGES == ("en", "de", "fr")


@pytest.mark.parametrize("code, text", [("en", "Median wall"), ("de", "Mediane Wand"), ("fr", "Paroi m\u00e9diane")])
def test_texts_are_looked_up_and_unknown_ones_stay(code, text):
    language = page_language(code)
    assert language.text("Median wall") == text
    assert language.text("My own title") == language.sentence("My own title") == "My own title"


def test_sentences_are_translated_with_those_within_them_and_have_the_decimal_mark():
    said = message("Solid: only {share} of the surface lies over walls thinner than {limit}, {part} of the width of "
                   "{middle}: mesh it with solids.", share=Share(0.005), limit=Length(1.25), part=Share(0.15),
                   middle=Length(40.0))
    assert page_language("en").sentence(said).replace("\u00a0mm", " mm") == said
    german = page_language("de").sentence(said)
    assert german != said and "1,25" in german and "0,5\u00a0%" in german and "1.25" not in german
    for name in ("bracket_1.25.step", "lid 3.5 mm.step"):
        inner = message("{first} {next}", first=said, next=name)
        assert page_language("de").sentence(inner) == f"{german} {name}"
        assert page_language("de", INCH).sentence(inner).endswith(f" {name}")


@pytest.mark.parametrize("code, shown", [
    ("en", ("1.25", "6.8\u00a0%", "0.15", "128\u202f035", "\u2013")),
    ("fr", ("1,25", "6,8\u00a0%", "0,15", "128\u202f035", "\u2013"))])
def test_numbers(code, shown):
    language = page_language(code)
    assert shown == (language.number(1.25), language.percent(0.068), language.length.bound_number(0.15),
                     language.large(128035.2), language.number(None))


@pytest.mark.parametrize("code, limit, middle", [
    ("en", "0.0492\u00a0in", "1.57\u00a0in"),
    ("de", "0,0492\u00a0in", "1,57\u00a0in"),
    ("fr", "0,0492\u00a0in", "1,57\u00a0in")])
def test_lengths_in_sentences_are_in_the_unit_with_the_decimal_mark_of_the_language(code, limit, middle):
    said = message("Solid: no wall is thinner than {limit}, {part} of the width of {middle}: mesh it with solids.",
                   limit=Length(1.25), part=Share(0.031), middle=Length(40.0))
    shown = page_language(code, INCH).sentence(said)
    assert limit in shown and middle in shown and "mm" not in shown
    assert ("3.1\u00a0%" if code == "en" else "3,1\u00a0%") in shown
    # The mark of whoever asks, as of the window, is not that of the page.
    assert page_language(code, replace(INCH, decimal_mark=",")).sentence(said) == shown


@pytest.mark.parametrize("code", LANGUAGES)
def test_fields_of_texts_are_escaped(code):
    hostile = "<script>\x1b[31m{0.__class__}</script>"
    page = overview_page(code, MILLIMETRE, "", {"name": "house", "title": hostile}, {}, [], [], [], []).decode()
    assert "&lt;script&gt;" in page and "x1b[31m{0.__class__}" in page and "\x1b" not in page
    assert page.count("<script>") == 1
