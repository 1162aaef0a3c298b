# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about a library: what it counts and lists, whatever parts are called, and whatever lies in its place."""

import base64
import hashlib
import json
import os
import re
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path
from urllib.parse import quote, unquote_to_bytes

import made_library
import pytest
from program import ROOT
from read_page import Page, pages

from thinpart_workbench.api.report.library_report import library_report
from thinpart_workbench.core.errors import Cancelled, ThinPartError
from thinpart_workbench.core.figures import Length
from thinpart_workbench.core.length_unit import INCH, MILLIMETRE
from thinpart_workbench.core.message import message
from thinpart_workbench.core.rendering.picture_size import HEIGHT, WIDTH
from thinpart_workbench.core.run_control import RunControl, seldom
from thinpart_workbench.storage.thumbnails import thumbnail_path, write_thumbnail
from thinpart_workbench.workflow.report.library_content import LibraryContent, LibraryPart, LikenessGroup, PartFamily
from thinpart_workbench.workflow.report.library_counts import top_folders
from thinpart_workbench.workflow.report.library_map import LogAxis, map_places
from thinpart_workbench.workflow.report.library_page import library_page

HOSTILE = "<script>alert('1')</script>\t\n</pre><img src=x onerror=y> \x1b[31m \u202e"
SHOWN = r"<script>alert('1')</script>\t\n</pre><img src=x onerror=y> \x1b[31m \u202e"
BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def rows_of(page):
    """The rows that the page's script reads: list of dict."""
    attributes, = (attributes for tag, attributes in page.tags if tag == "pre")
    text = page.path.read_text(encoding="utf-8").partition('<pre id="rows"')[2].partition(">")[2].partition("</pre>")[0]
    fields = attributes["data-fields"].split()
    lines = [re.sub("&(lt|gt|amp);", lambda found: {"lt": "<", "gt": ">", "amp": "&"}[found[1]], line)
             for line in text.split("\n")]
    assert all(line.count("\t") == len(fields) - 1 for line in lines)
    return [dict(zip(fields, line.split("\t"))) for line in lines], attributes["data-base"]


def checked(folder):
    """The page in a folder: it loads and runs nothing but its own, and all it leads to is there."""
    page = pages(folder)["library.html"]
    text = page.path.read_text(encoding="utf-8")
    policy, = (attributes["content"] for tag, attributes in page.tags if attributes.get("http-equiv"))
    script = re.search(r"<script>(.*?)</script>", text, re.S)
    if script:
        digest = base64.b64encode(hashlib.sha256(script[1].encode()).digest()).decode()
        assert page.count("script") == 1 and policy.endswith(f"script-src 'sha256-{digest}'")
        assert "http" not in script[1] and "innerHTML" not in script[1]
    assert policy.startswith("default-src 'none'; style-src 'unsafe-inline'; img-src 'self' file:;")
    assert not [name for _, attributes in page.tags for name in attributes if name.startswith("on")]
    names = {attributes["id"] for _, attributes in page.tags if "id" in attributes}
    assert {each[1:] for each in page.references if each.startswith("#")} <= names
    if script:
        rows, base = rows_of(page)
        for row in rows:
            assert not row["picture"] or (folder / "pictures" / row["picture"][:2] / f"{row['picture']}.png").is_file()
            address = row["address"] or base + quote(row["file"])
            assert address == "-" or os.path.isfile(os.path.join(os.fsencode(folder), unquote_to_bytes(address))), address
            for kind, field in (("group", "groups"), ("family", "families")):
                assert {f"{kind}-{number}" for number in row[field].split()} <= names
    return page


@pytest.fixture
def plate(tmp_path):
    """The library of one part, and its document, of which there is a thumbnail."""
    document = tmp_path / "library" / "plate.step"
    made_library.store(document.parent, document.name, [made_library.record_of("plate")])
    write_thumbnail(hashlib.sha256(document.read_bytes()).hexdigest(), "Solid1", bytes(4 * WIDTH * HEIGHT))
    return document


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """A page about seven shapes, a copy of one, an assembly, and what is no part."""
    folder = tmp_path_factory.mktemp("written")
    library = made_library.make_library(folder / "library")
    made_library.store(library / "group 0", "copy of cube.step", [made_library.record_of("cube")])
    (library / "new.step").write_bytes(b"nobody has measured this")
    info = made_library.store(library, "damaged.step", [made_library.record_of("cube")])
    info.write_text("{")
    found = library_report([library], folder / "out")
    return found, checked(folder / "out")


