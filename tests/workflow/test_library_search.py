# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is counted for each choice is what a search for it finds, in several libraries and in one order."""

import json
import os
from dataclasses import replace
from datetime import datetime, timezone

import made_meshes
import pytest
from made_library import make_large_library, measured_record, store

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.conditions import search_conditions
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.index.part_query import FAILED, FLAGS, PartQuery
from thinpart_workbench.storage.index.written_query import SORTABLE
from thinpart_workbench.workflow.library.find_parts import find_parts, read_records
from thinpart_workbench.workflow.library.library_search import HISTOGRAM_BINS, LibrarySearch

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
    "thickness": PartQuery(ranges=(("thinnest_mm", 1.0, 30.0),)),
    "size": PartQuery(ranges=(("d1_mm", 50.0, None),)),
    "fill": PartQuery(ranges=(("volume_ratio", 0.3, 0.8),)),
    "any quantity": PartQuery(ranges=(("d2_d3", 1.5, None), ("plate_share", None, 0.9), ("regions", None, None))),
    "words": PartQuery(words="plate 4"),
    "words of notes": PartQuery(words="ORDER"),
    "condition": PartQuery(conditions=search_conditions("D2/D3 > 6 and F[0;0.05] >= 0.5")),
    "notes": PartQuery(has_notes=True), "no notes": PartQuery(has_notes=False),
    "borderline": PartQuery(borderline=True),
    "since": PartQuery(changed_since=datetime(2018, 6, 1, tzinfo=timezone.utc)),
    "all at once": PartQuery(
        categories=("thin", "thin_features"), criteria=("1", "5"),
        ranges=(("thinnest_mm", None, 20.0), ("d1_mm", 30.0, None)),
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
def search(indexes):
    return LibrarySearch(indexes)


def holds(part, query):
    """Whether a part, as stored, meets what the query says of categories, criteria, flags and ranges."""
    labels = json.loads(part.labels) if part.labels else []
    flags = {"borderline": part.borderline, "has_notes": bool(part.notes or part.mesh or part.link),
             "labelled": bool(labels), "disputed": any(label["category"] != part.category for label in labels)}
    values = [(getattr(part, column), least, most) for column, least, most in query.ranges if (least, most) != (None, None)]
    return (not query.categories or (part.category or FAILED) in query.categories) and (
        not query.criteria or bool(set(query.criteria) & set(part.criteria))) and all(
        getattr(query, name) is None or not part.error_kind and value == getattr(query, name)
        for name, value in flags.items()) and all(
        value is not None and (least is None or value >= least) and (most is None or value <= most)
        for value, least, most in values)


@pytest.mark.parametrize("name", QUERIES)
def test_it_finds_what_a_look_at_every_part_finds(indexes, search, name):
    query = replace(QUERIES[name], failed=None)
    rest = PartQuery(words=query.words, conditions=query.conditions, changed_since=query.changed_since, failed=None)
    assert [sorted(ids) for ids in search.find(query).ids_by_index()] == [
        sorted(part.id for part in find_parts(index, rest) if holds(part, query)) for index in indexes]


@pytest.mark.parametrize("name", QUERIES)
def test_counts_are_what_would_be_found_by_that_alone_of_its_kind(search, name):
    query = replace(QUERIES[name], failed=None)
    counts = search.counts(query)
    assert counts.count == len(search.find(query))
    for category, count in counts.categories.items():
        assert count == len(search.find(replace(query, categories=(category,)))), category
    for criterion, count in counts.criteria.items():
        assert count == len(search.find(replace(query, criteria=(criterion,)))), criterion
    for flag, count in counts.flags.items():
        assert count == len(search.find(replace(query, **{flag: True}))), flag
    assert set(counts.flags) == set(FLAGS)
    assert {column for column, *_ in query.ranges} <= set(counts.histograms) == set(counts.scales)
    for quantity, bins in counts.histograms.items():
        low, high = counts.scales[quantity]
        edge = low * (high / low) ** (7 / HISTOGRAM_BINS)
        others = tuple(each for each in query.ranges if each[0] != quantity)
        first = replace(query, ranges=(*others, (quantity, None, edge * (1 - 1e-9))))
        assert sum(bins[:7]) == len(search.find(first)), quantity
        assert sum(bins) == len(search.find(replace(query, ranges=(*others, (quantity, None, 1e299))))), quantity


@pytest.mark.parametrize("column", SORTABLE)
def test_sorting_leaves_what_has_no_value_to_the_end(search, column):
    query = PartQuery(failed=None)
    everything = sum(map(len, search.find(query).ids_by_index()))
    for descending in (False, True):
        found = search.find(query, column, descending)
        parts = found.parts(0, None)
        assert len(parts) == len(found) == everything
        assert found.parts(20, 60) == parts[20:60] == search.find(query, column, descending).parts(20, 60)
        if column == "category":
            continue
        values = [part.info_file.casefold() if column == "file" else
                  part.error_kind is None and part.borderline if column == "borderline" else
                  part.label and part.label.casefold() if column == "label" else getattr(part, column) for part in parts]
        known = [value for value in values if value is not None]
        assert values[:len(known)] == known
        assert known == sorted(known, reverse=descending) or column == "borderline"


def test_categories_are_in_their_order(search):
    order = ["thin", "thin_features", "normal", "unknown", None]
    for descending in (False, True):
        parts = search.find(PartQuery(failed=None), "category", descending).parts(0, None)
        ranks = [order.index(part.category) for part in parts]
        known = [rank for rank in ranks if rank < 4]
        assert known == sorted(known, reverse=descending) and ranks[:len(known)] == known


def test_a_part_that_has_gone_is_none_and_the_others_keep_their_places(indexes):
    found = LibrarySearch(indexes).find(PartQuery(failed=None))
    assert found.row_of(indexes[0], [10 ** 9]) is None
    before = found.parts(0, None)
    row = next(row for row, part in enumerate(before) if part.root == indexes[1].root)
    assert found.row_of(indexes[1], [before[row].id]) == row and len(found) == len(before)
    # Another process has found meanwhile that its info file is not there any more.
    name = before[row].info_file
    os.rename(name, f"{name}.away")
    try:
        assert sum(index.refresh().removed for index in indexes) == 1
        assert found.parts(0, None) == [*before[:row], None, *before[row + 1:]]
    finally:
        os.rename(f"{name}.away", name)
        for index in indexes:
            index.refresh()


def test_a_library_within_another_is_found_once(indexes, tmp_path):
    outer, inner = indexes[0].root, os.path.join(indexes[0].root, sorted(os.listdir(indexes[0].root))[0])
    with LibraryIndex(inner, tmp_path) as within:
        within.refresh()
        query = PartQuery(failed=None)
        found = LibrarySearch([indexes[0], within, indexes[0]])
        assert len(found.find(query)) == len(LibrarySearch(indexes[:1]).find(query)) == found.counts(query).count
        parts = list(found.find(query).parts(0, None))
        assert {part.root for part in parts} <= {outer, inner} and inner in {part.root for part in parts}
        assert len({(part.info_file, part.name) for part in parts}) == len(parts)
        assert sum("error" in record for record in read_records(parts)) == 0


def test_what_is_not_there_is_refused(search):
    for sort, ranges in (("weight", ()), ("file", (("weight", 1.0, 2.0),))):
        with pytest.raises(ThinPartError, match="weight") as error:
            search.find(PartQuery(ranges=ranges), sort)
        assert error.value.kind == "usage"


def test_nothing_at_all():
    empty = LibrarySearch([])
    query = PartQuery(words="x", criteria=("1",), failed=None)
    counts = empty.counts(query)
    assert len(empty.find(query, "label")) == 0 and counts.count == counts.categories[FAILED] == 0
    assert sum(counts.histograms["d1_mm"]) == 0
