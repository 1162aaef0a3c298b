# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the page of a part says about its faces."""

import re
from types import SimpleNamespace

import pytest
from made_library import record_of, store

from thinpart_workbench.core.figures import Length
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.length_unit import INCH
from thinpart_workbench.core.message import message
from thinpart_workbench.core.number_text import percent
from thinpart_workbench.core.rendering.colour_scale import ColourScale
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.storage.user_limits import limits_named
from thinpart_workbench.workflow.report.part_page import part_page


def test_a_face_without_triangles_shifts_no_feature(tmp_path):
    face = record_of("plate")["faces"][0]
    record = record_of("plate", faces=[{**face, "face": name, "min": least} for name, least in (
        ("Face1", 3.0), ("Face3", 2.0), ("Face4", None))])
    about = {**read_info(store(tmp_path, "plate.step", [record])), "kept": {}, "limits": ()}
    pictures = SimpleNamespace(scale=None, views=list, measure="ray")
    page = part_page(record, pictures, ["Pad", "Sliver", "Pocket"], about, "plate.step", "")
    rows = [re.findall(r"<t[dh][^>]*>\s*(.*?)\s*</t[dh]>", row, re.S) for row in page.decode().split("<tr")]
    assert [row[:2] for row in rows if row and re.fullmatch(r"Face\d", row[0])] == [
        ["Face3", "Pocket"], ["Face1", "Pad"], ["Face4", ""]]


def _wall(**values):
    return {"kind": "plate", "area_mm2": 100.0, "min": 1.9, "median": 2.0, "length_mm": 50.0, "width_mm": 30.0,
            "volume_share": 0.25, "place": [0.0, 0.0, 0.0], "faces": ["Face1"], **values}


def _page_with(tmp_path, **values):
    record = record_of("plate", **values)
    about = {**read_info(store(tmp_path, "plate.step", [record])), "kept": {}, "limits": ()}
    pictures = SimpleNamespace(scale=None, views=list, measure="ray")
    return record, part_page(record, pictures, [], about, "plate.step", "").decode()


def test_walls_are_listed_with_equal_ones_in_one_row(tmp_path):
    record, page = _page_with(tmp_path, regions={
        "listed": [_wall(), _wall(faces=["Face4"]), _wall(kind="tube", min=5.0, median=5.5, length_mm=7.0)],
        "others": 3, "others_share": 0.01})
    section = re.search(r"<h2>Its walls</h2>(.*?)</section>", page, re.S).group(1)
    rows = [re.findall(r"<t[dh][^>]*>\s*(.*?)\s*</t[dh]>", row, re.S) for row in section.split("<tr")[2:]]
    share = 100.0 / record["descriptors"]["area_mm2"]
    assert rows == [
        ["2 \u00d7 plate", "1.9", "2", "50", "30", percent(2 * share), "50\u00a0%", "Face1, Face4"],
        ["tube", "5", "5.5", "7", "30", percent(share), "25\u00a0%", "Face1"]]
    assert "and 3 smaller walls, 1.0\u00a0% of the surface" in section


def test_an_excluded_wall_is_struck_through_with_its_reason(tmp_path):
    record = record_of("plate", regions={"listed": [_wall(), _wall(place=[30.0, 0.0, 0.0], faces=["Face4"])],
                                         "others": 0, "others_share": 0.0})
    notes = [{"place": [0.0, 0.0, 1.0], "faces": ["Face1"], "person": "Anna", "when": "2026-11-23T05:00:00+00:00",
              "excluded": "crush rib <1 mm", "mesh_size_mm": 0.4}]
    about = {**read_info(store(tmp_path, "plate.step", [record])), "kept": {"region_notes": notes}, "limits": ()}
    page = part_page(record, SimpleNamespace(scale=None, views=list, measure="ray"), [], about, "plate.step", "").decode()
    section = re.search(r"<h2>Its walls</h2>(.*?)</section>", page, re.S).group(1)
    rows = section.split("<tr")[2:]
    assert len(rows) == 2 and "<s>" in rows[0] and "<s>" not in rows[1]
    assert "excluded: crush rib &lt;1 mm" in rows[0] and "element size 0.4\u00a0mm" in rows[0]
    assert record["category"] in page


def test_a_record_of_an_earlier_version_has_no_walls_to_list(tmp_path):
    record = record_of("plate")
    record.pop("regions", None)
    about = {**read_info(store(tmp_path, "plate.step", [record])), "kept": {}, "limits": ()}
    pictures = SimpleNamespace(scale=None, views=list, measure="ray")
    assert "Its walls" not in part_page(record, pictures, [], about, "plate.step", "").decode()


