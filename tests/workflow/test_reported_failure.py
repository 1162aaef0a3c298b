# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker tells of an exception."""

import pytest

from thinpart_workbench.core.errors import KINDS, ThinPartError
from thinpart_workbench.core.problem import UNEXPECTED
from thinpart_workbench.workflow.workers.reported_failure import reported_failure


def raised(error):
    try:
        raise error
    except Exception as caught:
        return caught


def test_a_failure_with_a_sentence_of_its_own_is_that(capfd):
    error = raised(ThinPartError("plate.step is empty (0 bytes).", "empty"))
    assert reported_failure(error, "plate.step") == {"kind": "empty", "message": "plate.step is empty (0 bytes)."}
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize("error", [
    MemoryError(), RuntimeError("std::bad_alloc"), Exception("Unable to allocate 3 GiB"), OSError("bad allocation"),
])
def test_a_lack_of_memory_is_told_whatever_class_it_has(error, capfd):
    assert reported_failure(raised(error), "Rib") == {
        "kind": "memory", "message": "Rib needs more memory than the limit allows."}
    assert reported_failure(raised(error))["message"] == "There is not enough memory for this."
    assert capfd.readouterr().err == ""


def test_what_nobody_foresaw_is_one_sentence_and_its_traceback_goes_to_the_log(capfd):
    assert reported_failure(raised(KeyError("x")), "Rib") == {"kind": "failed", "message": f"Rib failed ({UNEXPECTED})."}
    assert reported_failure(raised(KeyError("x")))["message"] == f"The worker process failed ({UNEXPECTED})."
    log = capfd.readouterr().err
    assert log.count("Traceback") == log.count("KeyError: 'x'") == 2 and "failed" in KINDS
