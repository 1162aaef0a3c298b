"""The program as people start it, on real files."""

import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import made_meshes

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "resources" / "samples"
SCHEMA = json.loads((ROOT / "resources" / "info-file.schema.json").read_text(encoding="utf-8"))


def thinpart(*arguments, cwd=None, **options):
    environment = dict(os.environ, PYTHONPATH=str(ROOT), COLUMNS="200")
    return subprocess.run(
        [sys.executable, "-m", "thinpart_workbench", *map(str, arguments)], cwd=cwd,
        env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300,
        **options,
    )


def records(run):
    return [json.loads(line) for line in run.stdout.splitlines()]


def failures(run):
    return {Path(line["file"]).name: line["error"]["kind"] for line in records(run)
            if "error" in line}


def bad_row(tmp_path, name, content, *arguments):
    """Classify one bad file beside a good one: the good one must go on."""
    folder = tmp_path / "parts"
    folder.mkdir()
    shutil.copy(SAMPLES / "wedge.step", folder)
    (folder / name).write_bytes(content)
    run = thinpart("classify", folder / name, folder / "wedge.step", "--json", *arguments)
    good = [line for line in records(run) if line.get("category")]
    assert run.returncode == 1 and [line["category"] for line in good] == ["thin_features"]
    assert name in run.stderr and "Traceback" not in run.stderr
    assert not list(folder.glob(f"{name}*.json")) and not list(folder.glob(".thinpart*"))
    return failures(run)[name]


# -- what it is for


def test_every_sample_gets_its_verdict_in_both_formats():
    run = thinpart("classify", SAMPLES, "--json", "--no-info")
    assert run.returncode == 0, run.stderr
    expected = {
        entry["name"]: entry.get("solids") or [entry]
        for entry in json.loads((SAMPLES / "samples.json").read_text(encoding="utf-8"))
    }
    found = {}
    for record in records(run):
        found.setdefault(Path(record["file"]), []).append(record)
    assert len(found) == 2 * len(expected) >= 24
    for file, parts in found.items():
        # A STEP file does not say which solids are copies of one.
        verdicts = {(part["category"], tuple(part["criteria"])) for part in parts}
        assert verdicts == {(each["category"], tuple(each["criteria"]))
                            for each in expected[file.stem]}, file
    criteria = {each for parts in found.values() for part in parts for each in part["criteria"]}
    assert criteria == {1, 2, 3, 4, 5, 6, 7}


def test_an_assembly_gives_one_record_per_distinct_solid():
    run = thinpart("classify", SAMPLES / "assembly_of_three.FCStd", "--json", "--no-info")
    assert {(each["label"], each["instances"]) for each in records(run)} == {
        ("Base block", 1), ("Cover plate", 1), ("Dowel pin", 2)}


def test_table_names_part_category_criteria_box_fill_and_wall(tmp_path):
    run = thinpart("classify", SAMPLES / "plate.FCStd", "--info-dir", tmp_path)
    assert run.returncode == 0
    header, row = run.stdout.splitlines()[:2]
    assert header.split() == "Part Category Criteria D1 x D2 x D3 mm V/VBB Thinnest mm".split()
    assert re.match(r"Mounting plate\s+thin\s+1, 4, 5\s+[\d.]+ x [\d.]+ x [\d.]+\s+0\.\d+\s+[\d.]+$", row)


def test_demo_classifies_the_samples_and_leaves_nothing_behind():
    before = sorted(SAMPLES.iterdir())
    run = thinpart("demo")
    assert run.returncode == 0 and "thin_features" in run.stdout and "Worm" in run.stdout
    assert sorted(SAMPLES.iterdir()) == before


