# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gmsh runs no name of a part, and no file that only looks like one: in scripts that are written, and those that are run."""

import itertools
import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest
from program import SAMPLES, thinpart

from thinpart_workbench.api.mesh_sizes import FileChoice, MeshRequest, mesh_sizes, write_size_script
from thinpart_workbench.core.file_formats import FORMATS, SHAPE
from thinpart_workbench.storage.exchange.gmsh_shape import is_opened_as_shape

pytestmark = pytest.mark.skipif(not shutil.which("gmsh"), reason="Gmsh is not installed")

COMMAND = 'SystemCall "touch PWNED";'
"""What Gmsh would run, in the folder in which it is started."""

HELD = ["bracket.step", "Größe 1.stp", "%n%s.STEP", "semi;colon'.brep"]
"""Names that a script may say."""

REFUSED = ["a\"; SystemCall 'touch PWNED'; .step", "back\\slash.step", "line\nbreak.step", "bell\x07.step",
           os.fsdecode(b"caf\xe9.step"), "spelled.Step", "spelled.BREP", "spelled.Igs", "C:drive.step", ".step"]


def shape_file(path, part):
    """A part at a path, in the format of its ending."""
    kind = path.suffix.lower() or path.name.lower()
    if kind in (".step", ".stp"):
        part.exportStep(os.fspath(path.parent / "made.step"))
    elif kind == ".igs":
        part.exportIges(os.fspath(path.parent / "made.step"))
    else:
        part.exportBrep(os.fspath(path.parent / "made.step"))
    os.rename(path.parent / "made.step", path)
    return path


@pytest.fixture(scope="module")
def plate(freecad):
    import Part

    return Part.makeBox(40, 20, 1)


@pytest.fixture(scope="module")
def proposal(plate, tmp_path_factory):
    """What is proposed for the plate."""
    file = tmp_path_factory.mktemp("proposal") / "plate.step"
    plate.exportStep(str(file))
    outcome, = mesh_sizes(file, MeshRequest(has_sources=True), files=FileChoice(force=True))
    return outcome["parts"][0]


