# SPDX-License-Identifier: LGPL-2.1-or-later
"""Answers of Dask workers: results of analyses, and nothing that only looks like them."""

import json
import os
import pickle

import made_meshes
import numpy as np
import pytest
from made_library import measured_record, record_of

from thinpart_workbench.core.forms.motion import Motion
from thinpart_workbench.core.forms.recorded_form import form_of_record
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.cluster.cluster_answer import (
    THREADS,
    VERSIONS,
    checked,
    response_from,
    software_from,
)
from thinpart_workbench.workflow.cluster.cluster_work import work_named
from thinpart_workbench.workflow.cluster.file_work import FILES
from thinpart_workbench.workflow.cluster.plain_pickles import PickleRefused, plain_pickles_only, texts_of_pickle
from thinpart_workbench.workflow.reuse.comparison_task import ComparedPart, ComparisonTask
from thinpart_workbench.workflow.reuse.comparison_work import COMPARISONS

TASK = FileTask("/here/a.step")

SOFTWARE = {"host": "anvil", "freecad": "1.1.0", "thinpart": "0.1.0", "python": "3.13.1"}
FAILURE = {"part": None, "label": "x", "kind": "no_solid", "message": "It is none."}
OUTCOME = {"file": "/share/a.step", "parts": [record_of("plate")], "failures": [FAILURE], "reused": False,
           "seconds": 0.5, "confinement": {"files": "landlock", "network": "seccomp"}}


def answer(outcome, software=SOFTWARE):
    return json.dumps({"software": software, "outcome": outcome if outcome is None else json.dumps(outcome)})



def test_a_result_comes_through():
    software, done = response_from(answer(OUTCOME), TASK, FILES.done)
    assert software == SOFTWARE and done == (TASK, {**OUTCOME, "file": TASK.file}, None, None)
    assert response_from(answer(None), TASK, FILES.done)[1] is None
    failed = {"file": "x", "error": {"kind": "timeout", "message": "It took long."}, "seconds": 3.0}
    assert response_from(answer(failed), TASK, FILES.done)[1] == (TASK, None, {**failed, "file": TASK.file}, None)


@pytest.mark.parametrize("change", [
    {"parts": None}, {"parts": [{}]}, {"parts": ["x"]}, {"failures": 3}, {"failures": [{"kind": 1, "message": ""}]},
    {"failures": [{"kind": "a", "message": "b"}]}, {"error": "x"}, {"error": {"kind": "x"}}, {"seconds": "x"},
    {"seconds": True}, {"confinement": {"files": 3}}])
def test_an_outcome_that_is_none_is_refused(change):
    with pytest.raises(ValueError):
        response_from(answer({**OUTCOME, **change}), TASK, FILES.done)


@pytest.mark.parametrize("change", [
    {"name": None}, {"label": ["x"]}, {"instances": "many"}, {"warnings": [3]},
    {"descriptors": {}}, {"descriptors": {**OUTCOME["parts"][0]["descriptors"], "box_mm": ["a", "b", "c"]}},
    {"margin": "large"}])
def test_a_part_that_is_none_is_refused(change):
    with pytest.raises(ValueError):
        response_from(answer({**OUTCOME, "parts": [{**OUTCOME["parts"][0], **change}]}), TASK, FILES.done)


@pytest.mark.parametrize("text", [None, 7, b"{}", "", "[]", "{", "{}", "[" * 100000, '{"software": {}, "outcome": null}',
                                  {"software": SOFTWARE, "outcome": None}])
def test_what_is_no_answer_is_refused(text):
    for read in (lambda text: response_from(text, TASK, FILES.done), software_from):
        with pytest.raises(ValueError):
            read(text)


def test_what_no_outcome_has_is_left_out():
    failed = {"file": "x", "error": {"kind": "timeout", "message": "It took long."}}
    _, done = response_from(answer({**failed, "parts": 7, "failures": [7]}), TASK, FILES.done)
    assert done.failure == {**failed, "file": TASK.file}


def test_versions_and_threads_come_through():
    entry = {"host": {"python": "3.13.1.final.0", "OS": "Linux"}, "packages": {}}
    versions = {"scheduler": entry, "workers": {"tcp://a:1": entry}, "client": entry}
    assert checked(VERSIONS, versions) == versions
    for threads in ({"tcp://a:1": 2, "tcp://b:1": 3}, {}):
        assert checked(THREADS, threads) == threads


