# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between two classifications of a document."""

import pytest

from thinpart_workbench.api.document_verdicts import category_changes, walls_newly_under


def verdict(category="thin", thickness=3.0, error_bound=0.1):
    return {"label": "Part", "category": category, "thickness": thickness, "error_bound": error_bound}


def test_only_parts_that_were_there_before_can_change_their_category():
    before = {"a": verdict("thin"), "b": verdict("thin"), "gone": verdict("normal")}
    now = {"a": verdict("normal"), "b": verdict("thin"), "new": verdict("normal")}
    assert category_changes(before, now) == [(before["a"], now["a"])]
    assert category_changes(None, now) == []


@pytest.mark.parametrize("before, now, warned", [
    (4.0, 2.0, True),
    (4.0, 4.0, False),
    (2.0, 1.5, False),  # it was under the limit before
    (None, 2.0, True),  # no wall was measured before
    (4.0, None, False),
    (4.0, 2.95, False),  # may just have the limit's thickness
])
def test_a_wall_that_falls_under_the_limit(before, now, warned):
    then, now = {"a": verdict(thickness=before)}, {"a": verdict(thickness=now)}
    assert walls_newly_under(then, now, 3.0) == ([now["a"]] if warned else [])


def test_a_new_part_under_the_limit_counts():
    now = {"a": verdict(thickness=2.0), "b": verdict(thickness=5.0)}
    assert walls_newly_under(None, now, 3.0) == [now["a"]]
    assert walls_newly_under({"b": verdict(thickness=5.0)}, now, 3.0) == [now["a"]]