def test_everything_is_counted(written):
    found, page = written
    assert found.parts == 10 and found.unclassified == 1
    assert "Library of 10 parts" in page.text
    # Categories, then tables of risks, formats and folders.
    assert "4 thin 2 thin features 3 normal 1 unknown 2 failed" in page.text
    assert "1 document has no info file and is not on this page" in page.text and "new.step" in page.text
    assert "STEP 10" in page.text and "group 0 5" in page.text and "group 1 3" in page.text
    assert "(in no folder of its own) 2" in page.text and "unknown 10" in page.text
    bars = [attributes["aria-label"] for tag, attributes in page.tags if attributes.get("class") == "bar"]
    assert "4 thin, 2 thin features, 3 normal, 1 unknown" in bars


def test_every_part_is_a_row_with_its_place_on_the_map(written):
    _, page = written
    rows, base = rows_of(page)
    assert base == "../library/" and len(rows) == 10
    plate = next(row for row in rows if row["file"] == "group 0/plate.step")
    assert (plate["label"], plate["thinnest"], plate["median"], plate["fill"], plate["box"]) == (
        "plate", "2", "2", "100\u00a0%", "100 \u00d7 100 \u00d7 2")
    lid = next(row for row in rows if row["label"] == "Deckel S\u00fcd")
    assert lid["instances"] == "4" and lid["file"] == "assembly.step"
    drawn = {attributes["data-category"]: attributes["d"] for tag, attributes in page.tags
             if tag == "path" and "data-category" in attributes}
    for row in rows:
        if row["label"] == "open_box":
            assert row["height"] == ""
    assert f"M{plate['by_median']} {plate['height']}h0" in drawn["thin"]
    assert sum(each.count("M") for each in drawn.values()) == 9
    assert "1 part is not on the map" in page.text


def test_groups_say_what_shows_them_and_which_to_keep(written):
    _, page = written
    groups = page.text.partition("More than once")[2].partition("All parts")[0]
    assert "Identical: " in page.text and "copy of cube.step" in page.text and "keep" in page.text
    assert "The same form, by the points that info files keep" in page.text and "Nothing is deleted" in groups + page.text
    rows, _ = rows_of(page)
    assert {row["file"] for row in rows if row["groups"]} >= {"group 0/cube.step", "group 0/copy of cube.step"}


def test_what_could_not_be_measured_is_named(written):
    _, page = written
    failed = page.text.partition("Could not be measured")[2]
    assert "broken bounds no solid." in failed and "damaged.step.thinpart.json" in failed and "[info_file]" in failed


def test_names_are_shown_and_never_run(tmp_path):
    folder = tmp_path / "library" / os.fsdecode(b"caf\xe9 <b>%#?")
    for name in ("one.step", "<script>alert(2)<\u202e.step"):
        made_library.store(folder, name, [made_library.record_of("cube", label=HOSTILE, name=HOSTILE)])
    found = library_report([tmp_path / "library"], tmp_path / "out")
    page = checked(tmp_path / "out")
    rows, _ = rows_of(page)
    assert found.parts == 2 and {row["label"] for row in rows} == {SHOWN}
    assert {row["file"] for row in rows} == {r"caf\udce9 <b>%#?/one.step", r"caf\udce9 <b>%#?/<script>alert(2)<\u202e.step"}
    assert all(row["address"].startswith("../library/caf%E9%20%3Cb%3E%25%23%3F/") for row in rows)
    assert page.count("script") == 1 and page.count("b") == 1  # the count of the one category
    assert not re.search("[\x00-\x08\x1b\u202e]", page.path.read_text(encoding="utf-8"))
    assert SHOWN in page.text