def test_real_parts_are_read_and_the_papers_sure_finds_are_found(real_samples):
    with open(real_samples / "manifest.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    run = thinpart("classify", real_samples / "parts", "--json", "--no-info")
    assert run.returncode == 0, run.stderr
    category = {}
    for record in records(run):
        category.setdefault("parts/" + Path(record["file"]).name, set()).add(record["category"])
    assert category.keys() == {row["file"] for row in rows}
    for row in rows:
        if row["expert_label"] == "thin" and row["confidence"] == "sure":
            assert "thin" in category[row["file"]], row["file"]
    assert not any("unknown" in found for found in category.values())


@pytest.mark.parametrize("ending", ["step", "iges", "brep", "stl", "ascii.stl", "obj", "ply", "off"])
def test_formats_agree(tmp_path, ending):
    import MeshPart
    import Part

    shape = Part.makeBox(100, 60, 40)
    file = tmp_path / f"block.{ending}"
    if ending in ("step", "iges", "brep"):
        getattr(shape, f"export{ending.capitalize()}")(str(file))
    else:
        mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.1, AngularDeflection=0.1)
        if ending == "ascii.stl":
            mesh.write(Filename=str(file), Format="AST")
        else:
            mesh.write(str(file))
    run = thinpart("classify", file, "--json")
    record, = records(run)
    assert run.returncode == 0 and record["category"] == "normal"
    assert record["descriptors"]["box_mm"] == pytest.approx([100, 60, 40], rel=1e-6)
    assert record["descriptors"]["watertight"]


def test_3mf_is_read_or_said_to_be_unreadable_here(tmp_path, freecad):
    import Mesh

    file = tmp_path / "box.3mf"
    try:
        Mesh.createBox(10, 10, 10).write(str(file))
    except Exception:  # 0.20 writes none; what it does with one is the question
        file.write_bytes(b"PK\x03\x04 nothing")
    run = thinpart("classify", file, "--json", "--no-info")
    record, = records(run)
    if run.returncode:
        assert record["error"]["kind"] == "unsupported"
    else:
        assert record["descriptors"]["volume_mm3"] == pytest.approx(1000, rel=1e-5)


# -- options


def test_info_files_beside_the_parts_and_unchanged_parts_taken_from_them(tmp_path):
    file = Path(shutil.copy(SAMPLES / "wedge.FCStd", tmp_path))
    first = thinpart("classify", file, "--json")
    info = tmp_path / "wedge.FCStd.thinpart.json"
    content = json.loads(info.read_text(encoding="utf-8"))
    jsonschema.validate(content, SCHEMA)
    written = info.stat().st_mtime_ns
    again = thinpart("classify", file, "--json")
    assert again.stdout == first.stdout and info.stat().st_mtime_ns == written
    thinpart("classify", file, "--force")
    assert info.stat().st_mtime_ns > written
    thinpart("classify", file, "--measure", "pairs")
    assert json.loads(info.read_text())["settings"]["measure"] == "pairs"


def test_a_touched_document_is_known_by_its_hash_a_changed_one_is_measured_again(tmp_path):
    file = Path(shutil.copy(SAMPLES / "wedge.step", tmp_path))
    thinpart("classify", file)
    info = tmp_path / "wedge.step.thinpart.json"
    before = info.read_bytes()
    os.utime(file, (1, 1))
    thinpart("classify", file)
    assert info.read_bytes() == before
    shutil.copy(SAMPLES / "block.step", file)
    assert thinpart("classify", file, "--json").stdout.count('"normal"')


def test_same_input_gives_the_same_bytes_apart_from_times(tmp_path):
    file = Path(shutil.copy(SAMPLES / "ribbed_block.step", tmp_path))
    contents = []
    for folder in ("a", "b"):
        thinpart("classify", file, "--info-dir", tmp_path / folder)
        text = (tmp_path / folder / "ribbed_block.step.thinpart.json").read_text()
        contents.append(re.sub(r'"(read|tessellate|measure)": [\d.]+', r'"\1": 0', text))
    assert contents[0] == contents[1]


