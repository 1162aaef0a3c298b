# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that Gmsh does not mesh at first: what is tried, and what comes of it. Settings that worked, kept and offered."""

import json
import shutil
import subprocess

import made_meshes
import pytest
from program import thinpart

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.sizing.size_proposal import propose_sizes
from thinpart_workbench.core.sizing.sizing_settings import SizingSettings
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.freecad_adapter.shapes.mended_solid import write_mended
from thinpart_workbench.storage.exchange.msh_file import read_tetrahedra
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.workflow.meshing.gmsh_program import CRASHED, TIMEOUT
from thinpart_workbench.workflow.meshing.mesh_tries import MeshTries

pytestmark = pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed")


@pytest.fixture(autouse=True)
def own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))


@pytest.fixture
def joined(tmp_path):
    """Two plates side by side, made one solid without being fused: the faces between them lie on each other."""
    import FreeCAD
    import Part

    first, second = Part.makeBox(40, 30, 2), Part.makeBox(25, 30, 2, FreeCAD.Vector(40, 0, 0))
    solid = Part.Solid(Part.makeShell(first.Faces + second.Faces))
    path = tmp_path / "joined.brep"
    solid.exportBrep(str(path))
    return path


def lines(*arguments):
    run = thinpart("size", *arguments, "--json")
    return [json.loads(line) for line in run.stdout.splitlines()], run


def test_faces_that_lie_on_each_other_are_taken_out_and_the_rest_is_the_same_solid(joined, tmp_path):
    import Part

    output = tmp_path / "mended.brep"
    assert write_mended(joined, output)
    mended = Part.Shape()
    mended.read(str(output))
    solid, = mended.Solids
    assert solid.isValid() and len(solid.Faces) == 10 and solid.Volume == pytest.approx(65 * 30 * 2)


def test_a_sound_solid_is_not_mended(tmp_path):
    import Part

    Part.makeBox(4, 3, 2).cut(Part.makeCylinder(1, 5)).exportBrep(str(tmp_path / "sound.brep"))
    assert not write_mended(tmp_path / "sound.brep", tmp_path / "mended.brep")
    assert not (tmp_path / "mended.brep").exists()


def test_the_script_opens_the_mended_part_and_gives_its_mesh(joined, tmp_path):
    script = tmp_path / "sizes.geo"
    (line,), run = lines(joined, "--check", "--geo", script)
    assert run.returncode == 0, run.stderr
    check = line["check"]
    assert not check["default"]["elements"] and check["proposed"]["elements"] and line["is_mended"]
    assert [each["what"] for each in check["proposed"]["tries"]] == [
        "as proposed", "faces that lie on each other taken out"]
    assert check["proposed"]["layers_share"] > 0.9 and "mended_shape" not in line
    assert 'Merge "sizes.mended.brep";' in script.read_text()
    mesh = tmp_path / "mesh.msh"
    subprocess.run(["gmsh", script.name, "-3", "-format", "msh2", "-bin", "-nt", "1", "-o", mesh, "-v", "2"],
                   cwd=tmp_path, check=True, timeout=300)
    assert len(read_tetrahedra(mesh)[1]) == pytest.approx(check["proposed"]["elements"], rel=0.05)
    assert "Meshed: faces that lie on each other taken out" in thinpart("size", joined, "--check").stdout


@pytest.fixture
def bar(tmp_path):
    """A slender one with a hole in each end."""
    import FreeCAD
    import Part

    bar = Part.makeCylinder(4, 360)
    for place, way in ((0, 1), (360, -1)):
        bar = bar.cut(Part.makeCylinder(1.6, 15, FreeCAD.Vector(0, 0, place), FreeCAD.Vector(0, 0, way)))
    bar.exportStep(str(tmp_path / "bar.step"))
    return tmp_path / "bar.step"


def test_a_slender_bar_that_fails_at_one_size_gets_sizes_all_over(bar):
    # As large as a tenth of the diagonal, elements are four times as long as the bar is thick.
    (line,), run = lines(bar, "--check", "--profile", "calibrated", "--order", 1)
    assert run.returncode == 0, run.stderr
    default, proposed = line["check"]["default"], line["check"]["proposed"]
    if default["elements"]:  # some versions of Gmsh mesh it: then it stays as it was
        assert proposed == default
    else:
        assert proposed["elements"] > 500 and proposed["poor_share"] < 0.03
        assert line["least_size"] < 4.0 and line["layers"] == 0.0 and line["regions"] == []
        assert "since it is not meshed with larger ones" in thinpart("size", bar, "--check", "--profile", "calibrated",
                                                                     "--order", 1).stdout


