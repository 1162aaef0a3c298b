# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several processes find among parts what one process finds."""

import os
from dataclasses import replace

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import Cancelled
from thinpart_workbench.core.forms.form import Form, form_of
from thinpart_workbench.core.forms.motion import turn_by
from thinpart_workbench.core.forms.recorded_form import packed_form, recorded_form, unpacked_numbers
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.run_control import RunControl
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.workflow.reuse import like_processes
from thinpart_workbench.workflow.reuse.formed_parts import FormedParts
from thinpart_workbench.workflow.reuse.like_parts import LikeParts
from thinpart_workbench.workflow.workers import process_pool

MIRROR = np.diag([1.0, 1.0, -1.0])
PLACES = np.eye(3), turn_by(np.array([0.3, -1.1, 0.7])), turn_by(np.array([2.0, 0.4, -0.2]))


def bracket(length, hole):
    """An L with a foot, so that it is not its own mirror image, and a step in it."""
    outline = [(0, 0), (40, 0), (40, 6), (12 + hole, 6), (12 + hole, 9), (12, 9), (12, 30), (0, 30)]
    points, triangles = made_meshes.prism(outline, length)
    points = points.copy()
    points[points[:, 2] > 0.0, 1] += 8.0 * points[points[:, 2] > 0.0, 0] / 40.0
    return points, triangles


def formed(shapes):
    """The FormedParts of meshes, the first of which stands highest."""
    meshes = [surface_mesh(*shape) for shape in shapes]
    fields = [measure(mesh, AnalysisSettings(minimum_samples=2000)).field for mesh in meshes]
    forms = [form_of(field) for field in fields]
    numbers = unpacked_numbers([packed_form({
        "form": recorded_form(form), "descriptors": {"area_mm2": form.moments.area}})[0] for form in forms])
    nowhere = np.full(len(forms), -1)
    return FormedParts([], nowhere, nowhere, numbers, np.full(len(forms), np.nan),
                       np.array([np.sort(np.ptp(shape[0], axis=0))[::-1] for shape in shapes]),
                       list(range(len(forms), 0, -1)), 0, tuple(forms))


@pytest.fixture(scope="module")
def parts():
    """Brackets of five lengths, each three times, and once mirrored and larger; others that are alike but for a step."""
    shapes = []
    for length in (14.0, 19.0, 25.0, 37.0, 55.0):
        points, triangles = bracket(length, 3.0)
        shapes += [(points @ place.T + [5.0, -3.0, 1.0], triangles) for place in PLACES]
        shapes += [(points @ MIRROR, triangles[:, ::-1]), (1.7 * points, triangles), bracket(length, 7.0)]
    return formed(shapes)


@pytest.fixture
def few(monkeypatch):
    """As if these parts were many."""
    monkeypatch.setattr(like_processes, "FEW", 2)


def told(found):
    return [(each.part, each.reference, each.kind, len(each.ways)) for each in found]


def test_they_find_what_one_process_finds_in_the_same_order(parts, few):
    said = []
    one = [like_processes.of_one_form(LikeParts(parts), parts, 1, RunControl(), lambda *_: None)]
    two = [like_processes.of_one_form(LikeParts(parts), parts, 2, RunControl(), lambda *steps: said.append(steps))]
    kinds = [each.kind for each in one[0]]
    assert kinds.count("identical") >= 10 and kinds.count("mirrored") == kinds.count("scaled") == 5
    assert said and all(0 < done <= total == len(parts) for done, total in said)
    rest = set(range(len(parts))) - {each.part for each in one[0]}
    for jobs, found in ((1, one), (2, two)):
        found.append(like_processes.alike(LikeParts(parts), parts, rest, jobs, RunControl(), lambda *_: None))
    assert len(one[1]) > 3
    for first, second in zip(one, two):
        assert told(first) == told(second)
        for each, other in zip(first, second):
            for laid, other_laid in zip((each.laid, *each.ways), (other.laid, *other.ways)):
                assert laid.distance == pytest.approx(other_laid.distance, abs=1e-9)
                assert laid.other_distance == pytest.approx(other_laid.other_distance, abs=1e-9)
                assert laid.motion.points(np.eye(3)) == pytest.approx(other_laid.motion.points(np.eye(3)), abs=1e-9)
                assert laid.motion.is_mirrored == other_laid.motion.is_mirrored


def test_they_stop_when_they_are_asked_to(parts, few):
    control = RunControl()
    control.stop()
    with pytest.raises(Cancelled):
        like_processes.of_one_form(LikeParts(parts), parts, 2, control, lambda *_: None)


def test_where_no_process_can_be_started_one_finds_it(parts, few, monkeypatch):
    """As in a FreeCAD that has no Python beside it."""
    monkeypatch.setattr(process_pool, "is_within_freecad", lambda: True)
    monkeypatch.setattr(process_pool, "python_beside_freecad", lambda: None)
    monkeypatch.setattr(process_pool, "python_environment", dict)
    likes = LikeParts(parts)
    found = like_processes.of_one_form(likes, parts, 2, RunControl(), lambda *_: None)
    assert told(found) == told(LikeParts(parts).of_one_form())
    rest = set(range(len(parts))) - {each.part for each in found}
    assert like_processes.alike(likes, parts, rest, 2, RunControl(), lambda *_: None)


class EndsWhoReadsIt(Form):
    """A form at which the process ends that it is given to, as one that the system ends when memory is short."""

    def __reduce__(self):
        return os._exit, (3,)


def test_what_a_process_was_given_that_died_is_searched_here(parts, few):
    expected = told(LikeParts(parts).of_one_form())
    deadly = replace(parts, more=(EndsWhoReadsIt(*parts.more[0]), *parts.more[1:]))
    assert told(like_processes.of_one_form(LikeParts(deadly), deadly, 2, RunControl(), lambda *_: None)) == expected