def test_only_documents_are_linked(tmp_path):
    library = tmp_path / "library"
    for name, source in (("a.step", {"file": "letter.txt"}), ("b.step", {"folder": "../mine"}), ("c.step", {})):
        info = made_library.store(library, name, [made_library.record_of("cube")])
        content = json.loads(info.read_bytes())
        info.write_text(json.dumps({**content, "source": {**content["source"], **source}}))
    (library / "letter.txt").write_text("private")
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "b.step").write_bytes(b"elsewhere")
    os.remove(library / "c.step")
    library_report([library], tmp_path / "out")
    rows, _ = rows_of(checked(tmp_path / "out"))
    assert [(row["file"], row["address"]) for row in rows] == [
        ("letter.txt", "-"), ("../mine/b.step", ""), ("c.step", "-")]


def test_pictures_are_those_of_the_parts(plate, tmp_path):
    made_library.store(plate.parent, "tube.step", [made_library.record_of("tube")])
    sha256, tube = (hashlib.sha256((plate.parent / name).read_bytes()).hexdigest() for name in ("plate.step", "tube.step"))
    thumbnail_path(tube, "Solid1").parent.mkdir(parents=True, exist_ok=True)
    thumbnail_path(tube, "Solid1").write_bytes(b"<svg onload='alert(1)'/>")
    library_report([plate.parent], tmp_path / "out")
    rows, _ = rows_of(checked(tmp_path / "out"))
    picture, = {row["picture"] for row in rows if row["picture"]}
    assert [row["file"] for row in rows if row["picture"]] == ["plate.step"]
    copied = tmp_path / "out" / "pictures" / picture[:2] / f"{picture}.png"
    assert copied.read_bytes() == thumbnail_path(sha256, "Solid1").read_bytes()
    assert [each.name for each in (tmp_path / "out" / "pictures").rglob("*.png")] == [copied.name]


def test_the_same_library_gives_the_same_page_and_replaces_its_own(plate, tmp_path):
    first = Path(library_report([plate.parent], tmp_path / "out").page).read_bytes()
    assert Path(library_report([plate.parent], tmp_path / "out").page).read_bytes() == first


@pytest.mark.parametrize("place", ["library.html", "thinpart-report.json", "pictures"])
def test_what_people_have_in_the_folder_stays(plate, tmp_path, place):
    library, out = plate.parent, tmp_path / "out"
    library_report([library], out)
    kept = next((out / "pictures").rglob("*.png")) if place == "pictures" else out / place
    kept.write_bytes(b"mine")
    with pytest.raises(ThinPartError, match="was not written by ThinPart") as refused:
        library_report([library], out)
    assert refused.value.kind == "usage" and kept.read_bytes() == b"mine"
    library_report([library], out, overwrite=True)
    assert kept.read_bytes() != b"mine"


def test_a_folder_of_others_is_refused(plate, tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "thesis.txt").write_text("mine")
    with pytest.raises(ThinPartError, match="is not the folder of a report"):
        library_report([plate.parent], tmp_path / "out")
    assert os.listdir(tmp_path / "out") == ["thesis.txt"]


def test_a_library_that_there_is_not_makes_no_folder(tmp_path):
    with pytest.raises(ThinPartError, match="There is no folder") as refused:
        library_report([tmp_path / "nowhere"], tmp_path / "out")
    assert refused.value.kind == "missing" and not (tmp_path / "out").exists()


def test_it_stops_while_pictures_are_copied(plate, tmp_path):
    made_library.store(plate.parent, "tube.step", [made_library.record_of("tube")])
    control, asked = RunControl(), []

    def check():
        asked.append(True)
        raise Cancelled

    control.check = check
    with pytest.raises(Cancelled):
        library_report([plate.parent], tmp_path / "out", control=control)
    assert asked == [True] and not [*tmp_path.glob("out/**/*.html"), *tmp_path.glob("out/**/*.png")]


