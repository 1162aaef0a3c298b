# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elastic frequencies by the real CalculiX on meshes of the real Gmsh: known answers, and what keeps it from them."""

import math
import os
import shutil
import stat

import numpy as np
import pytest
from program import SAMPLES

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.storage.exchange.msh_file import read_tetrahedra, read_triangles
from thinpart_workbench.workflow.meshing.gmsh_program import mesh_volume
from thinpart_workbench.workflow.solving.automatic_mesh import (
    NO_MESH,
    NOT_SOLVED,
    SOLVED,
    UNKNOWN,
    SolvingLimits,
    automatic_mesh_error,
    element_size,
)
from thinpart_workbench.workflow.solving.calculix_program import CRASHED, TIMEOUT, calculix_program
from thinpart_workbench.workflow.solving.elastic_frequencies import COUNT, SIZE, elastic_frequencies
from thinpart_workbench.workflow.solving.mesh_trouble import has_trouble
from thinpart_workbench.workflow.solving.tip_deflection import FORCE, tip_deflection

GMSH, CALCULIX = shutil.which("gmsh"), shutil.which("ccx")
pytestmark = pytest.mark.skipif(None in (GMSH, CALCULIX), reason="gmsh or calculix-ccx is not installed")

YOUNG, POISSON, DENSITY = 210e3, 0.3, 7.85e-9
"""Steel, N, mm and t."""

LIMITS = SolvingLimits(30.0, 40.0, 7500)


def box(folder, *sides):
    """The script of a box, its name; and its diagonal."""
    (folder / "box.geo").write_text(f'SetFactory("OpenCASCADE");\nBox(1) = {{0, 0, 0, {", ".join(map(str, sides))}}};\n')
    return str(folder / "box.geo"), math.hypot(*sides)


def mesh(folder, size, *sides):
    """Points and tetrahedra of second order of a box."""
    shape, _ = box(folder, *sides)
    output = str(folder / "box.msh")
    assert mesh_volume(GMSH, [shape], output, 40, str(folder), ("-clmax", str(size), "-order", "2"))[0] == ""
    return read_tetrahedra(output, 2)


def solved(folder, points, tetrahedra, program=CALCULIX, seconds=40, diagonal=SIZE):
    return elastic_frequencies(points, tetrahedra, diagonal, program, seconds, str(folder))


@pytest.fixture(scope="module")
def beam(tmp_path_factory):
    return mesh(tmp_path_factory.mktemp("beam"), 10, 200, 10, 10)


def test_a_slender_beam_bends_as_euler_and_bernoulli_say(beam, tmp_path):
    length, height = 200.0, 10.0
    found, reason = solved(tmp_path, *beam)
    # The roots of cos(x) cosh(x) = 1, squared.
    expected = np.array([22.3733, 61.6728, 120.903]) / (2 * math.pi * length ** 2) * math.sqrt(
        YOUNG * height ** 2 / 12 / DENSITY)
    assert reason == "" and len(found) == COUNT
    assert found[0] == pytest.approx(expected[0], rel=0.015)
    assert np.all(found[:6:2] <= expected), "shear and the turning of sections, which that theory leaves out, make it softer"
    assert found[1::2] == pytest.approx(found[::2], rel=2e-3), "either way, as its section is a square"


@pytest.fixture(scope="module")
def held_beam(tmp_path_factory):
    """A beam of 200 x 10 x 10 mm, the triangles of its two ends, and a folder."""
    folder = tmp_path_factory.mktemp("held")
    points, tetrahedra = mesh(folder, 10, 200, 10, 10)
    _, triangles, _ = read_triangles(folder / "box.msh", 2)
    at = points[triangles][:, :, 0]
    return points, tetrahedra, triangles[(at == 0.0).all(axis=1)], triangles[(at == 200.0).all(axis=1)], folder


