"""Filtering in memory gives what the index gives."""

import os
from dataclasses import replace
from datetime import datetime, timezone

import made_meshes
import numpy as np
import pytest
from made_library import make_large_library, measured_record, store

from thinpart_workbench.core.judging.conditions import search_conditions
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.index.part_query import FAILED, PartQuery
from thinpart_workbench.workflow.library.find_parts import find_parts
from thinpart_workbench.workflow.library.part_columns import HISTOGRAM_BINS, RANGES, SORTABLE, PartColumns

SHAPES = {
    "Plate": made_meshes.box(100, 100, 2), "Block": made_meshes.box(100, 80, 60),
    "Ribbed": made_meshes.ribbed_block(),
    "Open": (made_meshes.box(10, 10, 10)[0], made_meshes.box(10, 10, 10)[1][2:]),
}
QUERIES = {
    "all": PartQuery(),
    "one category": PartQuery(categories=("thin",)),
    "failures among categories": PartQuery(categories=("normal", FAILED)),
    "failures alone": PartQuery(categories=(FAILED,)),
    "criteria": PartQuery(criteria=("1", "5")),
    "criteria and category": PartQuery(criteria=("5",), categories=("thin", "thin_features")),
    "a category that is not there": PartQuery(categories=("gear",)),
    "thickness": PartQuery(least_thickness=1.0, most_thickness=30.0),
    "size": PartQuery(least_size=50.0),
    "fill": PartQuery(least_ratio=0.3, most_ratio=0.8),
    "words": PartQuery(words="plate 4"),
    "words of notes": PartQuery(words="ORDER"),
    "condition": PartQuery(conditions=search_conditions("D2/D3 > 6 and F[0;0.05] >= 0.5")),
    "notes": PartQuery(has_notes=True), "no notes": PartQuery(has_notes=False),
    "borderline": PartQuery(borderline=True),
    "since": PartQuery(changed_since=datetime(2018, 6, 1, tzinfo=timezone.utc)),
    "all at once": PartQuery(
        categories=("thin", "thin_features"), criteria=("1", "5"), most_thickness=20.0, least_size=30.0,
        words="part", has_notes=False, borderline=False,
        conditions=search_conditions("V/VBB > 0.4")),
}


@pytest.fixture(scope="module")
def indexes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("libraries")
    models = folder / "models"
    models.mkdir()
    infos = [store(models, f"{name}.step", [measured_record(name, shape)]) for name, shape in SHAPES.items()]
    make_large_library(folder / "one", infos, 120)
    make_large_library(folder / "two", infos, 50)
    (folder / "two" / "broken.step.thinpart.json").write_text("{")
    opened = [LibraryIndex(folder / each, folder / "cache") for each in ("one", "two")]
    for index in opened:
        index.refresh()
    yield opened
    for index in opened:
        index.close()


@pytest.fixture(scope="module")
def columns(indexes):
    return PartColumns(indexes)


def found(columns, rows):
    return [sorted(ids.tolist()) for ids in columns.ids_by_index(rows)]


@pytest.mark.parametrize("name", QUERIES)
def test_the_same_parts_as_the_index_finds(indexes, columns, name):
    query = replace(QUERIES[name], failed=None)
    selection = columns.select(query)
    assert found(columns, selection.rows) == [
        sorted(find_parts(index, query).ids) for index in indexes]


@pytest.mark.parametrize("name", QUERIES)
def test_counts_are_what_would_be_found_by_that_alone_of_its_kind(columns, name):
    query = replace(QUERIES[name], failed=None)
    selection = columns.select(query)
    for category, count in selection.categories.items():
        assert count == len(columns.select(replace(query, categories=(category,))).rows), category
    for criterion, count in selection.criteria.items():
        assert count == len(columns.select(replace(query, criteria=(criterion,))).rows), criterion
    for flag, count in selection.flags.items():
        assert count == len(columns.select(replace(query, **{flag: True})).rows), flag
    for quantity, bins in selection.histograms.items():
        low, high = columns.scales[quantity]
        edges = low * (high / low) ** (np.arange(HISTOGRAM_BINS + 1) / HISTOGRAM_BINS)
        least, most = RANGES[quantity]
        first = replace(query, **{least: None, most: edges[7] * (1 - 1e-9)})
        assert sum(bins[:7]) == len(columns.select(first).rows), quantity


@pytest.mark.parametrize("column", SORTABLE)
def test_sorting_leaves_what_has_no_value_to_the_end(indexes, columns, column):
    rows = columns.select(PartQuery(failed=None)).rows
    for descending in (False, True):
        parts = columns.parts(columns.sorted(rows, column, descending))
        if column in RANGES:
            values = [getattr(part, column) for part in parts]
            known = [value for value in values if value is not None]
            assert known == sorted(known, reverse=descending)
            assert values[:len(known)] == known and len(known) < len(values)
        elif column == "label":
            labels = [(part.label or "").casefold() for part in parts]
            assert labels == sorted(labels, reverse=descending)
        assert len(parts) == len(columns)


def test_a_part_that_has_gone_is_none_and_the_others_keep_their_places(indexes, columns):
    rows = columns.select(PartQuery(failed=None)).rows[[5, 130, 2]]
    before = columns.parts(rows)
    assert [part.id for part in before] == [int(ids[0]) for ids in (
        columns.ids_by_index(rows[:1])[0], columns.ids_by_index(rows[1:2])[1],
        columns.ids_by_index(rows[2:])[0])]
    # Another process has found meanwhile that its info file is not there any more.
    name = before[1].info_file
    os.rename(name, f"{name}.away")
    try:
        assert sum(index.refresh().removed for index in indexes) == 1
        assert columns.parts(rows) == [before[0], None, before[2]]
    finally:
        os.rename(f"{name}.away", name)
        for index in indexes:
            index.refresh()


def test_nothing_at_all():
    empty = PartColumns([])
    selection = empty.select(PartQuery(words="x", criteria=("1",), failed=None))
    assert len(selection.rows) == 0 and selection.categories[FAILED] == 0
    assert sum(selection.histograms["d1_mm"]) == 0
    assert len(empty.sorted(selection.rows, "label")) == 0
