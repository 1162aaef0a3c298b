# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles, limits, labels, settings, conditions and links that are endless, or made to take the square of the time."""

import json
import os
import zipfile

import pytest

from thinpart_workbench.api.annotations import mesh_settings
from thinpart_workbench.core.descriptors.descriptor_table import quantity_named
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.conditions import search_conditions
from thinpart_workbench.core.judging.criteria import MOST_CONDITIONS, load_profile, usable_profile
from thinpart_workbench.core.judging.wall_limits import read_limits
from thinpart_workbench.core.kinds.json_file import LARGEST_WRITTEN
from thinpart_workbench.freecad_adapter.reading.instance_names import telling_label
from thinpart_workbench.freecad_adapter.reading.linked_files import linked_files
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.index.part_query import MOST_TERMS
from thinpart_workbench.storage.index.written_query import part_query
from thinpart_workbench.storage.labels_file import read_labels
from thinpart_workbench.workflow.library.find_parts import find_parts

MANY = 200_000
"""A length with which the square of it would take hours."""

READERS = {"profile": load_profile, "limits": read_limits, "labels": lambda path: read_labels(path, ("thin",)),
           "mesh": lambda path: mesh_settings(os.fspath(path))}


def _pipe(path):
    os.mkfifo(path)


def _zeros(path):
    path.symlink_to("/dev/zero")


def _too_large(path):
    with open(path, "wb") as file:
        file.truncate(1 << 40)


def _broken(path):
    path.symlink_to("/proc/self/mem")


def _no_text(path):
    path.write_bytes(b'{"name": "\xff"}')


def _deep(path):
    path.write_text("[" * MANY)


@pytest.mark.parametrize("make", [_pipe, _zeros, _too_large, _broken, _no_text, _deep])
@pytest.mark.parametrize("reader", READERS)
def test_what_people_give_is_read_with_a_limit(reader, make, tmp_path):
    path = tmp_path / "given.json"
    make(path)
    if (reader, make) == ("mesh", _too_large):  # only the name of a large file is kept
        assert READERS[reader](path) == {"file": os.fspath(path)}
        return
    with pytest.raises(ThinPartError) as told:
        READERS[reader](path)
    assert "Errno" not in str(told.value) and "codec" not in str(told.value)


def test_a_file_that_grows_is_read_up_to_the_limit(tmp_path):
    path = tmp_path / "grown.json"
    path.write_text(json.dumps("a" * LARGEST_WRITTEN))
    with pytest.raises(ThinPartError, match="larger than 16 MB"):
        load_profile(path)


def _with_conditions(count, criteria=1):
    condition = {"quantity": "V/VBB", "comparison": ">", "value": 0.5}
    made = [{"id": number, "conditions": [condition] * count} for number in range(criteria)]
    return {"format": "thinpart-profile", "version": 1, "name": "many",
            "categories": [{"name": "thin", "criteria": made}]}