def test_info_folder_mirrors_the_tree(tmp_path):
    inner = tmp_path / "parts" / "left" / "right"
    inner.mkdir(parents=True)
    shutil.copy(SAMPLES / "wedge.step", inner)
    shutil.copy(SAMPLES / "block.step", tmp_path / "parts")
    thinpart("classify", tmp_path / "parts", "--info-dir", tmp_path / "info")
    assert sorted(str(p.relative_to(tmp_path / "info")) for p in (tmp_path / "info").rglob("*.json")
                  ) == ["block.step.thinpart.json", "left/right/wedge.step.thinpart.json"]
    assert not list((tmp_path / "parts").rglob("*.json"))


def test_documents_of_one_name_in_two_folders_have_two_info_files(tmp_path):
    for folder, sample in (("a", "wedge"), ("b", "block")):
        (tmp_path / folder).mkdir()
        shutil.copy(SAMPLES / f"{sample}.step", tmp_path / folder / "part.step")
    thinpart("classify", "a", "b/part.step", "a/part.step", "--info-dir", "info", cwd=tmp_path)
    categories = {
        str(path.relative_to(tmp_path / "info")): json.loads(path.read_text())["parts"][0]["category"]
        for path in (tmp_path / "info").rglob("*.json")
    }
    assert categories == {"a/part.step.thinpart.json": "thin_features",
                          "b/part.step.thinpart.json": "normal"}


def test_folders_offer_what_can_be_read():
    from thinpart_workbench.freecad_adapter.part_files import READERS
    from thinpart_workbench.workflow.find_documents import ENDINGS

    assert set(ENDINGS) == set(READERS)


def test_loops_of_links_are_walked_once(tmp_path):
    (tmp_path / "deep").mkdir()
    shutil.copy(SAMPLES / "wedge.step", tmp_path / "deep")
    (tmp_path / "deep" / "loop").symlink_to(tmp_path)
    assert len(records(thinpart("classify", tmp_path, "--json", "--no-info"))) == 1


def test_csv_has_a_row_per_part_and_failure(tmp_path):
    (tmp_path / "bad.step").write_bytes(b"")
    shutil.copy(SAMPLES / "plate.step", tmp_path)
    table = tmp_path / "table.csv"
    run = thinpart("classify", tmp_path, "--no-info", "--csv", table)
    assert run.returncode == 1
    with open(table, newline="", encoding="utf-8") as file:
        rows = {Path(row["file"]).name: row for row in csv.DictReader(file)}
    assert rows["plate.step"]["category"] == "thin" and rows["bad.step"]["error_kind"] == "empty"


def test_own_profile_and_the_papers_verdict_beside_it(tmp_path):
    profile = json.loads((ROOT / "resources" / "profiles" / "paper.json").read_text())
    profile["name"] = "house"
    profile["categories"] = profile["categories"][1:]
    file = tmp_path / "house.json"
    file.write_text(json.dumps(profile))
    run = thinpart("classify", SAMPLES / "plate.step", "--json", "--no-info", "--profile", file)
    record, = records(run)
    assert record["category"] == "thin_features"
    assert record["paper"] == {"category": "thin", "criteria": [1, 4, 5]}


@pytest.mark.parametrize("arguments", [
    ["classify"], ["classify", "x", "--measure", "guess"], ["classify", "x", "--jobs", "0"],
    ["classify", "x", "--memory", "50"],
    ["classify", "x", "--profile", "no-such"], ["no-such-command"], ["classify", "x", "--nonsense"],
    [],
])
def test_wrong_usage_is_two(arguments):
    run = thinpart(*arguments)
    assert run.returncode == 2 and run.stderr and "Traceback" not in run.stderr


def test_paths_with_odd_names(tmp_path):
    for name in ("with space.step", "quote'\".step", "new\nline.step", "üñí.step", "-dash.step"):
        shutil.copy(SAMPLES / "wedge.step", tmp_path / name)
    run = thinpart("classify", tmp_path, "--json")
    assert run.returncode == 0 and len(records(run)) == 5
    assert len(list(tmp_path.glob("*.thinpart.json"))) == 5
    assert thinpart("classify", tmp_path).returncode == 0


# -- bad input: one clear row, the others go on


