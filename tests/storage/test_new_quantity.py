# SPDX-License-Identifier: LGPL-2.1-or-later
"""A new descriptor is one entry of the table and one function, as docs/extending.md has them: it is then everywhere."""

import json

import pytest
from copied_program import answer, copied_program
from worked_examples import follow_example

from thinpart_workbench.core.descriptors.recorded_descriptors import DESCRIPTORS
from thinpart_workbench.core.kinds.value_kinds import Number, OrNull

SCRIPT = """
import contextlib, copy, io, json
from pathlib import Path
import made_library
from thinpart_workbench.cli import main
from thinpart_workbench.core.judging.conditions import search_conditions
from thinpart_workbench.core.judging.criteria import profile_from
from thinpart_workbench.core.descriptors.descriptor_table import listing
from thinpart_workbench.core.record.record_types import PART
from thinpart_workbench.core.record.part_record import descriptors_of
from thinpart_workbench.storage.info.info_definition import json_schema
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.index.part_query import RANGED
from thinpart_workbench.workflow.library.library_search import LibrarySearch
from thinpart_workbench.storage.part_table import PartRow, measured_row
from thinpart_workbench.workflow.library.find_parts import PartQuery, find_parts
from thinpart_workbench.storage.index.written_query import SORTABLE

record = made_library.record_of("cube")
older = copy.deepcopy(record)
del older["descriptors"]["roundness"]
wrong = copy.deepcopy(record)
wrong["descriptors"]["roundness"] = "round"
made_library.store(Path("library"), "cube.step", [record])
made_library.store(Path("library"), "older.step", [older])
made_library.store(Path("library"), "plate.step", [made_library.record_of("plate")])
made_library.store(Path("library"), "open.step", [made_library.record_of("open_box")])
content = json.loads(Path("resources/profiles/paper.json").read_text(encoding="utf-8"))
content["categories"][0]["criteria"][0]["conditions"] = [{"quantity": "Psi", "comparison": ">", "value": 0.7}]
with LibraryIndex("library", "cache") as index:
    index.refresh()
    found = find_parts(index, PartQuery(conditions=search_conditions("Psi > 0.7 and roundness < 0.9")))
    names = sorted(part.file.rpartition("/")[2] for part in found)
    values = [part.roundness for part in found]
    search, query = LibrarySearch([index]), PartQuery(ranges=(("roundness", 0.7, None),))
    counts = search.counts(query)
    ranged = [part.file.rpartition("/")[2] for part in search.find(query, "roundness", True).parts(0, None)]
definition = json_schema()["properties"]["parts"]["items"]["properties"]["descriptors"]
row = measured_row("cube.step", record)
with contextlib.redirect_stdout(io.TextIOWrapper(io.BytesIO(), encoding="utf-8")) as printed:
    main(["find", "library", "--where", "roundness > 0.7", "--sort", "roundness", "--json"])
printed.seek(0)
lines = printed.read().splitlines()
print(json.dumps({
    "record": record["descriptors"]["roundness"],
    "faults": [PART.fault(each, "part") for each in (record, older, wrong)],
    "schema": definition["properties"]["roundness"], "is_written": "roundness" in definition["required"],
    "from_older": descriptors_of(older).value("Psi"),
    "criterion": profile_from(content).criteria[0].check(descriptors_of(record), 1e-4).holds,
    "found": names, "values": values, "sortable": "roundness" in SORTABLE,
    "is_ranged": "roundness" in RANGED, "ranged": ranged, "counts": counts.histograms["roundness"],
    "scale": counts.scales["roundness"], "count": counts.count,
    "printed": [json.loads(line)["descriptors"].get("roundness") for line in lines],
    "cell": row.roundness, "titles": PartRow._fields, "listing": listing(),
}))
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    package = copied_program(tmp_path_factory.mktemp("program"))
    follow_example("A descriptor", package)
    return json.loads(answer(package, SCRIPT))


CUBE = (3.141592653589793 / 6.0) ** (1 / 3)


def test_records_have_it_and_files_of_earlier_versions_are_read_without_it(told):
    assert told["record"] == pytest.approx(CUBE)
    assert told["faults"][:2] == [None, None] and told["faults"][2].startswith("part.descriptors.roundness is")
    assert told["from_older"] == pytest.approx(CUBE)


def test_the_definition_of_info_files_has_it(told):
    assert told["schema"] == OrNull(Number()).schema() and told["is_written"]


def test_profiles_may_name_it(told):
    assert told["criterion"] is True


def test_libraries_are_searched_by_it_and_older_files_found(told):
    assert told["found"] == ["cube.step", "older.step"]
    assert told["values"] == pytest.approx([CUBE, CUBE])
    assert told["sortable"] and told["printed"] == [pytest.approx(CUBE), None]


def test_the_panel_that_finds_parts_has_a_range_of_it_and_orders_by_it(told):
    assert told["is_ranged"] and sorted(told["ranged"]) == ["cube.step", "older.step"]
    assert told["count"] == 2 and sum(told["counts"]) == 3 and told["counts"][0] == 1 and told["counts"][-1] == 2
    assert 0.1 < told["scale"][0] < 0.3 and told["scale"][1] == pytest.approx(CUBE)


def test_tables_and_documents_have_it(told):
    assert told["cell"] == pytest.approx(CUBE)
    assert told["titles"].index("volume_ratio") < told["titles"].index("thinnest_mm")
    assert told["listing"].endswith("\n| `roundness` | Psi | - | Area of a ball of the same volume, divided by the area |")


def test_what_is_there_since_the_first_version_is_no_later_entry():
    assert set(DESCRIPTORS.later) == {"precision", "middle", "local", "plate_ratio", "plate_share", "regions", "hazards"}
    assert not DESCRIPTORS.optional