@pytest.mark.parametrize("versions", [None, 7, [], {}, {"scheduler": None, "workers": {}},
                                      {"scheduler": {"host": {}}, "workers": {}},
                                      {"scheduler": {"host": {"python": 3}}, "workers": {}}, {"scheduler": 7, "workers": 7},
                                      {"scheduler": {"host": {"python": "3.13"}}, "workers": {"a": None}}])
def test_versions_that_are_none_are_refused(versions):
    with pytest.raises(ValueError):
        checked(VERSIONS, versions)


@pytest.mark.parametrize("threads", [None, 7, [], {"a": "x"}, {"a": -1}, {"a": None}, {7: 1}])
def test_threads_that_are_none_are_refused(threads):
    with pytest.raises(ValueError):
        checked(THREADS, threads)


class Program:
    def __init__(self, *calls):
        self.calls = calls

    def __reduce__(self):
        return self.calls


def test_pickles_of_programs_are_refused_and_read_as_text(tmp_path):
    ran = tmp_path / "ran"
    program = pickle.dumps({"result": Program(os.mkdir, (str(ran),))})
    plain = [1, 2.5, "x", b"y", {"z": (None, True)}, {1, 2}, bytearray(b"q"), frozenset("a")]
    with plain_pickles_only():
        with pytest.raises(PickleRefused, match="mkdir"):
            pickle.loads(program)
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            if protocol > 2:  # before, bytes are written as a call of a codec
                assert pickle.loads(pickle.dumps(plain, protocol)) == plain
    assert not ran.exists()
    assert {"mkdir", str(ran)} <= set(texts_of_pickle(program))
    assert texts_of_pickle(b"no pickle") == [] and texts_of_pickle(program[:-20])[:1] == ["result"]
    pickle.loads(program)
    assert ran.exists()


def comparison():
    """A task whose forms are as an index has them."""
    form = form_of_record(measured_record("plate", made_meshes.box(100, 60, 2)))
    other = form_of_record(measured_record("tube", made_meshes.tube()))
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    return ComparisonTask(ComparedPart("/here/a.step", "0" * 64, "Solid1", form),
                          ComparedPart(os.fsdecode(b"/here/caf\xe9.step"), "1" * 64, "Solid2", other),
                          (Motion(turn), Motion(-turn, 25.4, np.array([1e-3, 2.0, -0.1]))))


def values(task):
    """All that a comparison is made from, bit by bit."""
    return [task.key, *((part.file, part.name, *map(np.asarray, (*part.form.moments, *part.form.outline)))
                        for part in (task.part, task.reference)), *map(tuple, task.motions)]


def test_a_comparison_reaches_a_worker_as_it_is():
    task = comparison()
    there = COMPARISONS.task(json.loads(json.dumps(COMPARISONS.content(task))))
    np.testing.assert_equal(values(there), values(task))
    assert COMPARISONS.files(task) == ["/here/a.step", os.fsdecode(b"/here/caf\xe9.step")]


SIDE = {"share": 1.0, "greatest_mm": 0.1, "points": 3, "faces": []}
COMPARED = {"are_solids": True, "extent_mm": 10.0, "motion": 1, "part": SIDE, "reference": SIDE}


def test_an_answer_to_a_comparison_is_checked():
    task = comparison()
    assert response_from(answer(COMPARED), task, COMPARISONS.done)[1] == (task, COMPARED, None, None)
    failed = {"file": "/etc/passwd", "error": {"kind": "missing", "message": "It is gone."}}
    _, done = response_from(answer(failed), task, COMPARISONS.done)
    assert done.result is None and done.failure == {**failed, "file": task.file}
    for wrong in ({**COMPARED, "motion": 2}, {**COMPARED, "part": None}, {}, [], "x", OUTCOME):
        with pytest.raises(ValueError):
            response_from(answer(wrong), task, COMPARISONS.done)


@pytest.mark.parametrize("work", [FILES, COMPARISONS])
def test_a_worker_finds_the_work_by_its_name(work):
    assert work_named(work.name) is work
