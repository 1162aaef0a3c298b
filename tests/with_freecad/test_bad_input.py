# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad input and interruption: one clear row, the others go on, nothing half-written."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import jsonschema
import made_meshes
import numpy as np
import pytest
import time_limit
from program import SAMPLES, SCHEMA, environment, failures, group_ended, records, thinpart
from slow_files import make_endless

from thinpart_workbench.freecad_adapter.reading.mesh_file_check import check_mesh_file

ENDINGS = ["step", "iges", "brep", "FCStd", "stl", "obj", "ply", "off"]


def write_bad_files(folder, freecad):
    """One file of every kind that cannot be measured, each in its own way."""
    import Mesh
    import Part

    noise = np.random.default_rng(20120507).bytes(5000)
    for ending in ENDINGS:
        (folder / f"empty.{ending}").write_bytes(b"")
        (folder / f"bad.{ending}").write_bytes(noise)
    for ending in ("step", "FCStd"):
        whole = (SAMPLES / f"block.{ending}").read_bytes()
        for part in (0.5, 0.9):
            (folder / f"cut-{part}.{ending}").write_bytes(whole[:int(part * len(whole))])
    for name, form in (("binary", "STL"), ("ascii", "AST")):
        file = folder / f"cut-{name}.stl"
        Mesh.createBox(10, 10, 10).write(Filename=str(file), Format=form)
        file.write_bytes(file.read_bytes()[:-60])
    box = Part.makeBox(10, 10, 10)
    for name, shape in (("face", box.Faces[0]), ("shell", Part.makeShell(box.Faces[:5])),
                        ("wire", box.Wires[0]), ("nothing", Part.Compound([]))):
        shape.exportBrep(str(folder / f"{name}.brep"))
    document = freecad.newDocument("Bad")
    document.saveAs(str(folder / "without.FCStd"))
    document.addObject("Part::Feature", "Null")
    document.saveAs(str(folder / "null.FCStd"))
    document.addObject("Part::Feature", "Face").Shape = Part.makePlane(5, 5)
    document.saveAs(str(folder / "face.FCStd"))
    freecad.closeDocument(document.Name)
    Mesh.createBox(10, 10, 10).write(Filename=str(folder / "nan.stl"), Format="AST")
    text = (folder / "nan.stl").read_text()
    (folder / "nan.stl").write_text(re.sub(r"vertex\s+\S+", "vertex nan", text, count=3))
    (folder / "inf.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n")
    hexagon = b"".join(b"v %d %d 0\n" % (k, k * k) for k in range(6)) + b"f 1 2 3 4 5 6\n"
    (folder / "hexagon.obj").write_bytes(hexagon)
    (folder / "sheet.off").write_bytes(b"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n")


@pytest.fixture(scope="module")
def bad_run(tmp_path_factory, freecad):
    """One run over all bad files and a good one, and their folder."""
    folder = tmp_path_factory.mktemp("bad")
    write_bad_files(folder, freecad)
    shutil.copy(SAMPLES / "wedge.step", folder)
    before = {file.name for file in folder.iterdir()}
    return thinpart("classify", folder, "--json"), folder, before


def kind_of(bad_run, name):
    """How the row of a bad file calls its fault, where the row and its sentence are there."""
    run, folder, before = bad_run
    assert name in before and name in run.stderr and not list(folder.glob(f"{name}.*"))
    row, *more = [line for line in records(run) if Path(line["file"]).name == name]
    assert all("error" in line for line in (row, *more))
    return failures(run)[name]


def test_the_good_file_goes_on_beside_the_bad_ones(bad_run):
    run, folder, before = bad_run
    assert run.returncode == 1 and "Traceback" not in run.stderr
    assert [line["category"] for line in records(run) if line.get("category")] == ["normal"]
    assert failures(run).keys() == before - {"wedge.step"}
    assert {file.name for file in folder.iterdir()} - before == {"wedge.step.thinpart.json"}


@pytest.mark.parametrize("ending", ENDINGS)
def test_empty_files(bad_run, ending):
    assert kind_of(bad_run, f"empty.{ending}") == "empty"


@pytest.mark.parametrize("ending", ENDINGS)
def test_garbage(bad_run, ending):
    assert kind_of(bad_run, f"bad.{ending}") == "unreadable"


@pytest.mark.parametrize("ending", ["step", "FCStd"])
@pytest.mark.parametrize("part", [0.5, 0.9])
def test_truncated(bad_run, ending, part):
    assert kind_of(bad_run, f"cut-{part}.{ending}") == "unreadable"


