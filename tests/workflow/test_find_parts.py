# SPDX-License-Identifier: LGPL-2.1-or-later
"""A query finds just the parts that a look at every record finds."""

import json
import operator
import os
from datetime import datetime, timedelta, timezone

import made_library
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from thinpart_workbench.core.descriptors.descriptor_table import QUANTITIES, quantity_named
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.conditions import COMPARISONS, search_conditions
from thinpart_workbench.core.record.part_record import descriptors_of
from thinpart_workbench.storage.index.index_columns import small_values
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.index.written_query import SORTABLE
from thinpart_workbench.storage.record_columns import INDEXED
from thinpart_workbench.workflow.library.find_parts import PartQuery, find_parts, read_records, stored_parts
from thinpart_workbench.workflow.library.similar_parts import similar_parts

COMPARE = {">": operator.gt, "<": operator.lt, ">=": operator.ge, "<=": operator.le}
BOUNDED = ["F[0;0.05]", "F[0;0.25]", "F[0.3;0.7]", "F[0.017;0.231]", "min_nonparallel[10;55]",
           "min_nonparallel[20;40]"]


@pytest.fixture(scope="module")
def index(tmp_path_factory):
    folder = tmp_path_factory.mktemp("find")
    library = made_library.make_library(folder / "library")
    with LibraryIndex(library, folder / "cache") as index:
        index.refresh()
        yield index


def found(index, **query):
    return sorted(part.label for part in find_parts(index, PartQuery(**query)))


def test_columns_that_are_named_as_quantities_are_those_quantities():
    record = made_library.record_of("ribbed_block")
    for column, stored in zip(INDEXED, small_values(record)):
        quantity = next((each for each in QUANTITIES if each.name == column.name), None)
        if quantity is not None:
            name = column.name + ("[10;55]" if quantity.bounds else "")
            value = quantity_named(name).evaluate(descriptors_of(record), 1e-4)
            expected = quantity.absent_means if value is None else value
            assert stored == pytest.approx(expected)


names = st.sampled_from([each.name for each in QUANTITIES if not each.bounds] + BOUNDED)


@settings(max_examples=150, deadline=None)
@given(names, st.sampled_from(COMPARISONS), st.sampled_from(list(made_library.SHAPES)), st.floats(0.5, 1.5))
def test_conditions_find_what_a_look_at_every_record_finds(index, name, comparison, shape, factor):
    threshold = quantity_named(name).evaluate(descriptors_of(made_library.record_of(shape)), 1e-4)
    threshold = 0.5 if threshold is None else threshold * factor
    expected = []
    for part in find_parts(index):
        record, = read_records([part])
        value = quantity_named(name).evaluate(descriptors_of(record), 1e-4)
        value = quantity_named(name).absent_means if value is None else value
        # Packed areas have seven digits: what lies nearer to the threshold than that may fall either way.
        if value is not None and abs(value - threshold) <= 1e-6 * abs(threshold):
            return
        if value is not None and COMPARE[comparison](value, threshold):
            expected.append(part.label)
    text = f"{name} {comparison} {threshold!r}"
    assert found(index, conditions=search_conditions(text)) == sorted(expected)


def test_categories_criteria_and_ranges(index):
    for shape, category in made_library.CATEGORIES.items():
        assert shape in found(index, categories=(category,))
    assert set(found(index, categories=("thin", "normal"))) == (
        set(found(index, categories=("thin",))) | set(found(index, categories=("normal",))))
    by_first = found(index, criteria=("1",))
    assert by_first and all("1" in part.criteria for part in find_parts(index) if part.label in by_first)
    assert found(index, ranges=(("thinnest_mm", 1.9, 2.1),))[0] == "Deckel Süd"
    assert found(index, ranges=(("d1_mm", 200, None),)) == ["long_plate"]
    assert "long_plate" not in found(index, ranges=(("d1_mm", None, 200),))


def test_words_are_found_in_paths_labels_and_notes(index):
    assert found(index, words="süd") == found(index, words="SÜD assembly") == ["Deckel Süd"]
    assert found(index, words="group cube") == ["cube"]
    assert found(index, words="per%cent") == found(index, words="no such words") == []


def test_failures_borderline_and_age(index):
    assert found(index, failed=True) == ["broken"]
    assert len(found(index, failed=None)) == len(found(index)) + 1
    assert set(found(index, borderline=True)).isdisjoint(found(index, borderline=False))
    now = datetime.now(timezone.utc)
    assert found(index, changed_since=now - timedelta(days=1)) == found(index)
    assert found(index, changed_since=now + timedelta(days=1)) == []


def test_order(index):
    parts = find_parts(index)
    paths = [part.info_file for part in parts]
    assert paths == sorted(paths)
    ids = [part.id for part in reversed(parts)]
    assert [part.id for part in stored_parts(index, [*ids, max(ids) + 1])] == ids


def test_records_are_those_of_the_info_files(index):
    part, = find_parts(index, PartQuery(words="süd"))
    record, = read_records([part])
    assert record["descriptors"] == made_library.record_of("plate")["descriptors"]
    assert record["file"] == os.path.join(index.root, "assembly.step") and record["instances"] == 4
    failure, = read_records(find_parts(index, PartQuery(failed=True)))
    assert failure["error"]["kind"] == "no_solid" and json.dumps(failure)


@pytest.mark.parametrize("text", ["", "D2/D3", "D2/D3 > x", "nothing > 3", "F > 0.5", "V/VBB = 0.5", "D1 > inf",
                                  "D1 > 1 and", "F[0.5;0.1] > 1", "D1 > 1; DROP TABLE parts"])
def test_conditions_that_make_no_sense_are_answered_with_a_sentence(text):
    with pytest.raises(ThinPartError) as error:
        search_conditions(text)
    assert error.value.kind == "usage" and str(error.value).endswith(".")


def test_similar_parts_come_first_and_the_part_itself_is_left_out(index):
    part, = find_parts(index, PartQuery(words="group plate.step", categories=("thin",), ranges=(("d1_mm", None, 110),)))
    found = similar_parts([index], made_library.record_of("plate"), 3, excluding=(part.info_file, part.name))
    assert [each.part.label for each in found][:2] == ["Deckel Süd", "long_plate"]
    assert found[0].score == pytest.approx(100) and "same wall distribution" in found[0].reasons
    scores = [each.score for each in found]
    assert scores == sorted(scores, reverse=True) and len(found) == 3
    small = similar_parts([index], made_library.record_of("plate"), 9, same_size=1.1)
    labels = {each.part.label for each in small}
    assert {"plate", "Deckel Süd"} <= labels and not {"long_plate", "cube"} & labels


def test_parts_of_several_libraries_are_sorted_by_any_quantity(index):
    part = find_parts(index)[0]
    assert all(hasattr(part, name) for name in SORTABLE)