def opened(script):
    """Number of faces that Gmsh has where it opens a script, and the errors that it states; it may have run nothing."""
    counting = script.parent / "count.geo"
    counting.write_text(f'Merge "{script.name}";\nfound[] = Surface{{:}};\nPrintf("%g", #found[]) > "count";\n')
    ran = subprocess.run(["gmsh", counting.name, "-0", "-v", "1"], cwd=script.parent, timeout=60, check=False,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", errors="replace")
    top = next(each for each in script.parents if each.name.startswith("test_"))
    assert not list(top.rglob("PWNED*")), ran.stdout
    return int((script.parent / "count").read_text()), [line for line in ran.stdout.splitlines() if "Error" in line]


def merged(script):
    return next(line for line in script.read_text(encoding="utf-8").splitlines() if line.startswith("Merge "))


@pytest.mark.parametrize("name", HELD + REFUSED, ids=ascii)
def test_a_script_opens_the_part_whatever_its_name(name, plate, proposal, tmp_path):
    file = shape_file(tmp_path / name, plate)
    before, script = file.read_bytes(), tmp_path / "sizes.geo"
    copy = write_size_script(script, proposal, os.fspath(file))
    assert (copy is None) == (name in HELD)
    assert merged(script) == f'Merge "{copy or name}";'
    if copy is not None:
        assert copy == f"sizes.part.{'brep' if 'BREP' in name else 'iges' if 'Igs' in name else 'step'}"
        assert (tmp_path / copy).read_bytes() == before
    assert opened(script) == (6, []) and file.read_bytes() == before


@pytest.mark.parametrize("folder", ["b\"; SystemCall 'touch PWNED'; ", "\\", "/".join(["long" * 50] * 6)],
                         ids=["quotes", "backslash", "long"])
def test_a_script_opens_the_part_whatever_its_folder(folder, plate, proposal, tmp_path):
    (tmp_path / folder).mkdir(parents=True)
    file, script = shape_file(tmp_path / folder / "part.step", plate), tmp_path / "sizes.geo"
    assert write_size_script(script, proposal, os.fspath(file)) == "sizes.part.step"
    assert opened(script) == (6, [])
    beside = tmp_path / folder / "own.geo"  # from there, the path has nothing of the folder's name
    assert write_size_script(beside, proposal, os.fspath(file)) is None and merged(beside) == 'Merge "part.step";'
    assert opened(beside) == (6, [])


@pytest.mark.parametrize("name", ["x\"; SystemCall 'touch PWNED'; .geo", "line\nbreak.geo", os.fsdecode(b"\xe9.geo"),
                                  "\".geo"], ids=ascii)
def test_a_script_opens_the_part_whatever_its_own_name(name, plate, proposal, tmp_path):
    file = shape_file(tmp_path / "part.Step", plate)
    copy = write_size_script(tmp_path / name, proposal, os.fspath(file))
    os.rename(tmp_path / name, tmp_path / "renamed.geo")
    assert copy.isascii() and copy.endswith(".part.step") and merged(tmp_path / "renamed.geo") == f'Merge "{copy}";'
    assert opened(tmp_path / "renamed.geo") == (6, [])


def test_a_script_that_is_called_like_the_part_is_not_run_with_it(plate, proposal, tmp_path):
    file, script = shape_file(tmp_path / "part.step", plate), tmp_path / "sizes.geo"
    for name in ("part.step.opt", "sizes.part.step.opt"):
        (tmp_path / name).write_text(COMMAND)
    assert write_size_script(script, proposal, os.fspath(file)) == "sizes-2.part.step"
    assert opened(script) == (6, [])


def test_gmsh_takes_no_ending_that_is_merged_for_one_of_scripts(tmp_path):
    spellings = {"." + "".join(letters) for each in FORMATS if each.kind == SHAPE for ending in each.endings
                 for letters in itertools.product(*({letter, letter.upper()} for letter in ending[1:]))}
    taken = sorted(each for each in spellings if is_opened_as_shape(f"part{each}", tmp_path))
    assert {".step", ".stp", ".STEP", ".STP", ".igs", ".iges", ".brep"} <= set(taken)
    assert not {".Step", ".Stp", ".BREP", ".Brep", ".Iges"} & set(taken)
    script = tmp_path / "all.geo"
    for ending in taken:
        (tmp_path / f"part{ending}").write_text(COMMAND)
    script.write_text("".join(f'Merge "part{each}";\n' for each in taken))
    assert opened(script)[0] == 0


def test_no_file_is_replaced_by_a_part_that_was_mended(plate, proposal, tmp_path):
    file, own = shape_file(tmp_path / "part.step", plate), tmp_path / "sizes.mended.brep"
    own.write_text("mine")
    mended = {**proposal, "mended_shape": plate.exportBrepToString()}
    for _ in range(2):  # the second one takes the file of the first
        assert write_size_script(tmp_path / "sizes.geo", mended, os.fspath(file)) == "sizes-2.mended.brep"
        assert merged(tmp_path / "sizes.geo") == 'Merge "sizes-2.mended.brep";' and own.read_text() == "mine"
    assert opened(tmp_path / "sizes.geo") == (6, [])
    # Also where it is the part itself, or a link that leads nowhere.
    copied = shutil.copyfile(tmp_path / "part.step", tmp_path / "own.mended.brep")
    (tmp_path / "own-2.mended.brep").symlink_to(tmp_path / "nowhere")
    assert write_size_script(tmp_path / "own.geo", mended, os.fspath(copied)) == "own-3.mended.brep"
    assert copied.read_bytes() == file.read_bytes() and not (tmp_path / "nowhere").exists()


def test_a_copy_is_as_secret_as_the_part(plate, proposal, tmp_path):
    file = shape_file(tmp_path / "part.Step", plate)
    file.chmod(0o600)
    copy = write_size_script(tmp_path / "sizes.geo", proposal, os.fspath(file))
    assert (tmp_path / copy).stat().st_mode & 0o777 == 0o600


def test_what_the_program_has_gmsh_mesh_is_not_run(plate, tmp_path, monkeypatch):
    """A valid STEP file with a spelling for which Gmsh runs its header, in a folder that is a command, beside a script."""
    monkeypatch.setenv("THINPART_CONFINEMENT", "none")  # which would hide that something is run
    folder = tmp_path / "b\"; SystemCall 'touch PWNED'; "
    folder.mkdir()
    made = shape_file(tmp_path / "plate.step", plate).read_text()
    pwned = tmp_path / "PWNED"
    start = made.index("FILE_DESCRIPTION(('") + len("FILE_DESCRIPTION(('")
    file = folder / "part.Step"
    file.write_text(f'{made[:start]}"{"x" * 1200}; SystemCall "touch {pwned}"; {made[start:]}')
    (folder / "part.Step.opt").write_text(f'SystemCall "touch {pwned}";')
    run = thinpart("size", file, "--check", "--json", "--geo", folder / "sizes.geo", "--force")
    assert run.returncode == 0, run.stderr
    assert json.loads(run.stdout)["check"]["proposed"]["elements"] > 0
    assert not pwned.exists() and not list(tmp_path.rglob("PWNED*"))
    assert merged(folder / "sizes.geo") == 'Merge "sizes.part.step";'
    assert opened(folder / "sizes.geo") == (6, [])
    # Gmsh by itself would have run it: otherwise this test would show nothing.
    subprocess.run(["gmsh", file.name, "-0", "-v", "0"], cwd=folder, timeout=60, check=False)
    assert pwned.exists()


def test_a_name_that_is_not_text_costs_no_row(tmp_path):
    for name in (os.fsdecode(b"caf\xe9\x1b[2J.step"), "plate.step"):
        shutil.copyfile(SAMPLES / "plate.step", tmp_path / name)
    table = tmp_path / "table.csv"
    run = thinpart("size", tmp_path, "--csv", table)
    assert (run.returncode, run.stderr) == (0, "")
    text = table.read_text(encoding="utf-8")
    assert "\x1b" not in text + run.stdout
    assert {Path(row.split(",")[0]).name for row in text.splitlines()[1:]} == {"plate.step", r"caf\udce9\x1b[2J.step"}