def test_where_elements_for_a_large_error_cross_a_bar_they_get_no_larger_than_it_is_thick(bar):
    """Some versions of Gmsh get lost between facets that cross, in an endless loop."""
    (line,), run = lines(bar, "--check", "--error", 10, "--mesh-timeout", 5)
    assert run.returncode == 0, run.stderr
    proposed = line["check"]["proposed"]
    assert proposed["elements"] > 100 and line["order"] == 2
    assert (line["error"] is None) == any(each["what"] == "no element larger than the part is thick there"
                                          for each in proposed["tries"])


HXT = {"Mesh.Algorithm3D": 10}


def tries_of(measurement, folder, **settings):
    return MeshTries(measurement, propose_sizes(measurement, 10.0, SizingSettings(**settings)), str(folder / "part.brep"),
                     str(folder))


LAYERED = {"order": 1, "growth": 1.4}
"""Two layers of elements of first order in thin walls."""


def test_a_mesh_that_takes_too_long_is_tried_in_a_quicker_way_and_then_with_a_fifth_of_the_elements(tmp_path):
    tries = tries_of(measure(surface_mesh(*made_meshes.box(100, 80, 2)), AnalysisSettings()), tmp_path, **LAYERED)
    proposal, quicker = tries.first.proposal, tries.after(tries.first, TIMEOUT, "")
    assert tries.first.options == {} and quicker.options == HXT and quicker.proposal is proposal
    fewer = tries.after(quicker, TIMEOUT, "")
    assert fewer.options == HXT and 0 < fewer.proposal.elements <= proposal.elements / 5
    assert fewer.proposal.layers < proposal.layers
    assert tries.after(fewer, TIMEOUT, "") is None


def test_many_elements_are_made_in_the_quicker_way_at_first(tmp_path):
    plate = measure(surface_mesh(*made_meshes.box(300, 200, 2)), AnalysisSettings())
    tries = tries_of(plate, tmp_path, **LAYERED)
    assert tries.first.proposal.elements > 400_000 and tries.first.options == HXT
    other = tries.after(tries.first, "Gmsh should be compiled with Hxt to enable that option",
                        "Error   : Gmsh should be compiled with Hxt to enable that option")
    assert other.options == {} and other.proposal is tries.first.proposal
    assert tries_of(plate, tmp_path, **LAYERED).after(tries.first, "Invalid boundary mesh", "").options == {}


def test_a_knife_edge_that_takes_too_many_elements_gets_fewer_layers_and_the_walls_keep_theirs(tmp_path):
    """A plate of 2 mm, 100 long, that has a blade of 0.05 mm and 2 mm on one side."""
    blade = [(0, 0), (2, 0), (2, 100), (0.05, 102), (0, 102)]
    tries = tries_of(measure(surface_mesh(*made_meshes.prism(blade, 80)), AnalysisSettings()), tmp_path, **LAYERED)
    quicker = tries.first if tries.first.options else tries.after(tries.first, TIMEOUT, "")
    proposal, coarser = quicker.proposal, tries.after(quicker, TIMEOUT, "")
    assert coarser.proposal.elements < 0.5 * proposal.elements and coarser.proposal.layers == 2.0
    assert coarser.proposal.least_size > 2.0 * proposal.least_size and 0.05 < coarser.proposal.layered_from <= 2.01
    fewer = tries.after(coarser, TIMEOUT, "")
    assert fewer is None or fewer.proposal.elements <= proposal.elements / 5


def test_where_few_elements_for_an_error_take_too_long_they_get_no_larger_than_the_part_is_thick(tmp_path):
    tries = tries_of(measure(surface_mesh(*made_meshes.box(200, 8, 8)), AnalysisSettings()), tmp_path, error=0.1)
    first = tries.first.proposal
    smaller = tries.after(tries.first, TIMEOUT, "")
    assert first.error == 0.1 and first.least_size > 8.0 >= smaller.proposal.field.at(first.inner.points[0]).max()
    assert smaller.proposal.elements > first.elements and smaller.proposal.error is None
    quicker = tries.after(smaller, TIMEOUT, "")
    assert quicker.options == HXT and quicker.proposal is smaller.proposal


def test_many_elements_for_an_error_get_fewer_and_the_error_is_said(tmp_path):
    block = measure(surface_mesh(*made_meshes.box(100, 80, 60)), AnalysisSettings())
    tries = tries_of(block, tmp_path, error=0.005, size=3.0)
    first = tries.first.proposal
    assert first.elements > 20_000
    fewer = tries.after(tries.after(tries.first, TIMEOUT, ""), TIMEOUT, "")
    assert fewer.what == "a larger error, a fifth of the elements" and fewer.proposal.elements <= first.elements / 5
    assert fewer.proposal.error > first.error == 0.005 and fewer.proposal.layered_from == 0.0


