# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts like another are found by what they are, not by where they stand or how large they are."""

from types import SimpleNamespace

import made_meshes
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from scipy.stats import wasserstein_distance

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.bins import BINS
from thinpart_workbench.core.forms.directions import BINS as DIRECTION_BINS
from thinpart_workbench.core.forms.directions import direction_distribution
from thinpart_workbench.core.forms.outline import Outline
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.record.part_record import part_record
from thinpart_workbench.core.reuse.similarity import (
    DIAGONAL,
    DIRECTIONS,
    EDGES,
    FILL,
    FORM,
    HALF_SCORE,
    INTERVALS,
    NO_WALL,
    SIGNATURE_LENGTH,
    TERMS,
    THICKNESS_UNIT,
    UNKNOWN_DIRECTIONS,
    UNKNOWN_FILL,
    UNKNOWN_FORM,
    nearest,
    reasons,
    score,
    signature,
)
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.core.walls.thinnest_place import WallErrors

PART = SimpleNamespace(name="Part", label="A part", instances=1, warnings=(), face_surfaces=None)
PAPER = load_profile("paper")
NAMES = [term.name for term in TERMS]
WALLS = NAMES.index("walls")

SHAPES = {
    "plate": made_meshes.box(100, 100, 2),
    "another plate": made_meshes.box(130, 90, 3),
    "long plate": made_meshes.box(400, 90, 5),
    "block": made_meshes.box(100, 80, 60),
    "ribbed block": made_meshes.ribbed_block(),
    "wedge": made_meshes.wedge(),
    "tube": made_meshes.tube(steps=40),
    "shell": made_meshes.spherical_shell(steps=40),
}
PLACES = {
    "ten times as large": {"scale": 10.0},
    "turned": {"rotation": Rotation.from_rotvec([0.5, 0.7, -0.3]).as_matrix()},
    "far away": {"shift": (5e4, -3e4, 1e4)},
    "all of it": {"scale": 0.1, "shift": (70, -2e3, 1),
                  "rotation": Rotation.from_rotvec([-2.1, 0.4, 1.3]).as_matrix()},
}


def signature_of(shape):
    mesh = surface_mesh(*shape)
    measurement = measure(mesh, AnalysisSettings())
    verdict = classify(measurement.descriptors, PAPER)
    return signature(part_record(PART, mesh, measurement, verdict, verdict, [], WallErrors(0.0, 0.0, 0.0), 0.0))


@pytest.fixture(scope="module")
def made():
    return {name: signature_of(shape) for name, shape in SHAPES.items()}


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("place", PLACES)
def test_a_part_is_like_itself_wherever_it_stands_and_however_large(made, name, place):
    there = signature_of(made_meshes.moved(SHAPES[name], **PLACES[place]))
    found = nearest(np.stack(list(made.values())), there, 1)
    assert list(made)[found.indices[0]] == name
    assert found.distances[0] < 0.002 and round(float(score(found.distances[0]))) >= 99
    assert there[DIAGONAL] == pytest.approx(
        made[name][DIAGONAL] * PLACES[place].get("scale", 1.0), rel=1e-5)


def test_the_likest_come_first(made):
    found = nearest(np.stack(list(made.values())), made["plate"], len(made))
    order = [list(made)[index] for index in found.indices]
    assert order[:3] == ["plate", "another plate", "long plate"]
    assert (np.diff(found.distances) >= 0).all() and found.distances[0] == 0
    assert score(found.distances[0]) == 100 and (np.diff(score(found.distances)) <= 0).all()
    place = {name: score(found.distances[order.index(name)]) for name in made}
    assert place["another plate"] > 60 and place["block"] < 30


def hanger(length, depth):
    """A sheet of 2 mm, bent by a right angle."""
    return made_meshes.prism([(0, 0), (length, 0), (length, 2), (2, 2), (2, 50), (0, 50)], depth)


def dome(radius, wall):
    """Half of a ball's shell."""
    turn = np.linspace(0.0, np.pi / 2, 25)
    outer, inner = (np.column_stack([far * np.cos(turn), far * np.sin(turn)]) for far in (radius, radius - wall))
    return made_meshes.revolved([*map(tuple, outer), *map(tuple, inner[::-1])])


def test_the_sister_of_a_hanger_comes_before_a_dome_of_the_same_walls_and_box():
    hangers, other = signature_of(hanger(60, 50)), signature_of(dome(29, 2))
    sister = signature_of(hanger(72, 40))
    found = nearest(np.stack([other, sister]), hangers, 2)
    assert list(found.indices) == [1, 0]
    near, far = score(found.distances)
    assert near > far + 10