def bent(held_beam, direction, points=None):
    own, tetrahedra, held, loaded, folder = held_beam
    points = own if points is None else points
    return tip_deflection(points, tetrahedra, held, loaded, np.asarray(direction, float), CALCULIX, 40, str(folder))


@pytest.mark.parametrize("direction", [(0, 1, 0), (0, 0, -1), (0, 0.6, 0.8)])
def test_a_cantilever_bends_as_euler_and_bernoulli_say(held_beam, direction):
    deflection, reason = bent(held_beam, direction)
    assert reason == ""
    assert deflection == pytest.approx(FORCE * 200.0 ** 3 / (3.0 * YOUNG * 10.0 ** 4 / 12.0), rel=0.02)


def test_a_cantilever_that_is_pulled_gets_longer_as_hooke_says(held_beam):
    # A little shorter than that: the section cannot get narrower where it is held.
    assert bent(held_beam, (1, 0, 0))[0] == pytest.approx(FORCE * 200.0 / (YOUNG * 100.0), rel=0.01)


def test_a_deflection_grows_as_a_part_shrinks_and_depends_on_no_place(held_beam):
    first = bent(held_beam, (0, 1, 0))[0]
    assert bent(held_beam, (0, 1, 0), 0.1 * held_beam[0] + 7.0)[0] == pytest.approx(10.0 * first, rel=1e-4)


def test_a_deflection_that_is_not_solved_has_a_reason(held_beam):
    points, tetrahedra, held, loaded, folder = held_beam
    tangled = tetrahedra.copy()
    tangled[0] = tangled[0][[1, 0, 2, 3, 4, 6, 5, 7, 8, 9]]
    deflection, reason = tip_deflection(points, tangled, held, loaded, np.array([0.0, 1.0, 0.0]), CALCULIX, 40, str(folder))
    assert math.isnan(deflection) and "nonpositive jacobian determinant" in reason


def test_a_free_square_plate_has_leissas_frequencies(tmp_path):
    side, thick = 100.0, 1.0
    found, _ = solved(tmp_path, *mesh(tmp_path, 6, side, side, thick))
    bending = YOUNG * thick ** 3 / 12 / (1 - POISSON ** 2)
    # Leissa (1973), The free vibration of rectangular plates, table C21, doi:10.1016/S0022-460X(73)80371-2.
    parameters = np.array([13.489, 19.789, 24.432, 35.024, 35.024, 61.526])
    expected = parameters / (2 * math.pi * side ** 2) * math.sqrt(bending / (DENSITY * thick))
    assert found == pytest.approx(expected, rel=0.015)