@pytest.mark.parametrize("form", ["binary", "ascii"])
def test_truncated_stl(bad_run, form):
    assert kind_of(bad_run, f"cut-{form}.stl") == "unreadable"


@pytest.mark.parametrize("name", ["face", "shell", "wire", "nothing"])
def test_surfaces_and_wires_are_no_solid(bad_run, name):
    assert kind_of(bad_run, f"{name}.brep") == "no_solid"


@pytest.mark.parametrize("name, kind", [("without", "empty"), ("null", "no_solid"), ("face", "no_solid")])
def test_documents_without_a_part(bad_run, name, kind):
    assert kind_of(bad_run, f"{name}.FCStd") == kind


@pytest.mark.parametrize("name", ["nan.stl", "inf.obj"])
def test_coordinates_that_are_no_numbers(bad_run, name):
    assert kind_of(bad_run, name) == "not_finite"


def test_a_table_is_never_written_over_a_part_or_anything_else(tmp_path):
    files = [Path(shutil.copy(SAMPLES / f"{name}.step", tmp_path)) for name in ("wedge", "block")]
    notes = tmp_path / "notes.txt"
    notes.write_text("mine")
    for table in (*files, notes, tmp_path / "new.FCStd"):
        before = table.read_bytes() if table.exists() else None
        run = thinpart("classify", files[1], "--no-info", "--csv", table)
        assert run.returncode == 2 and "not changed" in run.stderr
        assert (table.read_bytes() if table.exists() else None) == before


def test_words_that_look_like_no_number_are_none(tmp_path):
    texts = {"noted.obj": b"v 0 0 0 # info\nv 10 0 0 # nan\n", "named.obj": b"o inf\ng nano\n",
             "binary.ply": b"ply\nformat binary_little_endian 1.0\nend_header\n1 inf nan\n"}
    for name, content in texts.items():
        file = tmp_path / name
        file.write_bytes(content)
        check_mesh_file(file)


def test_faces_that_freecad_leaves_out_are_not_lost_silently(bad_run):
    assert kind_of(bad_run, "hexagon.obj") == "unsupported"


def test_zero_volume(bad_run):
    assert kind_of(bad_run, "sheet.off") == "zero_volume"


def test_suspect_parts_are_classified_with_a_warning(tmp_path):
    import FreeCAD
    import MeshPart
    import Part

    box = Part.makeBox(10, 10, 10)
    other = box.copy()
    other.translate(FreeCAD.Vector(5, 5, 5))

    def stl(*shapes, cut=0, flip=False):
        import Mesh

        mesh = Mesh.Mesh()
        for shape in shapes:
            mesh.addMesh(MeshPart.meshFromShape(Shape=shape, LinearDeflection=1,
                                                AngularDeflection=1))
        facets = [[tuple(p) for p in facet.Points] for facet in mesh.Facets][cut:]
        return Mesh.Mesh([facet[::-1] if flip else facet for facet in facets])

    tiny = box.copy()
    tiny.scale(1e-4)
    expected = {}
    for name, thing, says, category in (
        ("through.stl", stl(box, other), "intersects itself", None),
        ("open.stl", stl(box, cut=2), "open", "unknown"),
        ("inverted.stl", stl(box, flip=True), "inside out", "normal"),
        ("tiny.brep", tiny, "unit", "normal"),
        ("reversed.brep", box.reversed(), "inside out", "normal"),
    ):
        file = tmp_path / name
        (thing.exportBrep if name.endswith("brep") else thing.write)(str(file))
        expected[name] = says, category
    found = {Path(record["file"]).name: record for record in records(
        thinpart("classify", tmp_path, "--json", "--no-info"))}
    assert found.keys() == expected.keys()
    for name, (says, category) in expected.items():
        assert any(says in warning for warning in found[name]["warnings"]), (name, found[name]["warnings"])
        assert category in (None, found[name]["category"])


def test_a_solid_far_from_the_origin(tmp_path):
    import FreeCAD
    import Part

    box = Part.makeBox(100, 100, 2)
    box.translate(FreeCAD.Vector(1e6, -1e6, 1e6))
    file = tmp_path / "far.brep"
    box.exportBrep(str(file))
    record, = records(thinpart("classify", file, "--json", "--no-info"))
    assert record["paper"]["criteria"] == [1, 4, 5]
    assert record["descriptors"]["thickness_mm"]["min"] == pytest.approx(2, rel=1e-6)
    assert record["faces"][0]["witness"]["points"][0] == pytest.approx([1e6, -1e6, 1e6], rel=1e-3)