def step(shape, tmp_path, name="made.step"):
    file = tmp_path / name
    (shape.exportStep if name.endswith("step") else shape.exportBrep)(str(file))
    return file.read_bytes()


@pytest.mark.parametrize("ending", ["step", "iges", "brep", "FCStd", "stl", "obj", "ply", "off"])
def test_empty_files(tmp_path, ending):
    assert bad_row(tmp_path, f"empty.{ending}", b"") == "empty"


@pytest.mark.parametrize("ending", ["step", "iges", "brep", "FCStd", "stl", "obj", "ply", "off"])
def test_garbage(tmp_path, ending, rng):
    assert bad_row(tmp_path, f"bad.{ending}", rng.bytes(5000)) in ("unreadable", "crash")


@pytest.mark.parametrize("ending", ["step", "FCStd"])
@pytest.mark.parametrize("part", [0.5, 0.9])
def test_truncated(tmp_path, ending, part):
    whole = (SAMPLES / f"block.{ending}").read_bytes()
    assert bad_row(tmp_path, f"cut.{ending}", whole[:int(part * len(whole))]) in (
        "unreadable", "crash")


@pytest.mark.parametrize("form", ["binary", "ascii"])
def test_truncated_stl(tmp_path, form):
    import Mesh

    file = tmp_path / "box.stl"
    Mesh.createBox(10, 10, 10).write(Filename=str(file), Format="STL" if form == "binary" else "AST")
    assert bad_row(tmp_path, "cut.stl", file.read_bytes()[:-60]) == "unreadable"


def test_surfaces_and_wires_are_no_solid(tmp_path):
    import Part

    box = Part.makeBox(10, 10, 10)
    for name, shape in (("face", box.Faces[0]), ("shell", Part.makeShell(box.Faces[:5])),
                        ("wire", box.Wires[0]), ("nothing", Part.Compound([]))):
        folder = tmp_path / name
        folder.mkdir()
        assert bad_row(folder, f"{name}.brep", step(shape, tmp_path, "made.brep")) == "no_solid"


def test_documents_without_a_part(tmp_path, document):
    import Part

    file = tmp_path / "made.FCStd"
    for name, kind in (("empty", "empty"), ("null", "no_solid"), ("face", "no_solid")):
        if name == "null":
            document.addObject("Part::Feature", "Null")
        elif name == "face":
            document.addObject("Part::Feature", "Face").Shape = Part.makePlane(5, 5)
        document.saveAs(str(file))
        folder = tmp_path / name
        folder.mkdir()
        assert bad_row(folder, f"{name}.FCStd", file.read_bytes()) == kind


def test_coordinates_that_are_no_numbers(tmp_path):
    import Mesh

    file = tmp_path / "box.stl"
    Mesh.createBox(10, 10, 10).write(Filename=str(file), Format="AST")
    text = file.read_text()
    for name, content in (("nan.stl", re.sub(r"vertex\s+\S+", "vertex nan", text, count=3)),
                          ("inf.obj", "v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n")):
        folder = tmp_path / name
        folder.mkdir()
        assert bad_row(folder, name, content.encode()) == "not_finite"


def test_zero_volume(tmp_path):
    sheet = b"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n"
    assert bad_row(tmp_path, "sheet.off", sheet) == "zero_volume"


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
    for name, thing, says, category in (
        ("through.stl", stl(box, other), "passes through itself", None),
        ("open.stl", stl(box, cut=2), "open", "unknown"),
        ("inverted.stl", stl(box, flip=True), "inside-out", "normal"),
        ("tiny.brep", tiny, "unit", "normal"),
        ("reversed.brep", box.reversed(), "inside-out", "normal"),
    ):
        file = tmp_path / name
        (thing.exportBrep if name.endswith("brep") else thing.write)(str(file))
        record, = records(thinpart("classify", file, "--json", "--no-info"))
        assert any(says in warning for warning in record["warnings"]), (name, record["warnings"])
        assert category in (None, record["category"])