def test_frequencies_depend_neither_on_size_nor_on_place_nor_on_order(beam, tmp_path):
    points, tetrahedra = beam
    turn = np.linalg.qr(np.random.default_rng(4).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    first, _ = solved(tmp_path, points, tetrahedra)
    for other, diagonal in ((1000.0 * points, 1000.0 * SIZE), (0.001 * points, 0.001 * SIZE),
                            (points @ turn.T + (5000.0, -300.0, 20.0), SIZE)):
        assert solved(tmp_path, other, tetrahedra[::-1], diagonal=diagonal)[0] == pytest.approx(first, rel=1e-5)
    assert solved(tmp_path, points, tetrahedra, diagonal=2.0 * SIZE)[0] == pytest.approx(2.0 * first, rel=1e-5)


def test_the_automatic_mesh_is_right_of_a_block(tmp_path):
    block = automatic_mesh_error(*box(tmp_path, 100, 20, 15), GMSH, CALCULIX, LIMITS, str(tmp_path))
    assert (block.outcome, block.is_tangled, block.reason) == (SOLVED, False, "")
    assert block.error < 0.03 and block.change < 0.01 and not has_trouble(block)
    assert block.reference_nodes > block.nodes and len(block.frequencies) == len(block.reference) == COUNT


def test_the_automatic_mesh_is_wrong_of_a_sheet_and_one_of_the_size_that_its_wall_needs_is_right(tmp_path):
    sheet = automatic_mesh_error(*box(tmp_path, 100, 100, 1), GMSH, CALCULIX, LIMITS, str(tmp_path))
    assert sheet.outcome == SOLVED and sheet.error > 0.05 and has_trouble(sheet)
    fine = automatic_mesh_error(*box(tmp_path, 100, 100, 1), GMSH, CALCULIX, LIMITS, str(tmp_path), 8.0)
    assert fine.error < 0.02 and fine.nodes > sheet.nodes


def test_gmsh_makes_no_elements_larger_than_a_tenth_of_the_diagonal(tmp_path):
    tenth, _ = mesh(tmp_path, 0.1 * math.hypot(100, 20, 10), 100, 20, 10)
    larger, _ = mesh(tmp_path, 1000, 100, 20, 10)
    assert len(larger) == pytest.approx(len(tenth), rel=0.05)
    assert element_size(100.0, 1000.0) == element_size(100.0) == 10.0 and element_size(100.0, 3.0) == 3.0


def test_a_mesh_that_the_solver_refuses_is_untangled(tmp_path):
    shutil.copy(SAMPLES / "shaft.step", tmp_path)
    found = automatic_mesh_error(str(tmp_path / "shaft.step"), 198.0, GMSH, CALCULIX, LIMITS, str(tmp_path))
    assert found.is_tangled and found.outcome == SOLVED and found.error < 0.03


def test_an_element_inside_out_is_the_reason(beam, tmp_path):
    points, tetrahedra = beam
    tetrahedra = tetrahedra.copy()
    tetrahedra[0] = tetrahedra[0][[1, 0, 2, 3, 4, 6, 5, 7, 8, 9]]
    found, reason = solved(tmp_path, points, tetrahedra)
    assert len(found) == 0 and "nonpositive jacobian determinant in element 1" in reason


def test_what_takes_too_long_is_said_and_nothing_is_known_of_it(tmp_path):
    slow = automatic_mesh_error(*box(tmp_path, 10, 10, 10), GMSH, CALCULIX, SolvingLimits(20.0, 1.0), str(tmp_path), 0.7)
    assert (slow.outcome, slow.reason, has_trouble(slow)) == (NOT_SOLVED, TIMEOUT, None)
    soon = automatic_mesh_error(*box(tmp_path, 100, 10, 10), GMSH, CALCULIX, SolvingLimits(seconds=0.0), str(tmp_path))
    assert (soon.outcome, soon.reason) == (UNKNOWN, "its reference mesh took too long") and len(soon.frequencies) == COUNT


def test_what_gmsh_cannot_mesh_has_no_mesh(tmp_path):
    (tmp_path / "bad.step").write_text("no part")
    found = automatic_mesh_error(str(tmp_path / "bad.step"), 10.0, GMSH, CALCULIX, LIMITS, str(tmp_path))
    assert found.outcome == NO_MESH and found.reason and has_trouble(found)


@pytest.mark.parametrize("text, reason", [
    ("kill -SEGV $$", CRASHED), ('echo " *ERROR in input:"; echo " no such thing"; exit 201', "in input: no such thing")])
def test_a_solver_that_fails_says_why(beam, tmp_path, text, reason):
    program = tmp_path / "ccx"
    program.write_text(f"#!/bin/sh\n{text}\n")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    found, said = solved(tmp_path, *beam, program=str(program))
    assert (len(found), said) == (0, reason)


def test_without_calculix_it_is_one_sentence(tmp_path, monkeypatch):
    assert calculix_program()[0] == CALCULIX and float(calculix_program()[1]) > 2.0
    assert calculix_program(CALCULIX)[0] == CALCULIX
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("sys.executable", os.fspath(tmp_path / "python3"))
    with pytest.raises(ThinPartError, match=r"^This needs CalculiX: install it .*'ccx -v' runs\.$"):
        calculix_program()
