# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of parts by the real worker, and runs that can keep none."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from program import SAMPLES, environment, records, thinpart
from read_png import read_png

from thinpart_workbench.freecad_adapter.preferences import PREFERENCES
from thinpart_workbench.storage.thumbnails import thumbnail_path
from thinpart_workbench.workflow.analysis.analyse_file import FileTask, analyse_file
from thinpart_workbench.workflow.analysis.result_files import write_results


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def files_of_pictures(cache):
    return [path for path in (cache / "thumbnails").rglob("*") if path.is_file()]


def pictures(folder):
    """Of every part in the info files of a folder: its category and its picture."""
    found = {}
    for info_file in folder.rglob("*.thinpart.json"):
        content = json.loads(info_file.read_text(encoding="utf-8"))
        for part in content["parts"]:
            path = thumbnail_path(content["source"]["sha256"], part["name"])
            found[content["source"]["file"], part["label"]] = part["category"], read_png(path)
    return found


def of_hue(image, preference):
    """Share of what is shown that has a colour, whatever its brightness."""
    colour = np.array(PREFERENCES[preference].default)
    pixels = image[image[..., 3] == 255][:, :3].astype(float)
    brightness = pixels[:, :1] / colour[0]
    return (abs(pixels - brightness * colour) < 3).all(axis=1).mean()


def test_every_part_has_a_picture_with_its_thin_faces_red(tmp_path, cache):
    files = [SAMPLES / name for name in ("plate.step", "block.step", "tube.FCStd", "vee_block.step",
                                         "ribbed_block.FCStd", "assembly_of_three.FCStd")]
    run = thinpart("classify", *files, "--info-dir", tmp_path / "info", "--json", "--profile", "paper")
    assert run.returncode == 0, run.stderr
    found = pictures(tmp_path / "info")
    assert len(found) == len(records(run)) == 8
    assert len(files_of_pictures(cache)) == 8
    for part, (category, image) in found.items():
        assert image.shape == (120, 160, 4), part
        assert 0.1 < (image[..., 3] == 255).mean() < 0.9 and (image[0] == 0).all(), part
        red = of_hue(image, "ThinColour")
        assert red > 0.5 if category == "thin" else red < 0.2, part
    for part in (("block.step", "block"), ("assembly_of_three.FCStd", "Dowel pin")):
        assert found[part][0] == "normal" and of_hue(found[part][1], "ThinColour") == 0
    assert found["ribbed_block.FCStd", "Ribbed block"][0] == "thin_features"
    assert of_hue(found["ribbed_block.FCStd", "Ribbed block"][1], "ThinColour") > 0.02


def test_the_same_part_gives_the_same_bytes(tmp_path, cache):
    for name in ("first", "second"):
        (tmp_path / name).mkdir()
        shutil.copy(SAMPLES / "gear_thin_teeth.step", tmp_path / name / f"{name}.step")
    contents = []
    for name in ("first", "second"):
        thinpart("classify", tmp_path / name)
        path, = files_of_pictures(cache)
        contents.append(path.read_bytes())
        path.unlink()
    assert contents[0] == contents[1]


def test_a_part_from_its_info_file_is_not_measured_again_for_its_picture(tmp_path, cache):
    task = FileTask(os.fspath(SAMPLES / "block.step"), os.fspath(tmp_path / "block.step.thinpart.json"),
                    thumbnails=True)
    assert not write_results(task, analyse_file(task))["reused"]
    path, = files_of_pictures(cache)
    path.unlink()
    assert write_results(task, analyse_file(task))["reused"] and not path.exists()


def for_window(folder):
    """What the window reads of a folder: it has the input open until all is done."""
    with subprocess.Popen([sys.executable, "-m", "thinpart_workbench", "classify", str(folder), "--json", "--control"],
                          env=environment(), stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL) as process:
        return [json.loads(line) for line in process.stdout]


def test_lines_for_the_window_name_the_pictures_of_parts(tmp_path, cache):
    (tmp_path / "parts").mkdir()
    for name in ("plate.step", "assembly_of_three.FCStd"):
        shutil.copy(SAMPLES / name, tmp_path / "parts")
    (tmp_path / "parts" / "damaged.step").write_text("ISO-10303-21;\nthis is no STEP file\n")
    for _ in ("measured", "from info files"):
        lines = for_window(tmp_path / "parts")
        assert sorted(line["thumbnail"] for line in lines if "error" not in line) == sorted(
            map(str, files_of_pictures(cache))) and len(lines) == 5
        assert [line["thumbnail"] for line in lines if "error" in line] == [None]
    assert not any("thumbnail" in line for line in records(thinpart("classify", tmp_path / "parts", "--json")))


@pytest.mark.parametrize("option", ["--no-thumbnails", "--no-info"])
def test_no_pictures_when_not_wanted(tmp_path, cache, option):
    run = thinpart("classify", SAMPLES / "wedge.step", option, "--info-dir", tmp_path / "info")
    assert run.returncode == 0 and not (cache / "thumbnails").exists()


@pytest.mark.parametrize("place", ["under a file", "read-only", "in /proc", "no such user", "relative"])
def test_no_room_for_pictures_is_no_failure(tmp_path, monkeypatch, place):
    (tmp_path / "file").write_text("")
    (tmp_path / "closed").mkdir(mode=0o555)
    if place == "read-only" and os.geteuid() == 0:
        pytest.skip("root may write into any folder")
    (tmp_path / "here").mkdir()
    cache = {"under a file": tmp_path / "file" / "cache", "read-only": tmp_path / "closed" / "cache",
             "in /proc": "/proc/thinpart", "no such user": "~nobody-of-that-name/cache",
             "relative": "cache"}[place]
    monkeypatch.setenv("THINPART_CACHE", str(cache))
    run = thinpart("classify", SAMPLES / "wedge.step", "--info-dir", tmp_path / "info",
                   cwd=tmp_path / "here")
    assert run.returncode == 0 and run.stderr == ""
    assert (tmp_path / "info" / "wedge.step.thinpart.json").is_file()
    assert not Path(cache).exists()
    assert [path.name for path in (tmp_path / "here").iterdir()] == ["cache"] * (place == "relative")