@pytest.mark.parametrize("shape", [(1, MANY // 10), (MANY // 10, 1), (MOST_CONDITIONS + 1, 1)])
def test_a_profile_of_too_many_conditions_is_refused(shape):
    with pytest.raises(ThinPartError, match="conditions, more than 1000: leave some out"):
        usable_profile(_with_conditions(*shape))


@pytest.mark.parametrize("shape", [(1, MOST_CONDITIONS), (MOST_CONDITIONS, 1)])
def test_a_profile_of_as_many_as_are_allowed_is_used(shape):
    assert sum(len(each.conditions) for each in usable_profile(_with_conditions(*shape)).criteria) == MOST_CONDITIONS


@pytest.mark.parametrize("text", ["V{} > 1", "V >{} 1", "V > 1{} x", "V{}", "{} > 1", "V > 1{}and{}A > 1", "V > 1{}, A"])
@pytest.mark.parametrize("run", [" ", "\t\n", "<", ",", "and ", "[", "0", "."])
def test_conditions_of_any_length_are_split_in_one_pass(text, run):
    try:
        found = search_conditions(text.replace("{}", run * MANY))
    except ThinPartError as refused:
        assert refused.kind == "usage"
    else:
        assert 1 <= len(found) <= MANY + 2


@pytest.mark.parametrize("text", ["F[0.1.2;3]", "F[.;1]", "F[0;1..]"])
def test_bounds_that_are_no_numbers_are_no_quantity(text):
    with pytest.raises(KeyError):
        quantity_named(text)
    with pytest.raises(ThinPartError, match="no quantity"):
        search_conditions(f"{text} > 1")


@pytest.mark.parametrize("spaces", [" ", "", "  \t "])
def test_spaces_in_conditions_mean_nothing(spaces):
    found = search_conditions(f"D2/D3{spaces}>{spaces}6 and  F[0;0.05]{spaces}>={spaces}0.5,A<1")
    assert [(each.quantity.symbol, each.comparison, each.value) for each in found] == [
        ("D2/D3", ">", 6.0), ("F[0;0.05]", ">=", 0.5), ("A", "<", 1.0)]


@pytest.fixture
def index(classified, tmp_path):
    with LibraryIndex(classified, tmp_path / "index") as opened:
        opened.refresh()
        yield opened


LONG_SEARCHES = {
    "conditions": lambda count: {"conditions": " and ".join(["D2 > 1"] * count)},
    "words": lambda count: {"words": "plate " * count},
    "categories": lambda count: {"categories": ["thin"] * count},
    "criteria": lambda count: {"criteria": ["thin_walls"] * count},
    "said": lambda count: {"said": ["thin"] * count},
}


@pytest.mark.parametrize("of", LONG_SEARCHES)
def test_a_search_of_too_many_terms_is_a_sentence(index, of):
    with pytest.raises(ThinPartError, match=f"20000 conditions, words and names, more than {MOST_TERMS}") as told:
        find_parts(index, part_query(**LONG_SEARCHES[of](20_000)))
    assert told.value.kind == "usage"


@pytest.mark.parametrize("of", LONG_SEARCHES)
def test_a_search_of_as_many_as_are_allowed_is_made(index, of):
    assert len(find_parts(index, part_query(**LONG_SEARCHES[of](MOST_TERMS)))) == (of != "said")


def test_words_that_are_not_utf_8_find_names_that_are_not(classified, library, tmp_path):
    name = os.fsdecode(b"\xfc.step.thinpart.json")
    (library / "plate.step.thinpart.json").rename(library / name)
    with LibraryIndex(library, tmp_path / "index") as opened:
        opened.refresh()
        assert len(find_parts(opened, part_query(words=os.fsdecode(b"\xfc.step")))) == 1
        assert not find_parts(opened, part_query(words=os.fsdecode(b"\xfc\xfc"), categories=[os.fsdecode(b"\xff")]))


@pytest.mark.parametrize("text", ['<XLink ', '<XLink file="', '<XLink file=', '>', 'file="a" ', '<XLink name=">" '])
def test_links_are_found_in_one_pass(text, tmp_path):
    path = tmp_path / "links.FCStd"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("Document.xml", text * MANY + '><XLink count="1" file="b&amp;c.FCStd"/>')
    assert tmp_path / "b&c.FCStd" in linked_files(path)


@pytest.mark.parametrize("named", ["Open CASCADE STEP translator 6.8 1", "NONE001", "solid_12", "=>[0:1:1:2]", "  ", "007"])
def test_what_nobody_named_has_the_name_of_what_is_around_it(named, freecad):
    assert _told(freecad, named) == "Around"


@pytest.mark.parametrize("named", ["Bracket", "None of these", "solid x", "Bracket 001",
                                   "Open CASCADE STEP translator" + "_" * MANY + "\nx"])
def test_other_names_are_told_whatever_their_length(named, freecad):
    assert _told(freecad, named) == named


def _told(freecad, label):
    """What an object of a label in an assembly is called."""
    document = freecad.newDocument("Named", hidden=True)
    try:
        top, leaf = document.addObject("App::Part", "Top"), document.addObject("Part::Feature", "Leaf")
        top.addObject(leaf)
        top.Label, leaf.Label = "Around", label
        return telling_label(top, "Leaf.", leaf)
    finally:
        freecad.closeDocument(document.Name)
