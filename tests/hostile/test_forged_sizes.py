# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker that has gone wrong says of element sizes and maps: never a traceback, and never more than a row."""

import copy
import io
import json
import shutil

import pytest
from forged_workers import ForgedWorkers
from program import SAMPLES

from thinpart_workbench.api.mesh_sizes import write_shell_file, write_size_script
from thinpart_workbench.cli import main
from thinpart_workbench.cli.size_text import flat_row, print_part, print_sizes
from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.shells.shell_settings import ShellSettings
from thinpart_workbench.core.sizing.sizing_settings import SizingSettings
from thinpart_workbench.workflow.meshing import size_run
from thinpart_workbench.workflow.meshing.gmsh_program import gmsh_program
from thinpart_workbench.workflow.meshing.size_result import known_values, sizes_fault
from thinpart_workbench.workflow.meshing.size_task import SizeTask
from thinpart_workbench.workflow.workers import task_run

VALUES = (None, True, -1, 0, 1e300, "", "\ud800", [], {}, "=1+1")


@pytest.fixture(scope="module")
def honest():
    """A task, and what an honest worker said of it, with few places and, as of a thin part, a wall and a shell."""
    if shutil.which("gmsh") is None:
        pytest.skip("needs Gmsh")
    program, version = gmsh_program()
    task = SizeTask(str(SAMPLES / "wedge.step"), SizingSettings(), load_profile().content, program=program,
                    has_sources=True, shell=ShellSettings())
    outcome, = size_run.propose_for_documents([task], Limits(jobs=1), version, force=True)
    content = json.loads(json.dumps({key: value for key, value in outcome.items() if key != "file"}))
    part, = content["parts"]
    assert part["check"]["proposed"]["elements"]
    size = 0.25 * part["global_size"]
    part.update(
        inner=part["inner"][:20], least_size=size, layers=2.0, sources=[[*part["inner"][0], size, 1.0]] * 2,
        regions=[{"region": 1, "kind": "plate", "thickness": 1.0, "thinnest": 0.9, "area": 9.0, "length": 3.0, "width": 3.0,
                  "faces": ["Face1", "Face2"], "size": size, "layers": 2.0, "elements": 40, "group": 1}],
        region_groups=[{"regions": [1], "count": 1, "kind": "plate", "word": "plate", "thickness": 1.0, "thinnest": 0.9,
                        "area": 9.0, "length": 3.0, "width": 3.0, "faces": ["Face1", "Face2"], "size": size, "layers": 2.0,
                        "elements": 40}],
        gmsh_options=[{"name": "Mesh.Algorithm", "value": 5}])
    part["shell"].update(
        size=5.0, elements=2, nodes=9, volume_share=0.9, reason="", thickness=[1.0, 1.0], wall=[0, 0],
        triangles=[[0, 2, 8, 1, 5, 4], [0, 8, 6, 4, 7, 3]], points=[[2.5 * (k % 3), 2.5 * (k // 3), 0.0] for k in range(9)],
        solid={"nodes": 10, "elements": 1, "volume_share": 0.1, "points": [[0.0, 0.0, 1.0 * k] for k in range(10)],
               "tetrahedra": [list(range(10))], "tied": [0, 1], "sides": [[0, 0]]},
        warnings=["It is one."], walls=[{"wall": 1, "thickness": 1.0, "area": 25.0, "faces": ["Face1", "Face2"]}],
        left_solid=[{"kind": "plate", "thickness": 1.0, "volume_share": 0.1, "faces": ["Face3"]}])
    return task, content


def _changes(content, path=()):
    """Every place of a JSON value, by the keys that lead there."""
    if path:
        yield path
    if isinstance(content, dict):
        for key, value in content.items():
            yield from _changes(value, (*path, key))
    elif isinstance(content, list) and content:
        yield from _changes(content[0], (*path, 0))


def _changed(content, path, value):
    changed = copy.deepcopy(content)
    *way, last = path
    place = changed
    for key in way:
        place = place[key]
    if value is KeyError:
        del place[last]
    else:
        place[last] = value
    return changed


def _used(task, content, folder, endings=(".geo", ".inp", ".msh", ".unv")):
    """All that is done with a result that has no fault; of the files, those with some endings are written."""
    part, stream = content["parts"][0], io.StringIO()
    print_part(stream, task.file, part)
    print_sizes(stream, [(task.file, each) for each in content["parts"]])
    flat_row(task.file, part)
    for ending in endings:
        try:
            if ending == ".geo":
                write_size_script(folder / "s.geo", part, task.file, content["solids"])
            else:
                write_shell_file(folder / f"s{ending}", part)
        except ThinPartError as error:
            assert error.kind == "no_shell"


def test_what_has_no_fault_can_be_used(honest, tmp_path, capsys):
    task, content = honest
    assert sizes_fault(content, task) is None
    _used(task, content, tmp_path)
    tried, used = 0, 0
    for path in _changes(content):
        endings = [".inp", ".msh", ".unv"] if "shell" in path else [".geo"]
        for value in (*VALUES, KeyError):
            changed = _changed(content, path, value)
            tried += 1
            if sizes_fault(changed, task) is None and changed["parts"]:
                used += 1
                try:
                    _used(task, changed, tmp_path, endings)
                except Exception as error:
                    raise AssertionError(f"{path} = {value!r}") from error
    assert tried > 1000 and used > 100


@pytest.fixture
def said(monkeypatch, tmp_path, capfd):
    """The status and the words of a command whose worker answers with something."""
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))

    def run(answer, *arguments):
        monkeypatch.setattr(task_run, "ProcessPool", ForgedWorkers.that_answer(answer))
        status = main([str(each) for each in arguments])
        output = capfd.readouterr()
        assert "Traceback" not in output.out + output.err
        return status, output.out + output.err

    return run


FAILED = {"file": "x", "error": {"kind": "crash", "message": "It failed."}}
NONE = [None, 7, "x", [], {}, [[]], {"error": 5}, {"error": None, "parts": []}, FAILED, {**FAILED, "parts": 7},
        {**FAILED, "parts": [7], "failures": "x"}, {**FAILED, "error": {"kind": "crash", "message": 7}}]


@pytest.mark.parametrize("answer", NONE)
def test_what_is_no_answer_is_a_failure_of_the_file(said, tmp_path, answer):
    status, words = said(answer, "size", SAMPLES / "plate.step", "--csv", tmp_path / "t.csv")
    assert status == 1 and ("plate.step" in words or "It failed." in words)
    status, words = said(answer, "map", SAMPLES / "plate.step", "--png", tmp_path / "m.png")
    assert status == 1 and ("plate.step" in words or "It failed." in words) and not (tmp_path / "m.png").exists()


@pytest.mark.parametrize("change", [{"error": 5}, {"error": {"kind": "usage"}}, {"confinement": [[7]]}, {"seconds": "x"}])
def test_what_no_answer_has_is_left_out(honest, said, change):
    _, content = honest
    status, words = said({**content, **change}, "size", SAMPLES / "wedge.step", "--json")
    assert status == 0 and '"global_size"' in words
    assert known_values({**content, **change}) == content


@pytest.mark.parametrize("key", ["check", "shell", "sources", "box", "inner"])
def test_what_was_asked_for_and_is_missing_is_a_failure(honest, key):
    task, content = honest
    lacking = _changed(content, ("parts", 0, key), None if key == "check" else KeyError)
    assert key in sizes_fault(lacking, task)


@pytest.mark.parametrize("change", [{"label": 7}, {"low": "x"}, {"high": None}, {"thinnest": -1}, {"contents": {}},
                                    {"contents": {".png": "a"}}, {"contents": {".png": "\u00e4"}}, {"contents": 7}])
def test_a_map_that_is_none_is_a_failure(said, tmp_path, change):
    answer = {"label": "plate", "thinnest": 1.0, "low": 0.0, "high": 1.0, "contents": {".png": "QUJD"}, **change}
    status, words = said(answer, "map", SAMPLES / "plate.step", "--png", tmp_path / "m.png")
    assert status == 1 and "plate.step" in words and not (tmp_path / "m.png").exists()