def test_a_file_that_ends_its_reader_is_one_row(tmp_path, rng):
    """References to anything: the reader of OCCT 7.6 follows them and dies; the row says so."""
    import Part

    lines = (SAMPLES / "block.step").read_text().split("\n")
    kinds = set()
    folder = tmp_path / "parts"
    folder.mkdir()
    for number in range(8):
        spoilt = list(lines)
        for line in rng.integers(20, len(lines) - 3, 8):
            spoilt[line] = re.sub(r"#\d+", lambda _: f"#{rng.integers(1, 400)}", spoilt[line])
        (folder / f"{number}.step").write_text("\n".join(spoilt))
    shutil.copy(SAMPLES / "wedge.step", folder / "good.step")
    run = thinpart("classify", folder, "--json", "--no-info", "--timeout", "8")
    kinds = set(failures(run).values())
    assert len(records(run)) == 9
    # OCCT 7.9 finds out that they are damaged.
    assert "crash" in kinds or tuple(map(int, Part.OCC_VERSION.split(".")[:2])) >= (7, 9)
    assert kinds <= {"crash", "unreadable", "no_solid", "timeout", "zero_volume", "memory"}
    assert [r["category"] for r in records(run) if r["file"].endswith("good.step")] == [
        "normal"]


def test_a_file_that_never_ends_is_one_row(tmp_path):
    make_endless(tmp_path / "hang.step")
    shutil.copy(SAMPLES / "wedge.step", tmp_path / "good.step")
    run = thinpart("classify", tmp_path, "--json", "--no-info", "--timeout", "6")
    assert failures(run) == {"hang.step": "timeout"} and len(records(run)) == 2


def test_too_little_memory_is_one_row(tmp_path):
    points, triangles = made_meshes.sphere(20, 800)
    facets = np.zeros(len(triangles), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)),
                                       ("flags", "<u2")])
    facets["corners"] = points[triangles]
    head = b"\0" * 80 + len(triangles).to_bytes(4, "little")
    (tmp_path / "large.stl").write_bytes(head + facets.tobytes())
    shutil.copy(SAMPLES / "wedge.step", tmp_path)
    run = thinpart("classify", tmp_path / "large.stl", tmp_path / "wedge.step", "--json", "--memory", "700")
    assert run.returncode == 1 and failures(run) == {"large.stl": "memory"}
    assert "large.stl" in run.stderr and "Traceback" not in run.stderr
    assert [line["category"] for line in records(run) if line.get("category")] == ["normal"]
    assert {file.name for file in tmp_path.iterdir()} == {"large.stl", "wedge.step", "wedge.step.thinpart.json"}


def test_missing_file(tmp_path):
    run = thinpart("classify", tmp_path / "no.step", "--json")
    assert run.returncode == 1 and failures(run) == {"no.step": "missing"}


def test_empty_folder(tmp_path):
    run = thinpart("classify", tmp_path)
    assert run.returncode == 1 and "no parts" in run.stderr


@pytest.fixture
def nobody():
    """Run as a user who may do nothing: as root every file may be read and written."""
    if os.geteuid() != 0:
        return {}
    return {"user": 65534, "group": 65534, "extra_groups": []}


def test_no_permission_to_read(tmp_path, nobody):
    _open_to_all(tmp_path)
    file = Path(shutil.copy(SAMPLES / "wedge.step", tmp_path))
    file.chmod(0)
    run = thinpart("classify", file, "--json", "--no-info", **nobody)
    assert failures(run) == {"wedge.step": "permission"}


def test_read_only_folder_for_the_info_file(tmp_path, nobody):
    _open_to_all(tmp_path)
    file = Path(shutil.copy(SAMPLES / "wedge.step", tmp_path))
    file.chmod(0o644)
    tmp_path.chmod(0o555)
    run = thinpart("classify", file, "--json", **nobody)
    tmp_path.chmod(0o755)
    lines = records(run)
    assert run.returncode == 1 and lines[0]["category"] == "normal"
    assert lines[1]["error"]["kind"] == "info_write" and "--info-dir" in run.stderr
    assert sorted(os.listdir(tmp_path)) == ["wedge.step"]