def test_few_of_many_steps_are_reported_but_always_the_last():
    told = []
    step = seldom(lambda done, total: told.append((done, total)))
    for done in range(1, 1001):
        step(done, 1000)
    assert told[0] == (1, 1000) and told[-1] == (1000, 1000) and len(told) < 100


def test_a_folder_without_info_files_says_what_to_do(tmp_path):
    (tmp_path / "library").mkdir()
    (tmp_path / "library" / "part.step").write_bytes(b"new")
    assert library_report([tmp_path / "library"], tmp_path / "out").parts == 0
    page = Page(tmp_path / "out" / "library.html")
    assert "None of these folders has an info file of a part: 'thinpart classify' writes them." in page.text
    assert page.count("script") == 0


# The page of contents that are made up

def part(number=0, **values):
    return LibraryPart(**{
        "label": f"part {number}", "file": f"folder {number % 30}/part {number}.step", "address": None, "picture": None,
        "instances": 1, "category": ("thin", "thin_features", "normal")[number % 3], "borderline": number % 5 == 0,
        "between": ("normal", "thin") if number % 10 == 0 else (), "place": ("taper", "edge", "")[number % 3],
        "thinnest_mm": 25.4 * (1 + number), "median_mm": 50.8, "diagonal_mm": 254.0, "volume_ratio": 0.123,
        "box_mm": (254.0, 25.4, 2.54), "risk": 0.3, **values})


def content(parts, **values):
    return LibraryContent(**{"place": "parts", "base": "", "titles": {}, "parts": parts, "groups": [], "families": [],
                             "failures": [], "unclassified": [], "without_form": 0, "problems": [], **values})


def made(tmp_path, content, language="en", unit=MILLIMETRE):
    (tmp_path / "library.html").write_bytes(library_page(language, unit, content))
    return checked(tmp_path)


def whole(count):
    """Contents in which everything occurs."""
    said = message("The same form: its surfaces are at most {apart:.2g} apart.", apart=Length(2.54))
    return content(
        [part(number) for number in range(count)],
        groups=[LikenessGroup(kind, [4 * number, 4 * number + 1], ["", said])
                for number, kind in enumerate(("identical", "mirrored", "scaled", "alike"))],
        families=[PartFamily([2, 3, 5], {"d1_mm": [25.4, 50.8, 76.2], "radius_2_mm": [2.54, 5.08, 7.62]})],
        unclassified=["new.step", "newer.step"], without_form=3)


def test_families_have_a_column_for_each_dimension_that_varies(tmp_path):
    page = made(tmp_path, whole(20))
    family = page.text.partition("Family 1: part 2, 3 parts")[2]
    assert "varies: longest side, radius 2" in family
    assert re.search(r"part 2 folder 2/part 2\.step 25\.4 2\.54 part 3 folder 3/part 3\.step 50\.8 5\.08", family)


@pytest.mark.parametrize("language", ["de", "fr"])
def test_a_page_in_another_language_has_no_english_texts(tmp_path, language):
    (tmp_path / "en").mkdir()
    english, page = made(tmp_path / "en", whole(20)), made(tmp_path, whole(20), language, INCH)
    sentences = json.loads((ROOT / "resources" / "translations" / f"sentences_{language}.json").read_text(encoding="utf-8"))
    known = [text for text, other in sentences.items() if text != other and len(text) > 8 and "{" not in text]
    spoken = " ".join([page.text, *(value for _, attributes in page.tags for name, value in attributes.items()
                                    if name in ("aria-label", "title", "placeholder")
                                    or name.startswith("data-") and name != "data-fields")])
    assert [text for text in known if text in spoken] == []
    assert len([text for text in known if text in english.text]) > 15
    assert dict(page.tags)["html"]["lang"] == language
    assert not re.search(r"\bmm\b", page.text) and "0,1 in" in page.text
    rows, _ = rows_of(page)
    assert rows[0]["thinnest"] == "1" and rows[0]["box"] == "10 \u00d7 1 \u00d7 0,1"