@pytest.mark.parametrize("wanted, found, words", [
    ("plate", "plate", "same wall distribution, same proportions, same fill, box as long, box as flat"),
    ("another plate", "long plate",
     "same wall distribution, different proportions, same fill, much longer box, much less flat box"),
    ("long plate", "another plate",
     "same wall distribution, different proportions, same fill, much shorter box, much flatter box"),
    ("block", "plate", "different wall distribution, different proportions, same fill, shorter box, much flatter box"),
    ("block", "tube", "different wall distribution, similar proportions, much less filled, longer box, less flat box"),
])
def test_reasons_say_what_is_alike_and_what_is_not(made, wanted, found, words):
    assert reasons(nearest(made[found][None], made[wanted], 1).terms[0]) == words


def record(bins, area, nonparallel=0.0, fill=0.5, box=(3.0, 2.0, 1.0)):
    """A record with the keys that are compared."""
    parallel = sum(area)
    return {"descriptors": {
        "distribution": {"bins": bins, "area": area},
        "shares": {"parallel": parallel, "nonparallel": nonparallel,
                   "unmeasured": 1.0 - parallel - nonparallel},
        "volume_ratio": fill, "box_mm": list(box), "diagonal_mm": float(np.linalg.norm(box)),
    }}


@st.composite
def walls(draw):
    """Bins and their area: a distribution that may leave some area without a wall."""
    bins = draw(st.lists(st.integers(0, BINS - 1), unique=True, max_size=12).map(sorted))
    area = np.array(draw(st.lists(st.floats(0.01, 1.0), min_size=len(bins), max_size=len(bins))))
    total = draw(st.floats(0.0, 1.0))
    return bins, (area / max(area.sum(), 1e-9) * total).tolist()


def emd(first, second):
    return float(nearest(signature(record(*second))[None], signature(record(*first)), 1)
                 .terms[0, WALLS])


def thickness(bins):
    """The scale on which walls are compared."""
    return np.log1p(np.asarray(bins) / BINS / THICKNESS_UNIT) / np.log1p(1 / THICKNESS_UNIT)


def with_no_wall(bins, area):
    """Where all of the area lies on the scale, that without a wall included."""
    return [*thickness(bins), 1 + NO_WALL], [*area, max(0.0, 1 - sum(area))]


def split_between_edges(bins, area):
    """The same area moved to the edges of its intervals, so that its mean place stays."""
    ends = np.append(EDGES, BINS)
    left = np.searchsorted(ends, bins, side="right") - 1
    share = (np.asarray(bins) - ends[left]) / np.diff(ends)[left]
    area = np.asarray(area)
    return (np.concatenate([ends[left], ends[left + 1]]),
            np.concatenate([area * (1 - share), area * share]))


@settings(deadline=None, max_examples=200)
@given(walls(), walls())
def test_walls_are_compared_by_the_earth_movers_distance(first, second):
    found = emd(first, second) * (1 + NO_WALL)
    split = []
    for bins, area in (first, second):
        places, masses = split_between_edges(np.array(bins, int), area)
        split += [*with_no_wall(places, masses)]
    places, masses, other_places, other_masses = split
    assert found == pytest.approx(
        wasserstein_distance(places, other_places, masses, other_masses), abs=2e-6)
    (places, masses), (other_places, other_masses) = with_no_wall(*first), with_no_wall(*second)
    exact = wasserstein_distance(places, other_places, masses, other_masses)
    # Nothing is moved by more than the widest interval on the scale of thickness.
    assert found == pytest.approx(exact, abs=2 * np.diff(thickness([*EDGES, BINS])).max())


@settings(deadline=None, max_examples=200)
@given(walls(), walls(), walls())
def test_the_distance_between_walls_is_a_metric(first, second, third):
    assert emd(first, first) == 0
    assert emd(first, second) == emd(second, first) >= 0
    assert emd(first, third) <= emd(first, second) + emd(second, third) + 1e-6
    assert emd(first, second) <= 1 + 1e-6


def test_area_without_a_wall_counts():
    few, many = record([20], [0.3]), record([20], [0.9])
    found = nearest(np.stack([signature(many), signature(few)]), signature(few), 2)
    assert found.indices.tolist() == [1, 0]
    assert found.terms[1, WALLS] == pytest.approx(
        0.6 * (1 + NO_WALL - thickness(20)) / (1 + NO_WALL), rel=1e-5)


def test_a_thin_wall_differs_more_from_one_twice_as_thick_than_a_thick_one_does_by_as_much():
    assert emd(([20], [1.0]), ([40], [1.0])) > 4 * emd(([400], [1.0]), ([420], [1.0])) > 0


def test_fill_that_is_not_known():
    known, unknown = record([20], [1.0], fill=0.4), record([20], [1.0], fill=None)
    both = np.stack([signature(unknown), signature(known)])
    assert np.isnan(both[0, FILL]) and np.isfinite(np.delete(both, [FILL, *range(FORM, SIGNATURE_LENGTH)], axis=1)).all()
    fill = TERMS[NAMES.index("fill")]
    for wanted, order in ((unknown, [0, 1]), (known, [1, 0])):
        found = nearest(both, signature(wanted), 2)
        assert found.indices.tolist() == order
        assert found.distances == pytest.approx([0.0, UNKNOWN_FILL * fill.weight ** 0.5])
        assert fill.unknown in reasons(found.terms[1])


