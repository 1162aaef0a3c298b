# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis that *Prepare mesh* leaves: with a support and a force added, FreeCAD's FEM solves it with CalculiX."""

import shutil

import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.sizing.sizing_settings import SizingSettings
from thinpart_workbench.freecad_adapter.objects.fem_analysis import analysis_for, new_analysis
from thinpart_workbench.freecad_adapter.objects.fem_mesh import set_fem_mesh
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
from thinpart_workbench.workflow.analysis.analyse_part import analyse_part
from thinpart_workbench.workflow.meshing.part_sizing import PartSizing

pytestmark = pytest.mark.skipif(not (shutil.which("gmsh") and shutil.which("ccx")), reason="Gmsh or CalculiX is missing")

LENGTH, WIDTH, THICK, FORCE = 120.0, 20.0, 4.0, 50.0


@pytest.fixture
def document():
    import FreeCAD

    document = FreeCAD.newDocument("fem_analysis")
    yield document
    FreeCAD.closeDocument(document.Name)


def add_strip(document, tmp_path):
    """A strip of sheet, the mesh that is proposed for it, and an analysis with that."""
    strip = document.addObject("Part::Box", "Strip")
    strip.Length, strip.Width, strip.Height = LENGTH, WIDTH, THICK
    document.recompute()
    part = SolidPart("Strip", "Strip", shape=strip.Shape.Solids[0])
    measurement, _ = analyse_part(part, AnalysisSettings(), load_profile("calibrated"))
    part.write_brep(str(tmp_path / "part.brep"))
    made = PartSizing(measurement, 10.0).mesh(shutil.which("gmsh"), str(tmp_path / "part.brep"), SizingSettings(), {}, 60.0,
                                              str(tmp_path))
    assert made["mesh"], made["proposed"]["reason"]
    analysis = analysis_for(document, strip) or new_analysis(document, "Analysis", "Steel (replace it)")
    mesh = set_fem_mesh(document, strip, made["mesh"], {}, made["global_size"], 2, [], analysis)
    return strip, mesh, analysis


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # FreeCAD leaves a pipe open
def test_it_is_solved_once_a_support_and_a_force_are_added(document, tmp_path):
    import FreeCAD
    import ObjectsFem

    if tuple(map(int, FreeCAD.Version()[:2])) >= (1, 1):
        pytest.importorskip("vtkmodules", reason="FEM needs VTK's Python, which Debian's FreeCAD does not bring")
    from femtools.ccxtools import FemToolsCcx

    strip, mesh, analysis = add_strip(document, tmp_path)
    assert mesh in analysis.Group and mesh.ElementOrder == "2nd"
    held, force = ObjectsFem.makeConstraintFixed(document), ObjectsFem.makeConstraintForce(document)
    held.References, force.References = [(strip, "Face1")], [(strip, "Face2")]
    force.Force = FORCE if isinstance(force.Force, float) else f"{FORCE} N"  # a quantity since FreeCAD 1.0
    force.Direction, force.Reversed = (strip, ["Edge1"]), False
    for each in (held, force):
        analysis.addObject(each)
    document.recompute()
    solver = next(each for each in analysis.Group if each.isDerivedFrom("Fem::FemSolverObjectPython"))
    tools = FemToolsCcx(analysis, solver)
    tools.update_objects()
    (tmp_path / "solver").mkdir()
    tools.setup_working_dir(str(tmp_path / "solver"))
    tools.setup_ccx()
    assert not tools.check_prerequisites()
    tools.run()
    result = next(each for each in document.Objects if each.isDerivedFrom("Fem::FemResultObject"))
    deflection = FORCE * LENGTH ** 3 / (3.0 * 210000.0 * WIDTH * THICK ** 3 / 12.0)
    assert max(result.DisplacementLengths) == pytest.approx(deflection, rel=0.03)


def test_another_part_gets_an_analysis_of_its_own_and_the_same_one_that_which_it_has(document, tmp_path):
    strip, _, analysis = add_strip(document, tmp_path)
    other = document.addObject("Part::Box", "Other")
    document.recompute()
    assert analysis_for(document, strip) == analysis
    assert analysis_for(document, other) is None