def test_a_crash_is_tried_once_more_in_another_way(tmp_path):
    plate = measure(surface_mesh(*made_meshes.box(100, 80, 2)), AnalysisSettings())
    tries = MeshTries(plate, propose_sizes(plate, 10.0, SizingSettings()), str(tmp_path / "part.brep"), str(tmp_path))
    other = tries.after(tries.first, CRASHED, "")
    assert other.options == {"Mesh.Algorithm": 5} and other.proposal is tries.first.proposal
    assert tries.after(other, CRASHED, "") is None


@pytest.fixture
def library(tmp_path):
    """A bracket that was classified, in a folder, and one like it elsewhere, twice as large."""
    import Part

    for folder, scale in (("library", 1.0), ("new", 2.0)):
        (tmp_path / folder).mkdir()
        sheet = Part.makeBox(30, 20, 2).fuse(Part.makeBox(2, 20, 15)).removeSplitter()
        sheet.scale(scale)
        sheet.exportStep(str(tmp_path / folder / f"{folder}.step"))
    assert thinpart("classify", tmp_path / "library" / "library.step").returncode == 0
    return tmp_path


def test_settings_that_worked_are_kept_and_taken_for_a_part_alike(library):
    known, new = library / "library" / "library.step", library / "new" / "new.step"
    (line,), run = lines(known, "--check", "--keep", "--layers", 1, "--growth", 1.6, "--size", 6)
    assert run.returncode == 0, run.stderr
    info = library / "library" / "library.step.thinpart.json"
    meshed = read_info(info)["parts"][0]["meshed"]
    assert (meshed["layers"], meshed["growth"], meshed["size_mm"]) == (1.0, 1.6, 6.0)
    assert meshed["elements"] == line["check"]["proposed"]["elements"] and meshed["how"] == "as proposed"
    run = thinpart("size", new, "--like", library / "library")
    assert "Settings that worked for library" in run.stdout and "1 layers" in run.stdout
    # What is said beside it counts.
    (line,), _ = lines(new, "--like", library / "library", "--growth", 1.2)
    assert (line["wanted_layers"], line["growth"]) == (1.0, 1.2)
    assert line["global_size"] == pytest.approx(12.0, rel=1e-3)  # as large by the part


def test_an_error_that_worked_is_kept_and_taken_for_a_part_alike(library):
    known, new = library / "library" / "library.step", library / "new" / "new.step"
    _, run = lines(known, "--check", "--keep", "--error", 5)
    assert run.returncode == 0, run.stderr
    meshed = read_info(library / "library" / "library.step.thinpart.json")["parts"][0]["meshed"]
    assert (meshed["error"], meshed["layers"], meshed["order"]) == (0.05, None, 2)
    (line,), _ = lines(new, "--like", library / "library")
    assert (line["error"], line["order"]) == (0.05, 2)
    # What is said beside it counts.
    (line,), _ = lines(new, "--like", library / "library", "--error", 1)
    assert line["error"] == 0.01
    (line,), _ = lines(new, "--like", library / "library", "--layers", 2)
    assert (line["error"], line["wanted_layers"], line["order"]) == (None, 2.0, 2)


def test_an_error_counts_beside_layers_of_elements_of_first_order_that_worked(library):
    known, new = library / "library" / "library.step", library / "new" / "new.step"
    _, run = lines(known, "--check", "--keep", "--order", 1)
    assert run.returncode == 0, run.stderr
    (line,), _ = lines(new, "--like", library / "library")
    assert (line["error"], line["order"], line["wanted_layers"]) == (None, 1, 2.0)
    (line,), _ = lines(new, "--like", library / "library", "--error", 5)
    assert (line["error"], line["order"]) == (0.05, 2)


def test_without_settings_it_says_so_and_goes_on(library):
    run = thinpart("size", library / "new" / "new.step", "--like", library / "library")
    assert run.returncode == 0 and "has mesh settings that worked: the usual ones are used" in run.stdout
    assert "for an error of 2 % in deflections and frequencies" in run.stdout


@pytest.mark.parametrize("arguments, sentence", [
    (("--keep",), "--keep goes with --check"), (("--like", "."), "--like is for one part")])
def test_options_that_do_not_go_together_are_told(library, arguments, sentence):
    run = thinpart("size", library / "library", *arguments)
    assert run.returncode == 2 and sentence in run.stderr


def test_settings_of_a_part_without_an_info_file_are_not_kept_and_that_is_said(library):
    run = thinpart("size", library / "new" / "new.step", "--check", "--keep", "--layers", 0.5)
    assert run.returncode == 1 and "Traceback" not in run.stderr and "new.step" in run.stderr