def test_a_solid_far_from_the_origin(tmp_path):
    import FreeCAD
    import Part

    box = Part.makeBox(100, 100, 2)
    box.translate(FreeCAD.Vector(1e6, -1e6, 1e6))
    file = tmp_path / "far.brep"
    box.exportBrep(str(file))
    record, = records(thinpart("classify", file, "--json", "--no-info"))
    assert record["criteria"] == [1, 4, 5]
    assert record["descriptors"]["thickness_mm"]["min"] == pytest.approx(2, rel=1e-6)
    assert record["faces"][0]["witness"]["points"][0] == pytest.approx([1e6, -1e6, 1e6], rel=1e-3)


def test_a_file_that_ends_its_reader_is_one_row(tmp_path, rng):
    """References to anything: the reader follows them and dies; the row says so."""
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
    run = thinpart("classify", folder, "--json", "--no-info", "--timeout", "20")
    kinds = set(failures(run).values())
    assert len(records(run)) == 9 and "crash" in kinds
    assert kinds <= {"crash", "unreadable", "no_solid", "timeout", "zero_volume", "memory"}
    assert [r["category"] for r in records(run) if r["file"].endswith("good.step")] == [
        "thin_features"]


def test_a_file_that_never_ends_is_one_row(tmp_path):
    os.mkfifo(tmp_path / "hang.step")
    shutil.copy(SAMPLES / "wedge.step", tmp_path / "good.step")
    run = thinpart("classify", tmp_path, "--json", "--no-info", "--timeout", "6")
    assert failures(run) == {"hang.step": "timeout"} and len(records(run)) == 2


def test_too_little_memory_is_one_row(tmp_path):
    points, triangles = made_meshes.sphere(20, 800)
    facets = np.zeros(len(triangles), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)),
                                       ("flags", "<u2")])
    facets["corners"] = points[triangles]
    head = b"\0" * 80 + len(triangles).to_bytes(4, "little")
    assert bad_row(tmp_path, "large.stl", head + facets.tobytes(), "--memory", "700") == "memory"


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
    assert run.returncode == 1 and lines[0]["category"] == "thin_features"
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
    file = Path(shutil.copy(SAMPLES / "wedge.step", tmp_path))
    info = tmp_path / "wedge.step.thinpart.json"
    for content in ('{"format": "thinpart-info", "version": 99}', "something else", ""):
        info.write_text(content)
        run = thinpart("classify", file, "--json")
        assert run.returncode == 1 and info.read_text() == content
        assert [r["error"]["kind"] for r in records(run) if "error" in r] == ["info_write"]


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
         "--jobs", "1"], env=dict(os.environ, PYTHONPATH=str(ROOT)), stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
    )
    first = process.stdout.readline()
    os.killpg(process.pid, signal.SIGINT)
    rest, errors = process.communicate(timeout=60)
    assert process.returncode == 130 and "Traceback" not in errors
    done = len((first + rest).splitlines())
    infos = list(tmp_path.glob("*.thinpart.json"))
    assert 1 <= done < 6 and len(infos) >= done
    for info in infos:
        jsonschema.validate(json.loads(info.read_text(encoding="utf-8")), SCHEMA)
    assert _ended(process.pid)


def test_kill_9_leaves_no_half_written_file(tmp_path):
    for number in range(4):
        shutil.copy(SAMPLES / "wedge.step", tmp_path / f"{number}.step")
    process = subprocess.Popen(
        [sys.executable, "-m", "thinpart_workbench", "classify", str(tmp_path), "--json"],
        env=dict(os.environ, PYTHONPATH=str(ROOT)), stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, start_new_session=True,
    )
    process.stdout.readline()
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    for info in tmp_path.glob("*.thinpart.json"):
        jsonschema.validate(json.loads(info.read_text(encoding="utf-8")), SCHEMA)
    run = thinpart("classify", tmp_path, "--json")
    assert run.returncode == 0 and len(records(run)) == 4


def _ended(group):
    for _ in range(50):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.1)
    return False