def test_full_folder_for_the_info_file(tmp_path):
    """A file system of a few kilobytes, where this machine lets us mount one."""
    full = tmp_path / "full"
    full.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "tmpfs", str(full)],
                      capture_output=True).returncode:
        pytest.skip("no file system may be mounted here")
    try:
        run = thinpart("classify", SAMPLES / "wedge.step", "--json", "--info-dir", full)
        assert records(run)[1]["error"]["kind"] == "info_write"
        assert os.listdir(full) == []
    finally:
        subprocess.run(["umount", str(full)], check=True)


def test_a_foreign_or_newer_info_file_is_left_as_it_is(tmp_path):
    contents = {"newer": '{"format": "thinpart-info", "version": 99}', "foreign": "something else", "empty": ""}
    for name, content in contents.items():
        shutil.copy(SAMPLES / "wedge.step", tmp_path / f"{name}.step")
        (tmp_path / f"{name}.step.thinpart.json").write_text(content)
    run = thinpart("classify", tmp_path, "--json")
    assert run.returncode == 1 and failures(run) == {f"{name}.step": "info_write" for name in contents}
    assert [line["category"] for line in records(run) if "category" in line] == ["normal"] * 3
    for name, content in contents.items():
        assert (tmp_path / f"{name}.step.thinpart.json").read_text() == content


def _open_to_all(folder):
    for parent in [folder, *folder.parents]:
        if parent.stat().st_uid == os.geteuid() and parent != Path("/"):
            parent.chmod(parent.stat().st_mode | 0o755)


# -- interruption


def test_ctrl_c_keeps_what_was_done_and_leaves_nothing_running(tmp_path):
    for number in range(6):
        shutil.copy(SAMPLES / "thin_walled_casting.step", tmp_path / f"{number}.step")
    process = subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench", "classify", str(tmp_path), "--json",
         "--jobs", "1"], env=environment(), stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", start_new_session=True,
    )
    first = process.stdout.readline()
    os.killpg(process.pid, signal.SIGINT)
    rest, errors = process.communicate()
    assert process.returncode == 130 and "Traceback" not in errors
    done = len((first + rest).splitlines())
    infos = list(tmp_path.glob("*.thinpart.json"))
    assert 1 <= done <= len(infos) < 6
    for info in infos:
        jsonschema.validate(json.loads(info.read_text(encoding="utf-8")), SCHEMA)
    assert group_ended(process.pid)


def test_kill_9_leaves_no_half_written_file(tmp_path):
    for number in range(4):
        shutil.copy(SAMPLES / "wedge.step", tmp_path / f"{number}.step")
    process = subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench", "classify", str(tmp_path), "--json"],
        env=environment(), stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, encoding="utf-8", start_new_session=True,
    )
    process.stdout.readline()
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    infos = list(tmp_path.glob("*.thinpart.json"))
    assert infos  # what is told is written
    for info in infos:
        jsonschema.validate(json.loads(info.read_text(encoding="utf-8")), SCHEMA)
    run = thinpart("classify", tmp_path, "--json")
    assert run.returncode == 0 and len(records(run)) == 4


def test_temporary_folders_of_killed_runs_are_removed_by_the_next(tmp_path):
    folder = tmp_path / "parts"
    folder.mkdir()
    make_endless(folder / "hang.step")
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    elsewhere = environment(TMPDIR=str(temporary))

    def left():
        return {each.name for each in temporary.glob("thinpart-*")}

    def start():
        before = left()
        process = subprocess.Popen(
            [sys.executable, "-m", "thinpart_workbench", "classify", str(folder), "--no-info"],
            env=elsewhere, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True)
        time_limit.wait_until(lambda: any((temporary / name / "lock").exists() for name in left() - before),
                              "a temporary folder with its lock")
        return process, (left() - before).pop()

    foreign = temporary / "thinpart-run-of-somebody"
    foreign.mkdir()
    (temporary / "thinpart-run-link").symlink_to(folder)
    (folder / "lock").write_bytes(b"")
    killed, stale = start()
    os.killpg(killed.pid, signal.SIGKILL)
    killed.wait()
    running, used = start()
    try:
        assert stale not in left() and used in left()
        third, own = start()
        os.killpg(third.pid, signal.SIGINT)
        third.wait()
        assert used in left() and own not in left() and running.poll() is None
    finally:
        os.killpg(running.pid, signal.SIGKILL)
        running.wait()
    assert foreign.is_dir() and (folder / "lock").exists()