def test_what_the_paper_would_say_stands_where_it_differs(tmp_path):
    said = "By the paper's criteria: thin features (criterion 5: "
    record = record_of("ribbed_block")
    assert record["category"] == "thin_features"
    about = {**read_info(store(tmp_path, "block.step", [record])), "kept": {}, "limits": ()}
    pictures = SimpleNamespace(scale=None, views=list, measure="ray")
    assert said not in part_page(record, pictures, [], about, "block.step", "").decode()
    calibrated = load_profile("calibrated")
    by_calibrated = {**record, "category": "normal"}
    about["profile"] = calibrated.content
    assert said in part_page(by_calibrated, pictures, [], about, "block.step", "").decode()
    german = part_page(by_calibrated, pictures, [], about, "block.step", "", "de").decode()
    assert "Nach den Kriterien des Artikels: teils d\u00fcnn (Kriterium 5: " in german


def _record_with_lengths():
    return record_of("plate", warnings=[message("A wall of {wall} was left out.", wall=Length(2.54))], regions={
        "listed": [_wall(min=2.54, median=5.08, length_mm=25.4, width_mm=50.8)], "others": 0, "others_share": 0.0})


def _page_in_inches(tmp_path, record, language):
    """The page, and the same without styles."""
    limits = limits_named(["die_casting:zinc"])
    about = {**read_info(store(tmp_path, "plate.step", [record])), "kept": {}, "limits": limits}
    pictures = SimpleNamespace(scale=ColourScale(2.54, 25.4), views=list, measure="ray", greatest=50.0)
    page = part_page(record, pictures, [], about, "plate.step", "", language, INCH).decode()
    return page, re.sub(r"<style>.*?</style>", " ", page, flags=re.S)


def test_a_page_in_inches_tells_of_no_millimetre(tmp_path):
    record = _record_with_lengths()
    page, text = _page_in_inches(tmp_path, record, "en")
    assert "A wall of 0.1\u00a0in was left out." in text
    assert not re.search(r"\bmm\b", re.sub(r"<[^>]*>", " ", text))
    assert "aria-label=\"Colours from 0.1\u00a0in to 1\u00a0in" in text
    assert "0.1\u00a0in" in text and "1\u00a0in and more" in text and "thickness, in" in text
    row = re.search(r"<h2>Its walls</h2>.*?</table>", text, re.S).group(0)
    assert "Least, in" in row and all(f'<td class="n">{value}</td>' in row for value in ("0.1", "0.2", "1", "2"))
    # Bars of the chart end at round numbers of inches.
    ticks = re.findall(r'y="558" text-anchor="middle">([^<]*)<', text)
    assert len(ticks) > 2 and all(len(tick.strip("0.")) <= 2 for tick in ticks)
    box = record["descriptors"]["box_mm"]
    assert INCH.number(box[0]) in re.search(r"<dt>Bounding box</dt><dd>(.*?)</dd>", page).group(1)


def test_a_part_with_an_open_surface_has_no_volume_in_inches_either(tmp_path):
    record = _record_with_lengths()
    record["descriptors"] = {**record["descriptors"], "volume_mm3": None}
    page, _ = _page_in_inches(tmp_path, record, "en")
    assert "<dt>Volume</dt><dd>\u2013 <small>in\u00b3</small></dd>" in page


@pytest.mark.parametrize("language, said", [
    ("de", ("A wall of 0,1\u00a0in was left out.", "0,1\u00a0in bis 1\u00a0in", "1\u00a0in und mehr", "Dicke, in",
            "Kleinste, in", "d\u00fcnn unter 0,")),
    ("fr", ("A wall of 0,1\u00a0in was left out.", "0,1\u00a0in \u00e0 1\u00a0in", "1\u00a0in et plus",
            "\u00e9paisseur, in", "Minimum, in", "mince sous 0,"))])
def test_a_page_has_the_unit_and_the_decimal_mark_of_its_language(tmp_path, language, said):
    record = _record_with_lengths()
    page, text = _page_in_inches(tmp_path, record, language)
    assert [each for each in said if each not in text] == []
    shown = re.sub(r"<[^>]*>", " ", re.sub(r"</?title>", " ", text))
    labels = " ".join(re.findall(r'(?:aria-label|title)="([^"]*)"', text))
    for seen in (shown, labels):
        assert not re.search(r"\bmm\b", seen), re.findall(r".{30}\bmm\b.{10}", seen)
        assert not re.search(r"\d\.\d+\u00a0in", seen)
    numbers = re.findall(r'<td class="n">([\d.,]+)</td>|<text[^>]*>([\d.,]+)', text) + re.findall(r"<dd>([\d.,]+) ", text)
    assert len(numbers) > 20 and "." not in str(numbers).replace("', '", "")
    box = record["descriptors"]["box_mm"]
    assert INCH.number(box[0]).replace(".", ",") in page
