# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart map``: pictures, and triangles with values, without a window."""

import json
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from program import thinpart
from read_png import read_png

from thinpart_workbench.api.file_run import write_map
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.rendering.colour_maps import RED_IS_THIN
from thinpart_workbench.core.rendering.colour_scale import ColourScale
from thinpart_workbench.core.rendering.map_picture import MapLook
from thinpart_workbench.storage.png import png_bytes

WHITE = [255, 255, 255, 255]


@pytest.fixture(scope="module")
def sheet(tmp_path_factory):
    """A sheet of 60 x 40 x 2 mm."""
    import Part

    file = tmp_path_factory.mktemp("parts") / "sheet.step"
    Part.makeBox(60, 40, 2).exportStep(str(file))
    return file


@pytest.fixture(scope="module")
def two_parts(tmp_path_factory):
    import FreeCAD
    import Part

    file = tmp_path_factory.mktemp("parts") / "two.FCStd"
    document = FreeCAD.newDocument("Two")
    try:
        for name, thickness in (("Thin", 1.0), ("Thick", 5.0)):
            document.addObject("Part::Feature", name).Shape = Part.makeBox(30, 20, thickness)
        document.recompute()
        document.saveAs(str(file))
    finally:
        FreeCAD.closeDocument(document.Name)
    return file


def test_all_formats_are_written_in_one_run_and_have_the_thickness(sheet, tmp_path):
    files = {name: tmp_path / f"sheet.{name}" for name in ("png", "vtp", "ply")}
    options = [text for name, file in files.items() for text in (f"--{name}", file)]
    run = thinpart("map", sheet, *options, "--pixels", "400x300")
    assert run.returncode == 0, run.stderr
    assert "sheet: thinnest wall 2 mm, colours from 2 mm to" in run.stdout and "sheet.vtp" in run.stdout
    pixels = read_png(files["png"])
    assert pixels.shape == (300, 400, 4) and (pixels[0, 0] == WHITE).all()
    piece = ElementTree.parse(files["vtp"]).getroot().find("PolyData/Piece")
    assert int(piece.get("NumberOfPolys")) > 1000
    head, _, content = files["ply"].read_bytes().partition(b"end_header\n")
    count = int(head.split(b"element vertex ")[1].split()[0])
    vertices = np.frombuffer(content, dtype=[("point", "<f4", 3), ("colour", "u1", 3), ("thickness", "<f4")], count=count)
    assert np.ptp(vertices["point"], axis=0) == pytest.approx([60, 40, 2])
    flat = np.abs(vertices["thickness"] - 2.0) < 1e-4
    assert flat.mean() > 0.3 and (vertices["colour"][flat] == ColourScale(2.0, 3.0).colours([2.0])[0]).all()


def test_the_picture_has_the_range_the_colours_and_the_view_that_were_asked_for(sheet, tmp_path):
    look = MapLook("viridis", low=1.0, high=3.0, view="top", width=480, height=320)
    found = write_map(sheet, [tmp_path / "top.png"], look=look)
    assert (found["low"], found["high"], found["thinnest"]) == (1.0, 3.0, pytest.approx(2.0, rel=1e-3))
    pixels = read_png(tmp_path / "top.png")[:, :, :3].astype(int)
    wanted = ColourScale(1.0, 3.0, "viridis").colours([2.0])[0].astype(int)
    middle = pixels[160, 200]  # lit from the front: somewhat darker than the colour of the scale, of the same hue
    assert middle @ wanted / np.linalg.norm(middle) / np.linalg.norm(wanted) > 0.999
    covered = (pixels[:, :414] < 250).any(axis=2)
    height, width = (np.flatnonzero(covered.any(axis=axis)) for axis in (1, 0))
    assert np.ptp(width) / np.ptp(height) == pytest.approx(1.5, abs=0.03)
    # The colour bar: the low end below, the high end on top.
    bar = ColourScale(1.0, 3.0, "viridis").bar([0.0, 1.0]).astype(int)
    rows = [np.flatnonzero((np.abs(pixels[:, 414:] - colour).max(axis=2) < 4).any(axis=1)) for colour in bar]
    assert rows[0].min() > rows[1].max()


