"""Rows that grow while they are sorted and filtered, against sorting and filtering them at once."""

import random

import pytest

from thinpart_workbench.gui.folder.results_order import FAILED, ResultsOrder, group_of
from thinpart_workbench.storage.part_table import PartRow, failed_row

BLANK = PartRow(*[None] * len(PartRow._fields))


def rows(count, seed):
    """Rows with many equal and absent numbers, and failures."""
    chance = random.Random(seed)
    made = []
    for number in range(count):
        file = f"Folder{chance.randrange(3)}/part{number}.step"
        if chance.random() < 0.2:
            made.append(failed_row(file, None, None, {"kind": "crash", "message": "it ended"}))
            continue
        made.append(BLANK._replace(
            file=file, label=chance.choice(["Lid", "Plate", "Bolt"]),
            category=chance.choice(["thin", "normal"]),
            thinnest_mm=chance.choice([None, 1.0, 2.0, 10.0]), warnings=""))
    return made


def shown(order):
    return [order.rows[index] for index in order.shown]


def sorted_plainly(chosen, reverse):
    known = [row for row in chosen if row.thinnest_mm is not None]
    return (sorted(known, key=lambda row: row.thinnest_mm, reverse=reverse)
            + [row for row in chosen if row.thinnest_mm is None])


@pytest.mark.parametrize("reverse", [False, True])
@pytest.mark.parametrize("seed", range(5))
def test_growing_sorted_and_filtered_is_the_same_as_all_at_once(seed, reverse):
    order, made = ResultsOrder(), rows(200, seed)
    order.sort(lambda row: row.thinnest_mm, reverse)
    order.select(["folder1", "PLATE"], {"thin"})
    for first in range(0, len(made), 7):
        order.shown += order.add(made[first:first + 7])
        order.arrange()
    chosen = [row for row in made if "Folder1" in row.file and row.label == "Plate"
              and row.category != "thin"]
    assert chosen and shown(order) == sorted_plainly(chosen, reverse)
    order.select([], set())
    assert shown(order) == sorted_plainly(made, reverse)
    order.sort(None)
    assert shown(order) == made


def test_files_are_taken_out_with_their_counts_and_the_rest_stays_in_order():
    order, made = ResultsOrder(), rows(200, 1)
    order.shown = order.add(made)
    order.sort(lambda row: row.thinnest_mm)
    failed = {row.file for row in made if row.error_kind}
    order.remove_files(failed)
    left = [row for row in made if row.file not in failed]
    assert shown(order) == sorted_plainly(left, False)
    assert order.counts[FAILED] == 0
    assert sum(order.counts.values()) == len(left)
    order.shown += order.add(made[:10])
    order.arrange()
    assert shown(order) == sorted_plainly(left + made[:10], False)
    assert all(order.counts[group] == sum(group_of(row) == group for row in order.rows)
               for group in ("thin", "normal", FAILED))