def test_proportions_that_are_not_known(made):
    unknown = made["plate"].copy()
    unknown[FORM:FORM + 3] = np.nan
    both = np.stack([unknown, made["plate"]])
    form = TERMS[NAMES.index("form")]
    for wanted, order in ((unknown, [0, 1]), (made["plate"], [1, 0])):
        found = nearest(both, wanted, 2)
        assert found.indices.tolist() == order
        assert found.distances == pytest.approx([0.0, UNKNOWN_FORM * form.weight ** 0.5])
        assert form.unknown in reasons(found.terms[1])


def test_directions_that_are_not_known(made):
    unknown = made["plate"].copy()
    unknown[DIRECTIONS:] = np.nan
    both = np.stack([unknown, made["plate"]])
    directions = TERMS[NAMES.index("directions")]
    for wanted, order in ((unknown, [0, 1]), (made["plate"], [1, 0])):
        found = nearest(both, wanted, 2)
        assert found.indices.tolist() == order
        assert found.distances == pytest.approx([0.0, UNKNOWN_DIRECTIONS * directions.weight ** 0.5])


def test_faces_that_are_turned_otherwise_are_farther():
    """Of outlines of as many points: a box, its copy turned anywhere and twice as large, and a prism of three sides."""
    square, triangle = (np.array([[np.cos(turn), np.sin(turn), 0.0] for turn in 2.0 * np.pi * np.arange(sides) / sides])
                        for sides in (4, 3))
    ends = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    turn = Rotation.from_rotvec([0.3, -0.7, 1.1]).as_matrix()

    def distribution(normals, size=1.0):
        normals = np.repeat(normals, 60, axis=0)
        return direction_distribution(Outline(normals * size, normals, np.arange(len(normals)), np.full(len(normals), size)))

    box, prism = (np.concatenate([sides, ends]) for sides in (square, triangle))
    assert distribution(box @ turn.T, 2.0) == pytest.approx(distribution(box), abs=2e-3)
    steps = np.diff(distribution(box), prepend=0.0)
    assert steps[[0, DIRECTION_BINS // 2, -1]] == pytest.approx([1 / 6, 4 / 6, 1 / 6], abs=2e-3)
    assert abs(distribution(box) - distribution(prism)).sum() * 2.0 / DIRECTION_BINS > 0.1


def test_only_parts_of_the_same_size_when_asked(made, rng):
    shuffled = rng.permutation(np.repeat(np.geomspace(0.1, 10, 21), 400))
    all_sizes = np.tile(made["tube"], (len(shuffled), 1))
    all_sizes[:, DIAGONAL] *= shuffled
    found = nearest(all_sizes, made["tube"], len(shuffled), same_size=1.3)
    ratio = shuffled[found.indices]
    assert len(ratio) == 400 * 3 and (abs(np.log(ratio)) <= np.log(1.3)).all()
    assert len(nearest(all_sizes, made["tube"], len(shuffled)).indices) == len(shuffled)


def test_many_parts_give_what_each_alone_gives(made, rng):
    many = rng.uniform(0.0, 1.0, (10_000, SIGNATURE_LENGTH)).astype(np.float32)
    many[::7, FILL] = np.nan
    found = nearest(many, made["shell"], 50)
    alone = np.array([nearest(row[None], made["shell"], 1).distances[0] for row in many])
    assert found.indices.tolist() == np.argsort(alone, kind="stable")[:50].tolist()
    assert found.distances == pytest.approx(np.sort(alone)[:50], rel=1e-6)


def test_equals_come_in_their_order_and_no_more_than_there_are(made):
    same = np.tile(made["wedge"], (9000, 1))
    assert nearest(same, made["wedge"], 20).indices.tolist() == list(range(20))
    assert len(nearest(same[:3], made["wedge"], 20).indices) == 3
    assert len(nearest(same[:0], made["wedge"], 20).indices) == 0
    assert len(nearest(same, made["wedge"], 0).indices) == 0


def test_a_part_without_walls_and_a_flat_one_have_a_signature():
    empty = signature(record([], []))
    assert (empty[:INTERVALS + 1] == 0).all()
    flat = signature(record([0], [1.0], fill=None, box=(2.0, 1.0, 0.0)))
    found = nearest(np.stack([empty, flat]), flat, 2)
    assert found.indices.tolist() == [1, 0] and np.isfinite(found.distances).all()
    assert (abs(found.terms[:, NAMES.index("flatness")]) <= 1).all()


def test_weights_and_score():
    assert sum(term.weight for term in TERMS) == pytest.approx(1.0)
    assert score([0.0, HALF_SCORE, 2 * HALF_SCORE]) == pytest.approx([100, 50, 25])