def test_inches_are_in_the_picture_in_the_range_and_in_what_is_said(sheet, tmp_path):
    run = thinpart("map", sheet, "--png", tmp_path / "in.png", "--unit", "in", "--range", "0.05", "0.1", "--json")
    found = json.loads(run.stdout)
    assert (found["low"], found["high"]) == (pytest.approx(1.27), pytest.approx(2.54))
    run = thinpart("map", sheet, "--png", tmp_path / "again.png", "--unit", "in", "--range", "0.05", "0.1")
    assert "thinnest wall 0.0787 in, colours from 0.05 in to 0.1 in." in run.stdout
    assert (read_png(tmp_path / "in.png") == read_png(tmp_path / "again.png")).all()
    assert thinpart("map", sheet, "--png", tmp_path / "mm.png", "--range", "1.27", "2.54").returncode == 0
    differ = (read_png(tmp_path / "in.png") != read_png(tmp_path / "mm.png")).any(axis=(0, 2))
    assert differ.any()


def test_one_part_of_several_is_named(two_parts, tmp_path):
    run = thinpart("map", two_parts, "--ply", tmp_path / "x.ply")
    assert run.returncode == 2 and "two.FCStd has 2 parts: name one after --part, of Thin, Thick." in run.stderr
    run = thinpart("map", two_parts, "--ply", tmp_path / "x.ply", "--part", "thin")
    assert run.returncode == 2 and "There is no part thin in two.FCStd: it has Thin, Thick." in run.stderr
    assert not (tmp_path / "x.ply").exists()
    for name, thickness in (("Thin", 1.0), ("Thick", 5.0)):
        assert write_map(two_parts, [tmp_path / f"{name}.ply"], part=name)["thinnest"] == pytest.approx(thickness, rel=1e-3)


def test_balls_are_shown_where_they_are_asked_for(sheet, tmp_path):
    for measure in ("rays", "sphere", "local"):
        assert thinpart("map", sheet, "--ply", tmp_path / f"{measure}.ply", "--measure", measure).returncode == 0
    assert (tmp_path / "rays.ply").read_bytes() != (tmp_path / "sphere.ply").read_bytes()


@pytest.mark.parametrize("options, sentence", [
    ((), "Name what to write: --png FILE, --vtp FILE or --ply FILE."),
    (("--png", "map.jpg"), "map.jpg is no name for a file of --png: give it the ending .png."),
    (("--png", "map.png", "--range", "3", "1"), "--range takes the thinner wall first, then the thicker: not 3 and 1."),
    (("--png", "map.png", "--bands", "-1"), "--bands takes a number from 0, for smooth colours, to 64."),
    (("--png", "map.png", "--pixels", "10x10"), "--pixels takes a width and a height from 64 to 8192, as 1600x1200."),
])
def test_what_cannot_be_drawn_is_refused_before_anything_is_measured(options, sentence, sheet, tmp_path):
    run = thinpart("map", sheet, *options, cwd=tmp_path)
    assert run.returncode == 2 and sentence in run.stderr
    assert list(tmp_path.iterdir()) == []


def test_what_fails_leaves_the_picture_that_was_there(sheet, tmp_path):
    kept, damaged = tmp_path / "map.png", tmp_path / "damaged.step"
    kept.write_bytes(content := png_bytes(bytes(4), 1, 1))
    damaged.write_text("ISO-10303-21;\nthis is no STEP file\n")
    run = thinpart("map", damaged, "--png", kept)
    assert run.returncode == 1 and "damaged.step" in run.stderr and "Traceback" not in run.stderr
    run = thinpart("map", tmp_path / "missing.step", "--png", kept)
    assert run.returncode == 1 and "missing.step is no file: name a CAD file with one part." in run.stderr
    assert kept.read_bytes() == content
    with pytest.raises(ThinPartError, match="cannot be written"):
        write_map(sheet, [tmp_path / "no folder" / "map.png"], look=MapLook(RED_IS_THIN, width=64, height=64))
