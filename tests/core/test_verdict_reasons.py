# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why a part is unknown is told again from its record, as a message."""

import json

import made_library
import pytest

from thinpart_workbench.core.judging.verdict_reasons import reason_of
from thinpart_workbench.core.message import Message


def stored(record):
    """A record as it comes from an info file that says nothing of what its sentences are made of."""
    return json.loads(json.dumps(record))


@pytest.fixture
def unknown():
    return made_library.record_of("open_box")


def test_a_stored_reason_is_told_anew(unknown):
    told = reason_of(stored(unknown))
    assert isinstance(told, Message) and told == unknown["reason"] and "criteria" in told.fields
    assert told.fields == unknown["reason"].fields


def test_that_of_a_part_too_slender_to_be_measured(unknown):
    from thinpart_workbench.core.judging.classification import too_fine_reason
    from thinpart_workbench.core.record.part_record import descriptors_of

    slender = stored(unknown)
    slender["descriptors"]["thickness_mm"].update(min=0.1, error_bound=0.03)
    slender["reason"] = str.__str__(too_fine_reason(descriptors_of(slender).length_error))
    told = reason_of(slender)
    assert isinstance(told, Message) and told == slender["reason"] and "mm" in told.fields


def test_what_another_version_said_stays(unknown):
    record = {**stored(unknown), "reason": "Nobody knows."}
    assert reason_of(record) == "Nobody knows." and not isinstance(reason_of(record), Message)
    assert reason_of({**record, "reason": ""}) == ""


def test_a_verdict_in_short_keeps_its_reason(unknown):
    assert reason_of({"reason": unknown["reason"]}) is unknown["reason"]
    assert reason_of({"reason": "x"}) == "x"
