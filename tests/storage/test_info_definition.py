# SPDX-License-Identifier: LGPL-2.1-or-later
"""The definition of info files, their JSON schema, and files of other versions."""

import json
import os

import made_library
import pytest
from program import SCHEMA

from thinpart_workbench.api.annotations import annotate_part, mesh_settings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.storage.info import info_file
from thinpart_workbench.storage.info.info_definition import json_schema
from thinpart_workbench.storage.info.info_reading import read_info


def test_the_schema_is_made_of_the_definition():
    assert SCHEMA == json.loads(json.dumps(json_schema())), (
        "python3 -m thinpart_workbench.storage.info.info_definition > resources/info-file.schema.json")


@pytest.fixture
def info(tmp_path):
    failure = {"part": "Solid3", "label": "x", "kind": "no_solid", "message": "x bounds no solid."}
    return made_library.store(tmp_path, "a.step", [made_library.record_of("ribbed_block")], [failure])


def change(info, **changes):
    content = json.loads(info.read_bytes())
    content.update(changes)
    info.write_text(json.dumps(content))
    return content


def test_an_earlier_version_has_fewer_keys(info):
    content = change(info, failures=[{"part": "Solid3", "kind": "no_solid", "message": "x bounds no solid."}])
    assert read_info(info) == content
    del content["failures"]
    info.write_text(json.dumps(content))
    assert read_info(info) == content


def test_keys_of_a_later_version_are_kept(info):
    part = {**made_library.record_of("plate"), "mass_kg": 2.5}
    content = change(info, parts=[part], made_by={"machine": "x", "steps": [1, None]})
    annotate_part(info, notes="mine")
    part["notes"] = "mine"
    assert read_info(info) == {**content, "parts": [part]}


def test_a_mark_at_the_start_that_editors_put_there(info):
    info.write_bytes(b"\xef\xbb\xbf" + info.read_bytes())
    assert read_info(info)["parts"][0]["name"] == "Solid1"


def test_names_whose_bytes_are_no_text(tmp_path):
    name = os.fsdecode(b"caf\xe9.step")
    info = made_library.store(tmp_path, name, [made_library.record_of("plate", label=name)])
    assert read_info(info)["source"]["file"] == name
    annotate_part(info, notes=name, link=name)
    assert read_info(info)["parts"][0]["link"] == name


@pytest.mark.parametrize("text", ['{"a": 1e999}', '{"a": NaN}', '{"a": "\\ud800"}', '{"\\ud800": 1}',
                                  '{"a": ' + "[" * 100 + "]" * 100 + "}", "[" * 100_000])
def test_mesh_settings_that_could_not_be_read_again_are_refused(text):
    with pytest.raises(ThinPartError) as failure:
        mesh_settings(text if text.startswith("{") else '{"a": ' + text)
    assert failure.value.kind == "usage"


def test_what_could_not_be_read_again_is_not_written(info):
    before = info.read_bytes()

    def spoil(content):
        content["parts"][0]["label"] = "\ud800"
        return True

    with pytest.raises(ThinPartError, match=r"not written: parts\[0\].label is") as failure:
        info_file.change_info(info, spoil)
    assert failure.value.kind == "info_write" and info.read_bytes() == before
