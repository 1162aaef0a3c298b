# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where labels stand in a picture."""

import itertools

import numpy as np

from thinpart_workbench.core.rendering.label_places import label_places

AREA = (0.0, 0.0, 1000.0, 700.0)


def _rects(places, sizes):
    return np.concatenate([places, places + np.asarray(sizes, dtype=float)], axis=1)


def _common(one, other):
    sides = np.minimum(one[2:], other[2:]) - np.maximum(one[:2], other[:2])
    return float(np.prod(np.maximum(sides, 0.0)))


def test_no_label_is_no_place():
    places, chosen = label_places(np.empty((0, 2)), np.empty((0, 2)), AREA)
    assert places.shape == (0, 2) and chosen.shape == (0,)


def test_labels_stand_in_the_area_off_their_places_and_off_each_other():
    random = np.random.default_rng(3)
    anchors = random.uniform((300.0, 200.0), (700.0, 500.0), (10, 2))
    sizes = np.tile([110.0, 22.0], (10, 1))
    bar = (0.0, 100.0, 200.0, 600.0)
    places, _ = label_places(anchors, sizes, AREA, [bar])
    rects = _rects(places, sizes)
    assert (rects[:, :2] >= 0.0).all() and (rects[:, 2:] <= (1000.0, 700.0)).all()
    for one, other in itertools.combinations(rects, 2):
        assert _common(one, other) == 0.0
    for rect in rects:
        assert _common(rect, np.array(bar)) == 0.0
        assert not ((anchors > rect[:2]) & (anchors < rect[2:])).all(axis=1).any()


def test_the_part_is_covered_only_where_there_is_no_better_place():
    x, y = np.meshgrid(np.arange(400.0, 600.0, 4.0), np.arange(250.0, 450.0, 4.0))
    crowd = np.stack([x.ravel(), y.ravel()], axis=1)
    place, _ = label_places([[580.0, 350.0]], [[100.0, 22.0]], AREA, crowd=crowd)
    assert place[0, 0] >= 595.0
    # Near the left side of the part, at the left.
    place, _ = label_places([[420.0, 350.0]], [[100.0, 22.0]], AREA, crowd=crowd)
    assert place[0, 0] + 100.0 <= 405.0


def test_a_place_at_the_edge_has_its_label_inside():
    for anchor in ((2.0, 2.0), (998.0, 2.0), (998.0, 698.0), (2.0, 698.0)):
        place, _ = label_places([anchor], [[120.0, 22.0]], AREA)
        assert (place[0] >= 0.0).all() and (place[0] + (120.0, 22.0) <= (1000.0, 700.0)).all()


def test_a_label_stays_on_its_side_while_its_place_moves_a_little():
    anchors, sizes = np.array([[500.0, 350.0]]), [[100.0, 22.0]]
    x, y = np.meshgrid(np.arange(400.0, 600.0, 4.0), np.arange(250.0, 450.0, 4.0))
    crowd = np.stack([x.ravel(), y.ravel()], axis=1)
    _, first = label_places(anchors, sizes, AREA, crowd=crowd)
    for shift in ((3.0, 0.0), (-3.0, 2.0), (0.0, -4.0)):
        _, chosen = label_places(anchors + shift, sizes, AREA, crowd=crowd, before=first)
        assert chosen[0] == first[0]


def test_an_area_smaller_than_a_label_is_no_error():
    place, _ = label_places([[10.0, 5.0]], [[100.0, 22.0]], (0.0, 0.0, 30.0, 15.0))
    assert np.isfinite(place).all()