def test_the_table_says_between_what_a_verdict_is_and_what_the_thinnest_wall_is(tmp_path):
    rows, _ = rows_of(made(tmp_path, whole(20)))
    assert [rows[number]["verdict"] for number in (0, 1, 5)] == ["Unsure: normal or thin", "", "normal (unsure)"]
    assert [rows[number]["place"] for number in (0, 1, 2)] == ["in a taper", "beside a sharp edge", ""]


def test_long_lists_are_folded(tmp_path):
    count = 400
    groups = [LikenessGroup("identical", [2 * number, 2 * number + 1], ["", "x"]) for number in range(100)]
    groups.append(LikenessGroup("alike", list(range(300, 400)), ["", *["x"] * 99]))
    text = made(tmp_path, content([part(number) for number in range(count)], groups=groups)).path.read_text("utf-8")
    assert "18 more folders" in text and "80 more" in text
    opened = re.findall(r'<details id="(group-\d+)" open', text)
    assert opened == [f"group-{number}" for number in range(1, 6)]


def test_ten_thousand_parts_are_a_page_that_a_browser_shows(tmp_path):
    count = 10_000
    groups = [LikenessGroup("identical", [8 * number, 8 * number + 1], ["", "The documents are the same, byte by byte."])
              for number in range(count // 8)]
    parts = [part(number, picture="0" * 20) for number in range(count)]
    page = library_page("en", MILLIMETRE, content(parts, groups=groups))
    assert len(page) < 400 * count
    assert page.count(b"<tr") < 3 * len(groups) + 200 and page.count(b"<circle") == 0
    assert page.count(b'<path d="') == 6  # three of the map and three of its legend
    assert b'class="dense"' in page


def test_an_axis_has_round_ends_and_all_values_on_it():
    axis = LogAxis.of([0.013, 0.4])
    assert (axis.low, axis.high) == (pytest.approx(0.01), pytest.approx(0.5))
    assert axis.ticks == pytest.approx([0.01, 0.02, 0.05, 0.1, 0.2, 0.5])
    assert [axis.place(value) for value in (0.01, 0.5, 1e-9)] == pytest.approx([0.0, 1.0, 0.0])
    for values in ([], [1.0], [1e-30, 1e30]):
        axis = LogAxis.of(values)
        assert 0 < axis.low < axis.high and 2 <= len(axis.ticks) <= 12
        assert all(0.0 <= axis.place(value) <= 1.0 for value in values)


def test_parts_that_lack_something_have_no_place_on_the_map():
    places = list(map_places([part(median_mm=None), part(thinnest_mm=0.0), part(volume_ratio=None), part(volume_ratio=1.2)]))
    assert [[value is None for value in each] for each in places] == [
        [True, False, False], [False, True, False], [False, False, True], [False, False, False]]
    assert places[3][2] == list(map_places([part(volume_ratio=1.0)]))[0][2]


def test_folders_are_counted_below_what_all_have_in_common():
    assert top_folders(["a/b/x.step", "a/c/d/y.step", "a/z.step"]) == {
        "a/b/x.step": "a/b", "a/c/d/y.step": "a/c", "a/z.step": "a"}
    assert top_folders(["x.step", "a/b/y.step"]) == {"x.step": "", "a/b/y.step": "a"}


@pytest.mark.skipif(BROWSER is None, reason="there is no Chromium")
@pytest.mark.timeout(120)  # starts a browser
def test_a_browser_fills_the_table_without_a_server(tmp_path):
    parts = [part(number) for number in range(150)]
    parts[3] = replace(parts[3], label=HOSTILE, file="<b>\u202e&.step")
    made(tmp_path, replace(whole(150), parts=parts))
    run = subprocess.run(
        [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'profile'}",
         "--virtual-time-budget=5000", "--dump-dom", (tmp_path / "library.html").as_uri()],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL, encoding="utf-8")
    table = run.stdout.partition('id="parts-table"')[2].partition("</table>")[0]
    assert table.count("<tr") == 101 and "1 to 100 of 150 parts" in run.stdout
    assert "<b>" not in table and "<img" not in table and "&lt;b&gt;\\u202e&amp;.step" in table
    assert 'href="#group-1"' in table and run.stdout.count('aria-pressed="false"') == 3
