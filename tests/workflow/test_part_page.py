"""What the page of a part says about its faces."""

import re
from types import SimpleNamespace

import pytest
from made_library import record_of, store

from thinpart_workbench.core.number_text import percent
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.workflow.report.part_page import part_page

pytest.importorskip("jinja2")


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
        ["2 &times; plate", "1.9", "2", "50", "30", percent(2 * share), "50\u00a0%", "Face1, Face4"],
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
    assert "excluded: crush rib &lt;1 mm" in rows[0] and "element size 0.4 mm" in rows[0]
    assert record["category"] in page


def test_a_record_of_an_earlier_version_has_no_walls_to_list(tmp_path):
    record = record_of("plate")
    record.pop("regions", None)
    about = {**read_info(store(tmp_path, "plate.step", [record])), "kept": {}, "limits": ()}
    pictures = SimpleNamespace(scale=None, views=list, measure="ray")
    assert "Its walls" not in part_page(record, pictures, [], about, "plate.step", "").decode()
